/// \file
/// The visible points of a sphere and how the material lies on them.
#pragma once

#include "brdf/evaluate.hpp"

#include <array>
#include <span>
#include <vector>

namespace brdfplot::sphere {

/// A point of the unit sphere as a parallel projection shows it: x to the right, y up, x^2 + y^2 < 1.
struct Place {
  double x, y;
};

/// The frame of the material at a place. The sphere's poles are at the top and at the bottom of the picture: the
/// tangent (x of the material) points to the right along the circle of latitude, the bitangent (y) up along the
/// meridian.
struct Frame {
  Direction tangent, bitangent, normal;
};

Frame frame_at(const Place& place);

/// Frames of several places as columns, with the direction of the viewer and that of a light in each.
class Frames {
public:
  explicit Frames(std::span<const Place> places);

  std::size_t size() const { return normal_[0].size(); }
  Columns omega_o() const { return columns(viewer_); }
  Direction omega_o(std::size_t k) const { return {viewer_[0][k], viewer_[1][k], viewer_[2][k]}; }
  /// Sets omega_i of each frame, below its horizon too, for a direction in that of the picture (z to the viewer).
  void set_light(const Direction& light);
  /// The same with a direction of its own for each frame.
  void set_lights(std::span<const Direction> lights);
  Columns omega_i() const { return columns(light_); }

private:
  using Vectors = std::array<std::vector<double>, 3>;
  static Columns columns(const Vectors& of) { return {of[0].data(), of[1].data(), of[2].data()}; }

  Vectors tangent_, bitangent_, normal_, viewer_, light_;
};

} // namespace brdfplot::sphere
