#include "figure/series/term.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

namespace {

using namespace brdfplot;
using plot::Setting;
using plot::Term;

constexpr double pi = std::numbers::pi;

double value(const std::string& quantity, const TermDescription& material, const std::vector<Setting>& at) {
  return plot::TermFunction({quantity, material, at}, {}, 1e-9)({}).at(0);
}

/// Random anisotropic, correlated, non-centred materials and configurations.
class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double log_in(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }

  TermDescription material(const std::string& type, const std::string& masking = "smith") {
    TermDescription out;
    out.name = "random";
    out.distribution.type = type;
    out.masking.type = masking;
    out.distribution.values.set("alpha_x", log_in(0.05, 2));
    out.distribution.values.set("alpha_y", log_in(0.05, 2));
    out.distribution.values.set("correlation", in(-0.9, 0.9));
    out.distribution.values.set("mean_slope", Vec2{in(-0.4, 0.4), in(-0.4, 0.4)});
    return out;
  }
  std::vector<Setting> directions() {
    return {{"theta_o", in(0.01, 1.2)}, {"phi_o", in(-pi, pi)}, {"theta_m", in(0, 0.8)}, {"phi_m", in(-pi, pi)}};
  }

private:
  std::mt19937 engine_;
};

std::vector<Setting> with(std::vector<Setting> at, const std::vector<Setting>& more) {
  at.insert(at.end(), more.begin(), more.end());
  return at;
}

/// The largest relative change of a quantity under transformations of the whole configuration.
double largest_change(const std::string& quantity, const std::string& type, const std::string& masking,
                      const std::function<std::vector<Setting>(Random&)>& transformation) {
  Random random(7);
  double worst = 0;
  int compared = 0;
  for (int k = 0; k < 300; ++k) {
    const auto material = random.material(type, masking);
    const auto at = random.directions();
    const auto more = transformation(random);
    const double before = value(quantity, material, at);
    const double after = value(quantity, material, with(at, more));
    // Below the horizon of the mesosurface there is nothing to compare, but it has to be so for both.
    if (!std::isfinite(before) || before == 0) {
      CHECK(before == after);
      continue;
    }
    ++compared;
    // Subnormal numbers have no more than their absolute accuracy.
    worst = std::max(worst, std::fabs(after - before) / (before + 1e-290));
  }
  CHECK(compared > 150);
  return worst;
}

std::vector<Setting> stretch(Random& random) {
  return {{"stretch_x", random.log_in(0.2, 5)}, {"stretch_y", random.log_in(0.2, 5)}};
}

std::vector<Setting> shear(Random& random) {
  return {{"shear_x", random.in(-0.5, 0.5)}, {"shear_y", random.in(-0.5, 0.5)}};
}

} // namespace

TEST_CASE("stretching keeps what else a distribution has") {
  TermDescription material;
  material.name = "m";
  material.distribution.type = "student_t";
  material.distribution.values.set("alpha", 0.4);
  material.distribution.values.set("gamma", 3.0);
  plot::Configuration configuration(material);
  configuration.set({"stretch_x", 2.0});
  configuration.set({"shear_y", 0.25});
  const Microsurface surface = configuration.ready().material.surface();
  CHECK(std::get<StudentT>(surface.distribution).shape.gamma == 3);
  CHECK(surface.slopes().alpha_x == 0.2);
  CHECK(surface.slopes().alpha_y == 0.4);
  CHECK(surface.slopes().mean_y == 0.25);
}

TEST_CASE("stretching and shearing a whole configuration leaves Smith's masking as it was") {
  for (const std::string type : {"beckmann", "ggx"})
    for (const std::string quantity : {"g1", "lambda"}) {
      CAPTURE(type);
      CAPTURE(quantity);
      CHECK(largest_change(quantity, type, "smith", stretch) < 1e-12);
      CHECK(largest_change(quantity, type, "smith", shear) < 1e-12);
      CHECK(largest_change(quantity, type, "smith",
                           [](Random& random) { return with(stretch(random), shear(random)); }) < 1e-12);
    }
}

TEST_CASE("stretching and shearing leaves the masking of V-cavities as it was") {
  for (const std::string type : {"beckmann", "ggx"}) {
    CHECK(largest_change("g1", type, "v_cavity", stretch) < 1e-12);
    CHECK(largest_change("g1", type, "v_cavity", shear) < 1e-12);
  }
}

