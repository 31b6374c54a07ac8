#include "integral_cases.hpp"

#include "base/number.hpp"

namespace test {

namespace {

Vec2 mean_slope(Draw& draw) {
  return draw.chance(0.2) ? Vec2{draw.between(-0.4, 0.4), draw.between(-0.4, 0.4)} : Vec2{0, 0};
}

ModelChoice stretched(Draw& draw, const Vec2& mean) {
  const std::string type =
      draw.one_of<std::string>({"beckmann", "ggx", "beckmann", "ggx", "student_t", "exponential_power"});
  const double alpha = draw.log_between(0.002, 5), ratio = draw.chance(0.6) ? draw.log_between(0.01, 100) : 1;
  const double alpha_y = std::clamp(alpha * ratio, 0.002, 5.0);
  const double correlation = draw.chance(0.4) ? draw.between(-0.99, 0.99) : 0;
  ModelChoice choice = general(type, alpha, alpha_y, correlation, mean).distribution;
  if (type == "student_t") choice.values.set("gamma", 1.5 + draw.log_between(0.2, 40));
  if (type == "exponential_power") choice.values.set("p", draw.log_between(0.3, 4));
  return choice;
}

ModelChoice isotropic(Draw& draw) {
  const std::string type = draw.one_of<std::string>({"phong", "gtr", "velvet", "sheen", "ward", "gaussian"});
  ModelChoice choice = describe(type, draw.log_between(0.002, 5)).distribution;
  if (type == "phong") choice.values.set("alpha", draw.log_between(0.002, 1.3));
  if (type == "sheen" || type == "velvet") choice.values.set("alpha", draw.log_between(0.02, 5));
  if (type == "gtr") choice.values.set("gamma", draw.between(0.4, 6));
  return choice;
}

ModelChoice distribution(Draw& draw) {
  const double kind = draw.between(0, 1);
  if (kind < 0.3) return isotropic(draw);
  const Vec2 mean = mean_slope(draw);
  if (kind < 0.8) return stretched(draw, mean);
  WeightedChoices parts;
  const int count = draw.chance(0.7) ? 2 : 3;
  const bool centred = mean[0] == 0 && mean[1] == 0;
  for (int k = 0; k < count; ++k)
    parts.push_back({draw.log_between(0.05, 1), centred && draw.chance(0.3) ? isotropic(draw) : stretched(draw, mean)});
  return mixture(parts).distribution;
}

/// A mixture of parts that are inclined each in a way of its own, as averaged normals are.
ModelChoice of_several_mesosurfaces(Draw& draw) {
  WeightedChoices parts;
  const int count = draw.chance(0.7) ? 2 : 3;
  for (int k = 0; k < count; ++k) {
    const double alpha = draw.log_between(0.1, 2), ratio = draw.chance(0.5) ? draw.log_between(0.3, 3) : 1;
    const Vec2 mean = {draw.between(-0.8, 0.8), draw.between(-0.8, 0.8)};
    const std::string type = draw.one_of<std::string>({"beckmann", "ggx", "student_t"});
    ModelChoice part =
        general(type, alpha, alpha * ratio, draw.chance(0.4) ? draw.between(-0.8, 0.8) : 0, mean).distribution;
    if (type == "student_t") part.values.set("gamma", 1.5 + draw.log_between(0.5, 10));
    parts.push_back({draw.log_between(0.1, 1), part});
  }
  return mixture(parts).distribution;
}

/// A shape as users write it, half of the time; else a distribution of the list.
ModelChoice shape_formula(Draw& draw) {
  if (draw.chance(0.5)) return distribution(draw);
  const double alpha = draw.log_between(0.05, 3), ratio = draw.chance(0.4) ? draw.log_between(0.1, 10) : 1;
  ModelChoice choice =
      general("custom", alpha, alpha * ratio, draw.chance(0.3) ? draw.between(-0.9, 0.9) : 0, mean_slope(draw))
          .distribution;
  choice.values.set("shape", draw.one_of<std::string>({
                                 "exp(-t2)",
                                 "1 / (1 + t2)^3",
                                 "exp(-t)",
                                 "t2 * exp(-t2^1.1)",
                                 "exp(-t2) + 0.01 * exp(-t2 / 30)",
                                 "exp(-t2) * (1 + 0.9 * sin(6 * t))",
                                 "max(0, 1 - t2)",
                                 "max(exp(-t2), 0.1 * exp(-t2 / 9))",
                                 "t2 < 1 ? 1 : 0",
                             }));
  return choice;
}

ModelChoice fresnel(Draw& draw) {
  ModelChoice choice{.type = draw.one_of<std::string>({"none", "none", "schlick", "dielectric", "conductor"}),
                     .values = {}};
  if (choice.type == "schlick") choice.values.set("f0", draw.between(0, 1));
  if (choice.type == "dielectric")
    choice.values.set("eta", draw.chance(0.5) ? draw.between(1.05, 3) : draw.between(0.3, 0.97));
  if (choice.type == "conductor") {
    choice.values.set("eta", draw.log_between(0.05, 4));
    choice.values.set("k", draw.log_between(0.01, 6));
  }
  return choice;
}

std::string describe_choice(const ModelChoice& choice) {
  std::string text = choice.type;
  for (const auto& [key, value] : choice.values.map()) {
    text += " " + key + "=";
    if (const auto* number = std::get_if<double>(&value)) text += format_number(*number);
    if (const auto* pair = std::get_if<Vec2>(&value))
      text += format_number((*pair)[0]) + "," + format_number((*pair)[1]);
    if (const auto* word = std::get_if<std::string>(&value)) text += *word;
    if (const auto* parts = std::get_if<WeightedChoices>(&value))
      for (const auto& part : *parts)
        text += "[" + format_number(part.weight) + " " + describe_choice(part.model) + "]";
  }
  return text;
}

} // namespace

namespace {

ModelChoice masking(Draw& draw, const ModelChoice& distribution) {
  std::vector<std::string> maskings = {"smith",    "smith",          "smith",
                                       "v_cavity", "smith_rational", "implicit",
                                       "kelemen",  "schlick_smith",  "schlick_smith_rational"};
  if (distribution.type == "sheen") maskings.insert(maskings.end(), 4, "sheen_fit");
  if (distribution.type == "student_t") maskings.insert(maskings.end(), 4, "student_t_fit");
  return {.type = draw.one_of(maskings), .values = {}};
}

/// A formula of Lambda or of G1 as users write them: copied from renderers, invented, with jumps and corners.
ModelChoice masking_formula(Draw& draw, const ModelChoice&) {
  ModelChoice choice{.type = "custom", .values = {}};
  if (draw.chance(0.5))
    choice.values.set("lambda", draw.one_of<std::string>({
                                    "(sqrt(1 + alpha^2 * tan_theta^2) - 1) / 2",
                                    "(sqrt(1 + alpha_x * alpha_y * tan_theta^2) - 1) / 2",
                                    "a < 1.6 ? (1 - 1.259 * a + 0.396 * a^2) / (3.535 * a + 2.181 * a^2) : 0",
                                    "0.3 * tan_theta",
                                    "exp(-a) / (2 * a)",
                                    "max(0, tan_theta - 0.5)",
                                    "theta > 1 ? tan_theta : 0.2 * tan_theta",
                                    "0.3 * (1 + cos(phi)) * tan_theta",
                                }));
  else
    choice.values.set("g1", draw.one_of<std::string>({
                                "min(1, 2 * cos_theta_m * cos_theta / o_dot_m)",
                                "min(1, cos_theta / o_dot_m)",
                                "1 / (1 + 0.5 * tan_theta)",
                                "2 * cos_theta / (cos_theta + sqrt(alpha^2 + (1 - alpha^2) * cos_theta^2))",
                                "cos_theta / (cos_theta * (1 - alpha / 2) + alpha / 2)",
                                "o_dot_m * cos_theta^0.25",
                                "min(cos_theta, cos_theta_m)",
                                "1 - abs(cos_theta - cos_theta_m)",
                                "theta < 0.7 ? 1 : 0.8 * cos_theta",
                            }));
  return choice;
}

std::optional<IntegralCase> case_of(std::uint64_t number, ModelChoice (*distribution_of)(Draw&),
                                    ModelChoice (*masking_of)(Draw&, const ModelChoice&) = masking) {
  Draw draw(number);
  TermDescription description;
  description.distribution = distribution_of(draw);
  description.masking = masking_of(draw, description.distribution);
  const std::string shadowing = draw.one_of<std::string>(
      {"none", "separable", "minimum", "height_correlated", "direction_correlated", "height_direction_correlated"});
  const std::string factor = shadowing.find("direction") != std::string::npos
                                 ? draw.one_of<std::string>({"ashikhmin", "ginneken", "fitted"})
                                 : "";
  description = shadowed(description, shadowing, factor);
  description.fresnel = fresnel(draw);
  const double theta = draw.chance(0.08)   ? 0
                       : draw.chance(0.15) ? draw.one_of<double>({89.99, 89.9, 89}) * degree
                                           : draw.between(0, 89.9) * degree;
  const Direction o = from_angles(theta, draw.between(0, 6.3));
  const Integral integral = draw.one_of<Integral>(
      {Integral::albedo, Integral::albedo, Integral::albedo, Integral::albedo, Integral::albedo, Integral::furnace,
       Integral::furnace, Integral::projected_area, Integral::visible_norm, Integral::weak_furnace});
  const double tolerance = draw.log_between(1e-9, 1e-4);
  try {
    const Material material = build(description);
    if (!(material.surface().slopes().project(o).c > 0)) return {};
    std::string text = "case " + std::to_string(number) + ": " + describe_choice(description.distribution) + " | " +
                       describe_choice(description.masking) + " | " + shadowing + " " + factor + " | " +
                       describe_choice(description.fresnel) + " | theta_o=" + format_number(theta / degree) +
                       "deg o=" + format_number(o.x) + "," + format_number(o.y) + "," + format_number(o.z) + " | " +
                       integrals()[static_cast<std::size_t>(integral)].name + " tolerance " + format_number(tolerance);
    return IntegralCase{text, material, o, integral, tolerance};
  } catch (const MaterialError&) {
    return {}; // a pair of models that is refused
  }
}

} // namespace

std::optional<IntegralCase> random_case(std::uint64_t number) { return case_of(number, distribution); }

std::optional<IntegralCase> random_tilted_case(std::uint64_t number) {
  return case_of(number, of_several_mesosurfaces);
}

std::optional<IntegralCase> random_formula_case(std::uint64_t number) {
  return case_of(number, shape_formula, number % 3 == 0 ? masking : masking_formula);
}

namespace {

/// The frame of a component, about the mean slope of the whole: its normal is one of those that face the viewer and
/// reflect it above the horizon, which that of a component need not be.
SlopeMap about_mesosurface(const Component& component) {
  SlopeMap map = component.frame;
  map.mean_x = component.mesosurface[0];
  map.mean_y = component.mesosurface[1];
  return map;
}

Direction mirrored_at(const Direction& o, const Direction& h) {
  const double along = 2 * dot(o, h);
  return {along * h.x - o.x, along * h.y - o.y, along * h.z - o.z};
}

struct Arrays {
  std::vector<double> x, y, z;
  void resize(std::size_t n) {
    for (auto* column : {&x, &y, &z}) column->resize(n);
  }
  void set(std::size_t k, const Direction& d) {
    x[k] = d.x;
    y[k] = d.y;
    z[k] = d.z;
  }
  Columns view() const { return {x.data(), y.data(), z.data()}; }
};

/// Pairs of directions and facets, kept from one call to the next.
struct Pairs {
  Arrays o, i, m;
  void resize(std::size_t n) {
    for (auto* arrays : {&o, &i, &m}) arrays->resize(n);
  }
};

/// The integrand of a case, per solid angle of the facet.
FacetFunction integrand(const IntegralCase& one, const Component& component, bool several) {
  const bool lit = one.integral == Integral::albedo || one.integral == Integral::furnace;
  Material material = one.material;
  if (one.integral == Integral::furnace) std::get<Mirror>(material.terms[0].term).fresnel = NoFresnel{};
  const double whole = material.surface().has_lambda()
                           ? g1(material, one.o) / material.surface().slopes().project(one.o).c
                           : 0; // G1 / c
  return [&one, &component, material, several, lit, whole, pairs = Pairs()](const std::vector<Direction>& facets,
                                                                            std::vector<double>& values) mutable {
    const std::size_t n = facets.size();
    auto& [o, i, m] = pairs;
    pairs.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      o.set(k, one.o);
      if (lit) i.set(k, mirrored_at(one.o, facets[k]));
      m.set(k, facets[k]);
    }
    // With a Lambda, masking is one number.
    const Quantity quantity = lit ? Quantity::brdf_cos : whole > 0 ? Quantity::d : Quantity::d_visible;
    evaluate(material, quantity, {n, o.view(), lit ? i.view() : Columns{}, lit ? Columns{} : m.view()}, values.data());
    for (std::size_t k = 0; k < n; ++k) {
      if (lit) values[k] *= 4 * std::max(0.0, dot(one.o, facets[k]));
      if (quantity == Quantity::d) values[k] *= whole * std::max(0.0, dot(one.o, facets[k]));
      if (!several || values[k] == 0) continue;
      const double all =
          std::visit([&](const auto& d) { return d.density(facets[k]); }, material.surface().distribution);
      values[k] *= all > 0 ? component.density(facets[k]) / all : 0; // both of them where they underflow
    }
  };
}

} // namespace

