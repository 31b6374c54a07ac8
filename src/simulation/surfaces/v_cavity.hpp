/// \file
/// V-cavities: for every normal a surface of its own, ridges whose two sides have that normal and its mirror image.
#pragma once

#include "simulation/surfaces/common.hpp"

#include <cstdint>
#include <optional>

namespace brdfplot::simulation {

/// Torrance and Sparrow 1967; Cook and Torrance 1982; Heitz 2014, section 4.2 and Eqs. 44-49. A realisation is as many
/// ridged surfaces as `pairs`, of equal area seen from above; the slopes are drawn from the distribution, P22, so that
/// a normal has the area that D gives it. Under a shear the mirror image is taken at the tilted mesosurface.
struct VCavitySurface {
  SlopeMap slopes;
  const UnitSlopes* shape = &beckmann_slopes;
  double pairs = 1024;

  static constexpr bool ruled = true; ///< ridges, each surface with one pair of normals

  static ModelSpec spec();
  static VCavitySurface from(const Values& values);
  std::optional<ParameterError> problem() const;
  Realisation realise(std::uint64_t seed, std::uint64_t realisation) const;
  std::optional<SlopeMap> asked() const { return slopes; }
  std::optional<ModelChoice> target() const { return distribution_of(shape->distribution, slopes); }
  const UnitSlopes& unit_slopes() const { return *shape; }
};

} // namespace brdfplot::simulation
