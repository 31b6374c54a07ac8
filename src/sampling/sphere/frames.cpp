#include "sampling/sphere/frames.hpp"

#include <cmath>

namespace brdfplot::sphere {

Frame frame_at(const Place& place) {
  const double x = place.x, y = place.y;
  const double around = std::sqrt((1 - y) * (1 + y)); // the radius of the circle of latitude
  const double z = std::sqrt(std::fmax((around - x) * (around + x), 0.0));
  return {{z / around, 0, -x / around}, {-x * y / around, around, -y * z / around}, {x, y, z}};
}

Frames::Frames(std::span<const Place> places) {
  for (Vectors* vectors : {&tangent_, &bitangent_, &normal_, &viewer_, &light_})
    for (auto& column : *vectors) column.resize(places.size());
  const auto put = [](Vectors& vectors, std::size_t k, const Direction& d) {
    vectors[0][k] = d.x;
    vectors[1][k] = d.y;
    vectors[2][k] = d.z;
  };
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Frame frame = frame_at(places[k]);
    put(tangent_, k, frame.tangent);
    put(bitangent_, k, frame.bitangent);
    put(normal_, k, frame.normal);
    put(viewer_, k, {frame.tangent.z, frame.bitangent.z, frame.normal.z}); // the viewer is at (0, 0, 1)
  }
}

void Frames::set_light(const Direction& light) {
  const auto project = [&](const Vectors& axis, std::vector<double>& out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = axis[0][k] * light.x + axis[1][k] * light.y + axis[2][k] * light.z;
  };
  project(tangent_, light_[0]);
  project(bitangent_, light_[1]);
  project(normal_, light_[2]);
}

void Frames::set_lights(std::span<const Direction> lights) {
  const auto project = [&](const Vectors& axis, std::vector<double>& out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = axis[0][k] * lights[k].x + axis[1][k] * lights[k].y + axis[2][k] * lights[k].z;
  };
  project(tangent_, light_[0]);
  project(bitangent_, light_[1]);
  project(normal_, light_[2]);
}

} // namespace brdfplot::sphere