RayIntegral truth_of(const IntegralCase& one, double of_tolerance) {
  const bool lit = one.integral == Integral::albedo || one.integral == Integral::furnace;
  const SlopeMap& mesosurface = one.material.surface().slopes();
  const auto inside = [&](const Direction& facet) {
    return dot(one.o, facet) > 0 && (!lit || mesosurface.project(mirrored_at(one.o, facet)).c > 0);
  };
  const auto parts = components(one.material.surface().distribution);
  const auto* dielectric = std::get_if<DielectricFresnel>(one.material.terms[0].fresnel());
  const bool critical = one.integral == Integral::albedo && dielectric != nullptr && dielectric->eta[0] < 1;
  // A kink where a panel and its halves agree by accident does so on every ray of what is isotropic, and again where
  // the same panels are finer: other ones for a second opinion.
  const int panels = of_tolerance < 1 ? 7 : critical ? 6 : 1;
  RayIntegral sum;
  for (const Component& component : parts) {
    const RayIntegral part =
        integrate_rays(about_mesosurface(component), one.o, inside, integrand(one, component, parts.size() > 1),
                       of_tolerance * one.tolerance / static_cast<double>(parts.size()), panels);
    sum.value += part.value;
    sum.doubt += part.doubt;
    sum.evaluations += part.evaluations;
  }
  if (one.integral == Integral::projected_area) {
    sum.value *= mesosurface.project(one.o).c;
    sum.doubt *= mesosurface.project(one.o).c;
  }
  return sum;
}