TEST_CASE("stretching changes slopes: alpha / stretch, and density times the area") {
  TermDescription material;
  material.name = "m";
  material.distribution.type = "ggx";
  material.masking.type = "smith";
  material.distribution.values.set("alpha", 0.5);
  plot::Configuration configuration(material);
  configuration.set({"stretch_x", 2.0});
  configuration.set({"shear_y", 0.25});
  const auto ready = configuration.ready();
  CHECK(ready.material.surface().slopes().alpha_x == 0.25);
  CHECK(ready.material.surface().slopes().alpha_y == 0.5);
  CHECK(ready.material.surface().slopes().mean_y == 0.25);
  const std::vector<Setting> at = {{"theta_m", 0.3}, {"phi_m", 1.0}};
  CHECK(value("p22", material, with(at, {{"stretch_x", 2.0}})) == doctest::Approx(2 * value("p22", material, at)));
}

TEST_CASE("stretching and shearing need a shape-invariant distribution and a factor above 0") {
  TermDescription phong;
  phong.name = "m";
  phong.distribution.type = "phong";
  phong.masking.type = "smith";
  phong.distribution.values.set("exponent", 20.0);
  const std::vector<Setting> at = {{"theta_o", 1.0}};
  CHECK_NOTHROW(value("g1", phong, with(at, {{"stretch_x", 1.0}})));
  CHECK_THROWS_WITH_AS(value("g1", phong, with(at, {{"stretch_x", 2.0}})), doctest::Contains("\"phong\" is none"),
                       InputError);
  CHECK_THROWS_WITH_AS(value("g1", phong, with(at, {{"shear_y", 0.1}})), doctest::Contains("shape-invariant"),
                       InputError);
  const auto ggx = Random(1).material("ggx");
  for (const double factor : {0.0, -1.0})
    CHECK_THROWS_WITH_AS(value("g1", ggx, with(at, {{"stretch_y", factor}})), doctest::Contains("a number > 0"),
                         InputError);
}

TEST_CASE("`a` sets theta_o at the roughness along phi_o") {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    auto material = random.material("ggx");
    material.distribution.values.set("mean_slope", Vec2{0, 0});
    const double a = random.log_in(1e-3, 1e3);
    const double phi = random.in(-pi, pi);
    plot::Configuration configuration(material);
    configuration.set({"a", a});
    configuration.set({"phi_o", phi});
    const auto ready = configuration.ready();
    REQUIRE(ready.o);
    const Projection p = ready.material.surface().slopes().project(*ready.o);
    CHECK(p.c / p.s == doctest::Approx(a).epsilon(1e-12));
    const double ax = material.distribution.values.number("alpha_x"),
                 ay = material.distribution.values.number("alpha_y");
    const double r = material.distribution.values.number("correlation");
    const double alpha_o = std::sqrt(std::pow(ax * std::cos(phi), 2) + std::pow(ay * std::sin(phi), 2) +
                                     2 * r * ax * ay * std::cos(phi) * std::sin(phi));
    const double tan_theta = std::hypot(ready.o->x, ready.o->y) / ready.o->z;
    CHECK(1 / (alpha_o * tan_theta) == doctest::Approx(a).epsilon(1e-9));
    CHECK(std::remainder(std::atan2(ready.o->y, ready.o->x) - phi, 2 * pi) == doctest::Approx(0).epsilon(1e-12));
  }
}

TEST_CASE("`slope` sets theta_m to its arctangent, on either side") {
  for (const double slope : {-3.0, -0.1, 0.0, 0.25, 10.0}) {
    plot::Configuration configuration(Random(1).material("beckmann"));
    configuration.set({"slope", slope});
    const auto m = configuration.ready().m;
    REQUIRE(m);
    CHECK(m->x / m->z == doctest::Approx(slope).epsilon(1e-14));
    CHECK(m->y == 0);
  }
}

