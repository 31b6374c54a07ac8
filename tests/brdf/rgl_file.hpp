/// \file
/// Tensor files made of closed forms.
#pragma once

#include "brdf/measured/rgl_table.hpp"
#include "measured.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace test {

struct TensorArray {
  std::string name;
  std::vector<std::uint64_t> shape;
  std::vector<float> values; ///< none: bytes
  std::uint8_t type = 10;
  std::string raw = {}; ///< instead of values
};

/// The bytes of a tensor file; `ends`: where each part of it ends.
inline std::string tensor_bytes(const std::vector<TensorArray>& arrays, std::vector<std::size_t>* ends = nullptr) {
  std::size_t head = 12 + 2 + 4;
  for (const TensorArray& array : arrays) head += 2 + array.name.size() + 2 + 1 + 8 + 8 * array.shape.size();
  std::string bytes("tensor_file\0\1\0", 14), data;
  std::vector<std::size_t> marks = {12, 13, 14};
  const auto append = [&](auto number) {
    append_raw(bytes, number);
    marks.push_back(bytes.size());
  };
  append(static_cast<std::uint32_t>(arrays.size()));
  for (const TensorArray& array : arrays) {
    append(static_cast<std::uint16_t>(array.name.size()));
    bytes += array.name;
    marks.push_back(bytes.size());
    append(static_cast<std::uint16_t>(array.shape.size()));
    append(array.type);
    append(static_cast<std::uint64_t>(head + data.size()));
    for (const std::uint64_t length : array.shape) append(length);
    for (const float value : array.values) append_raw(data, value);
    data += array.raw;
    marks.push_back(head + data.size());
  }
  if (ends != nullptr) *ends = marks;
  return bytes + data;
}

/// How finely a material is tabulated.
struct RglSizes {
  std::size_t normals = 64, colours = 32, thetas = 16;
  std::vector<float> phi_i = {0};
};

namespace detail {

inline Direction normal_at(double x, double y, double phi_i) {
  return from_angles(0.5 * std::numbers::pi * x * x, (2 * y - 1) * std::numbers::pi + phi_i);
}

/// The place that `placed` takes to s, by halving: s_y depends on u_y alone.
inline Vec2 place_that_leads_to(const Vec2& s, const std::function<Vec2(const Vec2&)>& placed) {
  Vec2 u = {0.5, 0.5};
  for (const std::size_t axis : {std::size_t{1}, std::size_t{0}}) {
    double low = 0, high = 1;
    for (int k = 0; k < 50; ++k) {
      u[axis] = 0.5 * (low + high);
      (placed(u)[axis] < s[axis] ? low : high) = u[axis];
    }
  }
  return u;
}

} // namespace detail

/// A reciprocal material of one term with a microsurface as a tensor file. Where it is isotropic, sizes.phi_i has one
/// value.
inline std::vector<TensorArray> rgl_of(const Material& material, const RglSizes& sizes, const MeasuredFolder& folder) {
  using detail::normal_at;
  const std::size_t n = sizes.normals, m = sizes.colours;
  const bool isotropic = sizes.phi_i.size() == 1;
  const auto at = [](std::size_t k, std::size_t count) {
    return static_cast<double>(k) / static_cast<double>(count - 1);
  };
  const auto sigma_of = [&](const Direction& i) {
    return i.z * (1 + evaluate(material, Quantity::lambda, i, std::nullopt, std::nullopt));
  };
  const auto d_of = [&](const Direction& h) { return evaluate(material, Quantity::d, {0, 0, 1}, std::nullopt, h); };
  std::vector<float> theta_i, ndf, sigma, vndf, rgb;
  for (std::size_t k = 0; k < sizes.thetas; ++k) {
    const double x = at(k, sizes.thetas);
    theta_i.push_back(static_cast<float>(1.56 * x * (2 - x))); // denser towards grazing
  }
  for (std::size_t y = 0; y < n; ++y)
    for (std::size_t x = 0; x < n; ++x) {
      ndf.push_back(static_cast<float>(d_of(normal_at(at(x, n), at(y, n), 0))));
      sigma.push_back(static_cast<float>(sigma_of(normal_at(std::fmin(at(x, n), 0.9999), at(y, n), 0))));
    }
  const auto for_each_incident = [&](const std::function<void(const Direction&, double)>& call) {
    for (const float phi : sizes.phi_i)
      for (const float theta : theta_i)
        call(from_angles(static_cast<double>(theta), static_cast<double>(phi)),
             isotropic ? static_cast<double>(phi) : 0);
  };
  for_each_incident([&](const Direction& i, double phi_i) {
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x) {
        const Direction h = normal_at(at(x, n), at(y, n), phi_i);
        const double jacobian = at(x, n) * std::hypot(h.x, h.y);
        vndf.push_back(static_cast<float>(d_of(h) * std::fmax(0, dot(i, h)) * jacobian));
      }
  });
  rgb.assign(sizes.phi_i.size() * sizes.thetas * 3 * m * m, 0);
  const std::uint64_t p = sizes.phi_i.size(), t = sizes.thetas;
  std::vector<TensorArray> arrays = {{"description", {4}, {}, 1, "test"},
                                     {"phi_i", {p}, sizes.phi_i},
                                     {"theta_i", {t}, theta_i},
                                     {"ndf", {n, n}, ndf},
                                     {"sigma", {n, n}, sigma},
                                     {"vndf", {p, t, n, n}, vndf},
                                     {"rgb", {p, t, 3, m, m}, rgb},
                                     {"jacobian", {1}, {}, 1, "\1"}};
  const RglTable warp = read_rgl(folder.write("warp.bsdf", tensor_bytes(arrays)));
  std::size_t first = 0;
  for_each_incident([&](const Direction& i, double phi_i) {
    for (std::size_t y = 0; y < m; ++y)
      for (std::size_t x = 0; x < m; ++x) {
        const Vec2 u =
            detail::place_that_leads_to({at(x, m), at(y, m)}, [&](const Vec2& v) { return warp.placed(i, v); });
        const Direction h = normal_at(u[0], u[1], phi_i), o = reflected(i, h);
        const double d = d_of(h);
        if (!(o.z > 0) || !(d > 0) || !(dot(i, h) > 0)) continue;
        std::array<double, 3> rho{};
        evaluate(material, Quantity::brdf_cos, {1, {&i.x, &i.y, &i.z}, {&o.x, &o.y, &o.z}, {}}, rho.data());
        for (std::size_t c = 0; c < 3; ++c)
          arrays[6].values[first + (c * m + y) * m + x] =
              static_cast<float>(rho[material.channels() > 1 ? c : 0] * 4 * sigma_of(i) / d);
      }
    first += 3 * m * m;
  });
  return arrays;
}

} // namespace test
