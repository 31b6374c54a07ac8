/// \file
/// Rays in the plane of scaled slopes, cut where an integrand is not smooth.
#pragma once

#include "integrate/slope_domain.hpp"

#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace brdfplot {

/// The rays u = r (cos psi, sin psi), r = spread z / (1 - z), cut where switches change their signs and at the frame's
/// radii.
class CutRays {
public:
  /// From where to where a ray runs.
  using Reach = std::function<SlopeFrame::Reach(double cos_psi, double sin_psi)>;

  static constexpr double spread = 2;
  static constexpr double same_place = 1e-6; ///< of a ray's end: sign changes closer than that have no order

  /// Where two parts of a ray meet, or its end: in z, and which switch changes its sign there; after the switches comes
  /// what ends a ray, then the radii.
  struct End {
    double z;
    std::size_t crossed;
  };
  using Ends = std::vector<End>; ///< of the parts of a ray, ascending from where it begins

  CutRays(const SlopeFrame& frame, const std::vector<Switch>& switches, Reach reach)
      : frame_(frame), switches_(switches), reach_(std::move(reach)) {}

  /// The ends of the parts of a ray. Remembered: the parts of a sector, and rectangles that are divided across the
  /// rays, ask for the same ones. Valid until the next call.
  const Ends& at(double psi);
  bool is_root(const End& end) const { return end.crossed < switches_.size() && switches_[end.crossed].root; }

private:
  static constexpr std::size_t most_rays = 20000;

  void evaluate_switch(const NormalIntegrand& of, std::span<const double> z);
  void add_sign_changes(std::size_t which, Ends& ends);
  std::optional<std::pair<double, double>> dip(const NormalIntegrand& of, std::array<double, 3> z,
                                               std::array<double, 3> value);
  double sign_change(const NormalIntegrand& of, std::array<double, 2> z, std::array<double, 2> value);

  const SlopeFrame& frame_;
  const std::vector<Switch>& switches_;
  Reach reach_;
  std::unordered_map<double, Ends> rays_; ///< by psi
  double cos_psi_ = 1, sin_psi_ = 0;      ///< of the ray that is being cut
  std::vector<double> u1_, u2_;
  std::vector<Direction> normals_;
  std::vector<double> values_;
};

} // namespace brdfplot