RayIntegral diffuse_truth(const Material& material, const Direction& o, const Direction& i, double tolerance,
                          double about, int parts) {
  const double c_o = material.surface().slopes().project(o).c, c_i = material.surface().slopes().project(i).c;
  const auto inside = [&](const Direction& facet) { return dot(o, facet) > 0 && dot(i, facet) > 0; };
  RayIntegral sum;
  for (const Component& component : components(material.surface().distribution)) {
    const FacetFunction f = [&, pairs = Pairs()](const std::vector<Direction>& facets,
                                                 std::vector<double>& values) mutable {
      auto& [os, is, ms] = pairs;
      pairs.resize(facets.size());
      for (std::size_t k = 0; k < facets.size(); ++k) {
        os.set(k, o);
        is.set(k, i);
        ms.set(k, facets[k]);
      }
      evaluate(material, Quantity::g2, {facets.size(), os.view(), is.view(), ms.view()}, values.data());
      for (std::size_t k = 0; k < facets.size(); ++k)
        values[k] *= std::max(0.0, dot(o, facets[k])) * std::max(0.0, dot(i, facets[k])) *
                     component.density(facets[k]) / (std::numbers::pi * c_o * c_i);
    };
    const RayIntegral part = integrate_rays(about_mesosurface(component), o, inside, f, tolerance * about, parts);
    sum.value += part.value;
    sum.doubt += part.doubt;
  }
  return sum;
}

} // namespace test
