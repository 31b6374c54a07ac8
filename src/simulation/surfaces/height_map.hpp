/// \file
/// A surface from a file.
#pragma once

#include "simulation/surfaces/common.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace brdfplot::simulation {

/// Heights from a greyscale PNG of 8 or 16 bits (`height` is that of white over black) or a PFM (`height` is that of
/// the value 1), at points `pitch` apart. Measured heights do not fit together at opposite sides: `mirror` continues
/// them by their mirror images, which doubles the period; so the mean slope and the correlation of slopes are lost.
struct HeightMapSurface {
  std::string file;
  double height = 1;
  double pitch = 1;
  bool mirror = false;

  static constexpr bool is_given = true; ///< nothing of it is drawn

  static ModelSpec spec();
  static HeightMapSurface from(const Values& values);
  std::optional<ParameterError> problem() const { return std::nullopt; }
  /// The same for every seed and realisation. \throws FileError, InputError
  Realisation realise(std::uint64_t seed, std::uint64_t realisation) const;
  std::optional<SlopeMap> asked() const { return std::nullopt; }
  std::optional<ModelChoice> target() const { return std::nullopt; }
  const UnitSlopes& unit_slopes() const { return beckmann_slopes; } // those of no other are meant
};

} // namespace brdfplot::simulation
