/// \file
/// A stationary surface of Gaussian heights: the slopes are Beckmann's.
#pragma once

#include "simulation/surfaces/common.hpp"

#include <cstdint>
#include <optional>

namespace brdfplot::simulation {

struct GaussianSurface {
  RandomMesh mesh;

  static constexpr bool ruled = false; ///< heights vary both ways

  static ModelSpec spec() {
    return {.type = "gaussian",
            .doc = "Gaussian heights with a Gaussian or exponential autocorrelation; slopes of Beckmann",
            .source = "spectral synthesis; alpha = 2 h / L (Bourlier, Berginc and Saillard 2002)",
            .parameters = RandomMesh::parameters(),
            .alternatives = SlopeMap::alternatives()};
  }
  static GaussianSurface from(const Values& values) { return {RandomMesh::from(values)}; }
  std::optional<ParameterError> problem() const { return mesh.problem(); }
  Realisation realise(std::uint64_t seed, std::uint64_t realisation) const {
    const Field field = gaussian_field(mesh.request(), seed, realisation);
    Realisation out{{}, field.rms_height, mesh.correlation_length};
    out.fields.push_back(mesh.mesh({field.heights.begin(), field.heights.end()}));
    return out;
  }
  std::optional<SlopeMap> asked() const { return mesh.slopes; }
  std::optional<ModelChoice> target() const { return distribution_of(unit_slopes().distribution, mesh.slopes); }
  const UnitSlopes& unit_slopes() const { return beckmann_slopes; }
};

} // namespace brdfplot::simulation
