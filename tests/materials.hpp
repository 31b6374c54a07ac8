/// \file
/// Short ways to make what most tests need.
#pragma once

#include "brdf/evaluate.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace test {

using namespace brdfplot;

inline constexpr double degree = std::numbers::pi / 180;

inline MaterialDescription describe(const std::string& distribution, double alpha,
                                    const std::string& masking = "smith") {
  MaterialDescription description;
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
inline MaterialDescription general(const std::string& distribution, double alpha_x, double alpha_y, double correlation,
                                   Vec2 mean = {0, 0}, const std::string& masking = "smith") {
  MaterialDescription description;
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
  MaterialDescription description = describe("gtr", alpha);
  description.distribution.values.set("gamma", gamma);
  return build(description);
}

inline MaterialDescription shadowed(MaterialDescription description, const std::string& type,
                                    const std::string& lambda = "") {
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

} // namespace test