TEST_CASE("the BRDF of a figure is that of the half vector, whatever omega_m is") {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    const auto material = random.material("ggx");
    const std::vector<Setting> pair = {{"theta_o", 0.4}, {"theta_i", 0.3}, {"phi_i", 2.0}};
    for (const char* quantity : {"brdf", "brdf_cos"})
      for (const char* variable : {"theta_m", "slope"})
        CHECK(value(quantity, material, with(pair, {{variable, 1.2}})) == value(quantity, material, pair));
    CHECK(value("d", material, with(pair, {{"theta_m", 1.2}})) != value("d", material, pair));
  }
  CHECK_FALSE(plot::depends_on("brdf", "phi_m"));
  CHECK_FALSE(plot::depends_on("albedo", "theta_i"));
  CHECK(plot::depends_on("g2", "theta_m"));
  CHECK(plot::depends_on("brdf", "alpha"));
}

TEST_CASE("what a term fixes is not swept") {
  const auto material = Random(5).material("ggx");
  const Term fixed{"g1", material, {{"theta_o", 1.0}, {"theta_m", 0.2}}};
  const plot::TermFunction function(fixed, {"theta_o"}, 1e-9);
  const auto same = function({{0.3, 1.4}});
  CHECK(same == std::vector<double>(2, value("g1", material, fixed.at)));
  const plot::TermFunction swept({"g1", material, {{"theta_m", 0.2}}}, {"theta_o"}, 1e-9);
  CHECK(swept({{1.0}}) == function({{0.3}}));
}

TEST_CASE("a surface is built once for all rows that it has, and rows are what each is alone") {
  const auto material = Random(6).material("ggx");
  const auto surfaces = [](const plot::SweptConfiguration& configuration, const plot::SweptColumns& columns) {
    std::vector<std::size_t> rows;
    configuration.for_each_surface(columns, [&](const auto&, const auto& some, const auto& directions) {
      CHECK(some.size() == directions.size());
      rows.push_back(some.size());
    });
    return rows;
  };
  using Counts = std::vector<std::size_t>;
  const Term term{"d_visible", material, {{"theta_m", 0.2}, {"stretch_x", 1.3}, {"shear_y", 0.2}}};
  const plot::SweptColumns columns = {{0.5, 0.1, 0.5, 0.1, 0.3}, {0.3, 0.3, 0.6, 0.6, 0.9}};
  CHECK(surfaces({term, {"theta_o", "phi_o"}}, columns) == Counts{5});
  CHECK(surfaces({term, {"a", "phi_m"}}, columns) == Counts{5});
  CHECK(surfaces({term, {"alpha", "theta_o"}}, columns) == Counts{2, 2, 1});
  CHECK(surfaces({term, {"theta_o", "shear_x"}}, columns) == Counts{2, 2, 1});
  CHECK(surfaces({term, {"alpha", "shear_x"}}, columns) == Counts(5, 1));
  CHECK(surfaces({term, {"alpha", "shear_x"}}, {{}, {}}).empty());

  for (const auto& swept : std::vector<std::vector<std::string>>{
           {"theta_o", "phi_o"}, {"a", "phi_o"}, {"alpha", "theta_o"}, {"theta_o", "shear_x"}, {"alpha_x", "alpha"}}) {
    CAPTURE(swept[0]);
    Term seen = term;
    if (swept[0] != "a" && swept[0] != "theta_o" && swept[1] != "theta_o") seen.at.push_back({"theta_o", 0.7});
    const plot::TermFunction function(seen, swept, 1e-9);
    const auto values = function(columns);
    REQUIRE(values.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) CHECK(values[k] == function({{columns[0][k]}, {columns[1][k]}}).at(0));
  }
}

