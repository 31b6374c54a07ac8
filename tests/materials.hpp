/// \file
/// Short ways to make what most tests need.
#pragma once

#include "brdf/evaluate.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test {

using namespace brdfplot;

inline constexpr double degree = std::numbers::pi / 180;

inline TermDescription describe(const std::string& distribution, double alpha, const std::string& masking = "smith") {
  TermDescription description;
  description.name = distribution + " with " + masking;
  description.distribution.type = distribution;
  description.distribution.values.set("alpha", alpha);
  description.masking.type = masking;
  return description;
}

inline Material material(const std::string& distribution, double alpha, const std::string& masking = "smith") {
  return build(describe(distribution, alpha, masking));
}

/// Anisotropic, correlated, with its mesosurface tilted.
inline TermDescription general(const std::string& distribution, double alpha_x, double alpha_y, double correlation,
                               Vec2 mean = {0, 0}, const std::string& masking = "smith") {
  TermDescription description;
  description.name = "general " + distribution;
  description.distribution.type = distribution;
  description.distribution.values.set("alpha_x", alpha_x);
  description.distribution.values.set("alpha_y", alpha_y);
  description.distribution.values.set("correlation", correlation);
  description.distribution.values.set("mean_slope", mean);
  description.masking.type = masking;
  return description;
}

inline Material gtr(double alpha, double gamma) {
  TermDescription description = describe("gtr", alpha);
  description.distribution.values.set("gamma", gamma);
  return build(description);
}

/// One distribution with all its parameters, by key.
inline TermDescription distribution(const std::string& type,
                                    const std::vector<std::pair<std::string, double>>& values) {
  TermDescription description;
  description.name = type;
  description.distribution.type = type;
  for (const auto& [key, value] : values) {
    description.distribution.values.set(key, value);
    description.name += ", " + key + " = " + std::to_string(value);
  }
  return description;
}

inline TermDescription custom(const std::string& shape, double alpha) {
  TermDescription description = describe("custom", alpha);
  description.distribution.values.set("shape", shape);
  description.name = "custom " + shape;
  return description;
}

inline TermDescription mixture(const WeightedChoices& components) {
  TermDescription description;
  description.name = "mixture of " + std::to_string(components.size());
  description.distribution.type = "mixture";
  description.distribution.values.set("components", components);
  return description;
}

/// Distributions of every type in the list, ordinary and less so.
inline std::vector<TermDescription> every_distribution() {
  std::vector<TermDescription> all;
  for (const double alpha : {0.02, 0.5, 3.0}) {
    for (const auto* type : {"beckmann", "ggx", "velvet", "sheen", "ward", "gaussian"})
      all.push_back(distribution(type, {{"alpha", alpha}}));
    all.push_back(distribution("gtr", {{"alpha", alpha}, {"gamma", 1.5}}));
    for (const double gamma : {1.7, 4.0, 100.0})
      all.push_back(distribution("student_t", {{"alpha", alpha}, {"gamma", gamma}}));
    for (const double p : {0.4, 2.0}) all.push_back(distribution("exponential_power", {{"alpha", alpha}, {"p", p}}));
  }
  for (const double sigma : {0.02, 0.5, 3.0}) {
    all.push_back(distribution("oren_nayar", {{"sigma", sigma}}));
    all.back().masking.type = "v_cavity"; // Smith's is infinite
  }
  all.push_back(distribution("phong", {{"exponent", 30}}));
  all.push_back(distribution("velvet", {{"alpha", 0.3}, {"amplitude", 100}}));
  for (const auto& [type, key, value] :
       {std::tuple("beckmann", "", 0.0), std::tuple("ggx", "", 0.0), std::tuple("student_t", "gamma", 2.5),
        std::tuple("exponential_power", "p", 0.5)}) {
    TermDescription description = general(type, 0.2, 0.6, -0.5, {0.2, -0.1});
    if (*key != 0) description.distribution.values.set(key, value);
    all.push_back(description);
  }
  for (const auto* shape : {"exp(-t2)", "exp(-1/t2) / (0.1 + t2^2)", "t^2 * exp(-t)"}) {
    all.push_back(custom(shape, 0.5));
    all.push_back(general("custom", 0.2, 0.6, -0.5, {0.2, -0.1}));
    all.back().distribution.values.set("shape", std::string(shape));
  }
  all.push_back(mixture({{0.7, distribution("ggx", {{"alpha", 0.1}}).distribution},
                         {0.3, distribution("beckmann", {{"alpha", 0.6}}).distribution}}));
  all.push_back(mixture({{1, general("beckmann", 0.05, 0.8, 0.3, {0.1, 0.2}).distribution},
                         {3, general("ggx", 0.5, 0.1, 0, {0.1, 0.2}).distribution}}));
  return all;
}

inline TermDescription shadowed(TermDescription description, const std::string& type, const std::string& lambda = "") {
  ModelChoice choice{.type = type, .values = {}};
  if (!lambda.empty()) choice.values.set("lambda", lambda);
  description.shadowing = choice;
  return description;
}

inline double value(const Material& m, Quantity q, const Direction& o, const Direction& i) {
  return evaluate(m, q, o, i, std::nullopt);
}

inline double value_at_normal(const Material& m, Quantity q, const Direction& o, const Direction& normal) {
  return evaluate(m, q, o, std::nullopt, normal);
}

inline double lambda(const Material& m, const Direction& o) {
  return evaluate(m, Quantity::lambda, o, std::nullopt, std::nullopt);
}

inline double g1(const Material& m, const Direction& o) {
  return evaluate(m, Quantity::g1, o, std::nullopt, std::nullopt);
}

/// |x / y - 1|.
inline double relative(double x, double y) { return x == y ? 0 : std::fabs(x / y - 1); }

/// The same with a masking function that is a formula: of `lambda` or of `g1`.
inline TermDescription with_formula(TermDescription description, const std::string& key, const std::string& formula) {
  description.masking = {.type = "custom", .values = {}};
  description.masking.values.set(key, formula);
  return description;
}

} // namespace test
