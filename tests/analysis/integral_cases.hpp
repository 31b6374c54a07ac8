/// \file
/// Integrals of random materials, and of given ones, with their true values by the rule of ray_rule.hpp.
#pragma once

#include "../materials.hpp"
#include "analysis/integrals.hpp"
#include "ray_rule.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace test {

/// Everything of one case from its number alone.
class Draw {
public:
  explicit Draw(std::uint64_t number) : engine_(number * 2654435761U + 99) {}

  double between(double low, double high) { return low + (high - low) * unit_(engine_); }
  double log_between(double low, double high) { return low * std::pow(high / low, unit_(engine_)); }
  bool chance(double probability) { return unit_(engine_) < probability; }
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[std::min(all.size() - 1, static_cast<std::size_t>(unit_(engine_) * static_cast<double>(all.size())))];
  }

private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0, 1};
};

/// An integral of one material, with the accuracy that is asked.
struct IntegralCase {
  std::string text; ///< what it is
  Material material;
  Direction o;
  Integral integral = Integral::albedo;
  double tolerance = 1e-9;

  /// The tolerance is relative to this.
  double scale() const { return integral == Integral::projected_area ? material.surface().slopes().project(o).c : 1; }
};

/// The case of that number: materials smooth and rough (alpha 0.002 to 5), anisotropic up to 1 to 100, correlated up to
/// 0.99, sheared, mixed of very different widths; every masking function with every form of shadowing and every Fresnel
/// term; directions at the normal, anywhere, and up to 89.99 degrees. Nothing where the models do not go together or
/// the direction is below the mesosurface.
std::optional<IntegralCase> random_case(std::uint64_t number);

/// The same of mixtures whose parts lie on mesosurfaces of their own, inclined by slopes up to 0.8: some are seen from
/// below.
std::optional<IntegralCase> random_tilted_case(std::uint64_t number);

/// The same of shapes and masking functions that are formulas of a user's: smooth ones, and ones with corners and jumps
/// that nobody declares.
std::optional<IntegralCase> random_formula_case(std::uint64_t number);

/// albedo, furnace, projected_area, visible_norm or weak_furnace (which Eq. 36 says is the same as visible_norm), to
/// so much of the tolerance of the case.
RayIntegral truth_of(const IntegralCase& one, double of_tolerance = 1);

/// rho of diffuse facets (Heitz 2014, Eq. 31), to a relative `tolerance`; `about` is what it is, roughly.
/// `parts`: into how many each panel is cut to begin with.
RayIntegral diffuse_truth(const Material& material, const Direction& o, const Direction& i, double tolerance,
                          double about, int parts);

} // namespace test