namespace {

/// Gold, as SchlickFresnel has it.
TermDescription gold() {
  auto material = Random(7).material("beckmann");
  material.fresnel.type = "schlick";
  material.fresnel.values.set("f0", Rgb{1, 0.71, 0.29});
  return material;
}

/// What is wrong, or nothing.
std::string error_of(const Term& term, const std::vector<std::string>& swept, const std::vector<double>& at) {
  try {
    plot::TermFunction(term, swept, 1e-6).check(at);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("a coloured quantity is that of the channel which is named") {
  const std::vector<Setting> at = {{"theta_o", 0.5}, {"theta_i", -0.4}, {"phi_i", 0.1}};
  const auto of = [&](const std::string& quantity, const char* channel) {
    auto settings = at;
    settings.push_back({"channel", channel});
    return value(quantity, gold(), settings);
  };
  const auto grey = [&](double f0) {
    auto material = gold();
    material.fresnel.values.set("f0", f0);
    return material;
  };
  for (const char* quantity : {"brdf", "brdf_cos", "fresnel", "albedo", "mean_theta_i", "peak_theta_i"}) {
    CAPTURE(quantity);
    CHECK(of(quantity, "r") == value(quantity, grey(1), at));
    CHECK(of(quantity, "g") == value(quantity, grey(0.71), at));
    CHECK(of(quantity, "b") == value(quantity, grey(0.29), at));
    const Term unnamed{quantity, gold(), at};
    CHECK(error_of(unnamed, {}, {}).find("\"r\", \"g\", \"b\" or \"luminance\"") != std::string::npos);
  }
  for (const char* quantity : {"brdf", "brdf_cos", "fresnel", "albedo"})
    CHECK(of(quantity, "luminance") ==
          doctest::Approx(0.2126 * of(quantity, "r") + 0.7152 * of(quantity, "g") + 0.0722 * of(quantity, "b"))
              .epsilon(1e-14));
  const auto no_luminance = [&](const char* quantity) {
    auto settings = at;
    settings.push_back({"channel", "luminance"});
    return error_of({quantity, gold(), settings}, {}, {});
  };
  CHECK(no_luminance("mean_theta_i").find("\"r\", \"g\" or \"b\"") != std::string::npos);
  CHECK(no_luminance("peak_theta_i").find("\"r\", \"g\" or \"b\"") != std::string::npos);
}

TEST_CASE("a channel is wanted where colours differ alone") {
  const std::vector<Setting> at = {{"theta_o", 0.5}, {"theta_i", -0.4}};
  CHECK(error_of({"d", gold(), at}, {"theta_m"}, {0.1}).empty());
  CHECK(error_of({"furnace", gold(), at}, {}, {}).empty());
  auto equal = gold();
  equal.fresnel.values.set("f0", Rgb{0.5, 0.5, 0.5});
  CHECK(error_of({"brdf", equal, at}, {}, {}).empty());
  auto number = equal;
  number.fresnel.values.set("f0", 0.5);
  CHECK(value("brdf", equal, at) == value("brdf", number, at));
  // What is swept takes the colour's place.
  CHECK(error_of({"brdf", gold(), at}, {"f0"}, {0.5}).empty());
  CHECK(!error_of({"brdf", gold(), at}, {"f90"}, {0.5}).empty());
  CHECK_THROWS_AS(value("brdf", gold(), {{"channel", "red"}}), InputError);
  CHECK_THROWS_AS(value("brdf", gold(), {{"channel", 1.0}}), InputError);
  CHECK(plot::depends_on("brdf", "channel"));
  CHECK(plot::depends_on("transmittance", "channel"));
  CHECK_FALSE(plot::depends_on("g2", "channel"));
}

TEST_CASE("setting variables: parameters, models, and what nothing has") {
  auto material = Random(5).material("ggx");
  plot::Configuration configuration(material);
  configuration.set({"alpha", 0.5});
  CHECK(configuration.ready().material.surface().slopes().alpha_y == 0.5);
  configuration.set({"distribution", "beckmann"});
  configuration.set({"masking", "v_cavity"});
  const auto ready = configuration.ready();
  CHECK(std::holds_alternative<Beckmann>(ready.material.surface().distribution));
  CHECK(std::holds_alternative<VCavity>(ready.material.surface().masking));
  CHECK(std::holds_alternative<Minimum>(ready.material.surface().shadowing));
  configuration.set({"shadowing", "separable"});
  CHECK(std::holds_alternative<Separable>(configuration.ready().material.surface().shadowing));
  CHECK_THROWS_WITH_AS(configuration.set({"gamma", 1.0}), doctest::Contains("unknown variable \"gamma\""), InputError);
  CHECK_THROWS_WITH_AS(configuration.set({"stretchx", 1.0}), doctest::Contains("\"stretch_x\"?"), InputError);
  CHECK_THROWS_WITH_AS(configuration.set({"masking", "smithy"}), doctest::Contains("\"smith\"?"), InputError);
  CHECK_THROWS_WITH_AS(configuration.set({"alpha", "big"}), doctest::Contains("accepted: a number"), InputError);
}
