#include "analysis/fit/target.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/parallel.hpp"
#include "brdf/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>

namespace brdfplot {

namespace {

struct Swept {
  std::string type;
  FitParameter parameter;
  FitAlpha alpha;
  double (*given)(const Distribution& distribution); ///< the parameter of one
};

/// The ends of y, 0 and 1, are those of the domain.
std::optional<Swept> swept_parameter(const std::string& type) {
  const std::vector<Swept> all = {
      {"phong",
       {"exponent", 0, infinity, true, 2, 0, 2},
       FitAlpha::root_of_y,
       [](const Distribution& d) { return std::get<Phong>(d).profile.exponent; }},
      {"gtr",
       {"alpha", 0.05, 1, false, 0, -0.05 / 0.95, 1 / 0.95},
       FitAlpha::parameter,
       [](const Distribution& d) { return std::get<Gtr>(d).profile.lobe.alpha; }},
      {"student_t",
       {"gamma", 1.75, infinity, true, -1, 0, 0.75},
       FitAlpha::argument,
       [](const Distribution& d) { return std::get<StudentT>(d).shape.gamma; }},
  };
  const auto found = std::ranges::find(all, type, &Swept::type);
  return found == all.end() ? std::nullopt : std::optional<Swept>(*found);
}

/// Lambda at a = cot theta / alpha in the plane of the x axis.
double lambda_of(const Microsurface& surface, double a) {
  const double cot_theta = a * surface.slopes().alpha_x;
  const double norm = std::hypot(1.0, cot_theta);
  const double lambda =
      evaluate(surface, Quantity::lambda, Direction{1 / norm, 0, cot_theta / norm}, std::nullopt, std::nullopt);
  if (!is_told(Quantity::lambda, lambda))
    throw AccuracyError("", "\"lambda\": found " + format_number(lambda) + " at a = " + format_number(a));
  return lambda;
}

Microsurface unit_surface(const MicrosurfaceDescription& description, bool shape_invariant) {
  Microsurface surface = build_microsurface(description);
  if (shape_invariant) std::visit([](auto& d) { d.slopes = SlopeMap{}; }, surface.distribution);
  return surface;
}

void require_lambda(const MicrosurfaceDescription& description, const Microsurface& surface, bool shape_invariant) {
  const SlopeMap& map = surface.slopes();
  if (!surface.has_lambda())
    throw MaterialError("/masking/type", "found \"" + description.masking.type +
                                             "\", which has no Lambda to fit; accepted: a masking function that has");
  if (!shape_invariant && !(map.centred() && map.alpha_x == map.alpha_y && map.correlation == 0))
    throw MaterialError("/distribution", "its Lambda depends on the azimuth by more than a roughness; accepted by fit: "
                                         "isotropic ones, and shape-invariant ones of any anisotropy and slope");
}

/// A formula of the user must be a function of what the fit is one of.
void require_formula(const MicrosurfaceDescription& description, bool shape_invariant) {
  if (description.masking.type != "custom") return;
  const std::string text = description.masking.values.text("lambda");
  static const std::regex word("[A-Za-z_][A-Za-z_0-9]*");
  const std::vector<std::string> of_direction =
      shape_invariant ? std::vector<std::string>{"theta", "phi",     "cos_theta", "tan_theta",
                                                 "alpha", "alpha_x", "alpha_y",   "correlation"}
                      : std::vector<std::string>{"phi"};
  for (auto at = std::sregex_iterator(text.begin(), text.end(), word); at != std::sregex_iterator(); ++at)
    if (std::ranges::find(of_direction, at->str()) != of_direction.end())
      throw MaterialError("/masking/lambda", "found a formula of \"" + at->str() + "\"; accepted by fit: " +
                                                 (shape_invariant ? "one of \"a\" alone" : "one without \"phi\""));
}

/// The value that the file gives must be one that the code can be called with.
void require_in_domain(const MicrosurfaceDescription& description, const Swept& swept,
                       const Distribution& distribution) {
  const FitParameter& parameter = swept.parameter;
  const double value = swept.given(distribution);
  if (parameter.contains(value)) return;
  const Values& given = description.distribution.values;
  const std::vector<std::string> keys = {parameter.key, "alpha", "roughness"};
  const std::string key = *std::ranges::find_if(keys, [&](const std::string& k) { return given.has(k); });
  const std::string found = format_number(given.number(key));
  throw MaterialError("/distribution/" + key,
                      "found " + found +
                          (key == parameter.key ? "" : " (" + parameter.key + " = " + format_number(value) + ")") +
                          "; accepted by fit: " + parameter.domain() +
                          ", since its code takes every such value as an argument, or any with --fixed, which fits "
                          "this one value");
}

/// The form of shadowing, of which the code must know how to write it.
void set_shadowing(const MicrosurfaceDescription& description, FitTarget& target) {
  if (!description.shadowing) return;
  target.shadowing = description.shadowing->type;
  const std::vector<std::string> with_factor = {"direction_correlated", "height_direction_correlated"};
  const std::vector<std::string> without = {"none", "separable", "minimum", "height_correlated"};
  const auto in = [&](const auto& names) { return std::ranges::find(names, target.shadowing) != names.end(); };
  if (in(without)) return;
  if (!in(with_factor))
    throw MaterialError("/shadowing/type",
                        "found \"" + target.shadowing +
                            "\", of which fit writes no code; accepted by fit: none, separable, minimum, "
                            "height_correlated, direction_correlated, height_direction_correlated");
  target.factor = description.shadowing->values.text("lambda");
  if (target.factor != "ashikhmin" && target.factor != "ginneken")
    throw MaterialError("/shadowing/lambda",
                        "found \"" + target.factor +
                            "\", of which fit writes no code; accepted by fit: ashikhmin, ginneken");
}

/// Where Lambda is 1, about: the a around which samples are spread.
double middle(const std::function<double(double)>& lambda) {
  double low = 1e-9;
  double high = 1e9;
  for (int step = 0; step < 60; ++step) {
    const double a = std::sqrt(low * high);
    (lambda(a) > 1 ? low : high) = a;
  }
  return std::sqrt(low * high);
}

/// The numbers and formulas among the given parameters that are no arguments of the fit.
std::string constants_of(const ModelChoice& distribution, const FitTarget& target) {
  const std::vector<std::string> of_slopes = {"alpha",       "alpha_x",           "alpha_y",
                                              "roughness",   "disney_anisotropy", "imageworks_anisotropy",
                                              "correlation", "mean_slope"};
  std::string out;
  for (const auto& [key, value] : distribution.values.map()) {
    if (target.parameter && (target.parameter->key == key || target.alpha == FitAlpha::root_of_y)) continue;
    if (target.alpha == FitAlpha::argument && std::ranges::find(of_slopes, key) != of_slopes.end()) continue;
    const double* number = std::get_if<double>(&value);
    const std::string* text = std::get_if<std::string>(&value);
    if (number || text) out += (out.empty() ? "" : ", ") + key + " = " + (number ? format_number(*number) : *text);
  }
  return out;
}

} // namespace

std::string FitParameter::domain() const {
  return key + (to < infinity ? " in [" + format_number(from) + ", " + format_number(to) + "]"
                              : " >= " + format_number(from));
}

double FitParameter::y(double value) const { return offset + factor * (reciprocal ? 1 / (value + shift) : value); }

double FitParameter::value(double y) const {
  const double q = (y - offset) / factor;
  if (!reciprocal) return std::clamp(q, from, to);
  // The limit at infinity is approached like 1 / parameter: this near to it, the difference is no more seen.
  constexpr double largest = 1e7;
  return std::clamp(q > 0 ? 1 / q - shift : largest, from, std::min(to, largest));
}

namespace {

FitTarget target_of(const std::string& name, const TermDescription& description, bool fixed) {
  FitTarget target{
      .name = name, .type = description.distribution.type, .masking = description.masking.type, .lambda_at = {}};
  const Microsurface given = build_microsurface(description);
  const bool shape_invariant = std::visit([](const auto& d) { return d.shape_invariant; }, given.distribution);
  require_lambda(description, given, shape_invariant);
  require_formula(description, shape_invariant);
  set_shadowing(description, target);
  target.slopes = given.slopes();
  const auto swept = fixed ? std::nullopt : swept_parameter(target.type);
  if (swept) {
    require_in_domain(description, *swept, given.distribution);
    target.parameter = swept->parameter;
    target.alpha = swept->alpha;
    target.constants = constants_of(description.distribution, target);
    target.lambda_at = [description, shape_invariant, parameter = swept->parameter](double y) {
      TermDescription changed = description;
      set_parameter(changed, parameter.key, parameter.value(y));
      return [surface = unit_surface(changed, shape_invariant)](double a) { return lambda_of(surface, a); };
    };
    return target;
  }
  const Microsurface surface = unit_surface(description, shape_invariant);
  target.alpha = shape_invariant ? FitAlpha::argument : FitAlpha::constant;
  target.alpha_value = surface.slopes().alpha_x;
  target.constants = constants_of(description.distribution, target);
  target.lambda_at = [surface](double) { return [surface](double a) { return lambda_of(surface, a); }; };
  return target;
}

} // namespace

FitTarget fit_target(const MaterialDescription& description, bool fixed) {
  const std::size_t index = term_with_surface(description);
  try {
    return target_of(description.name, description.terms[index], fixed);
  } catch (const MaterialError& error) {
    throw MaterialError(pointer_of_term(description, index) + error.pointer(), error.reason());
  }
}

FitSamples sample(const FitTarget& target, std::size_t per_line, std::size_t lines, int threads) {
  const double unit = middle(target.lambda_at(0.5));
  FitSamples out{per_line, std::vector<FitSample>(per_line * lines)};
  const auto place = [](double k, double n) { return 0.5 - 0.5 * std::cos(std::numbers::pi * k / n); };
  parallel_for(lines, threads, [&](std::size_t line) {
    const double y = lines > 1 ? place(static_cast<double>(line), static_cast<double>(lines - 1)) : 0;
    const auto lambda = target.lambda_at(y);
    for (std::size_t i = 0; i < per_line; ++i) {
      const double t = place(static_cast<double>(i) + 0.5, static_cast<double>(per_line));
      const double a = unit * t / (1 - t);
      out.samples[line * per_line + i] = {a, y, lambda(a)};
    }
  });
  return out;
}

} // namespace brdfplot
