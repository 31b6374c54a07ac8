/// \file
/// An axis of a baked table: a variable and the places of its nodes.
#pragma once

#include <cstddef>
#include <string>

namespace brdfplot::bake {

/// The variable of an inverse cumulative table: a share, in [0, 1].
inline constexpr const char* share_axis = "u";

/// Nodes at from + (to - from) (k / (nodes - 1))^power, both ends among them: at `power` 1 evenly spaced, above it
/// closer at `from`. A texture is read at ((x - from) / (to - from))^(1 / power).
struct Axis {
  std::string variable; ///< cos_theta_o, theta_o or phi_o (radians), u, or a parameter of the material
  double from = 0, to = 1;
  std::size_t nodes = 32;
  int power = 1;

  /// The value at a share of the way, in [0, 1].
  double at(double share) const;
};

/// "NAME=FROM:TO", "NAME=FROM:TO:NODES" or "NAME=FROM:TO:NODES:POWER"; FROM and TO of angles may have a unit. What is
/// not given is 0. \throws InputError
Axis parse_axis(const std::string& text, const std::string& where);

} // namespace brdfplot::bake
