/// \file
/// Inputs of the accuracy tests: stretches and pairs of directions, among them the adversarial ones.
#pragma once

#include "accuracy/measure.hpp"

#include <array>

namespace brdfplot::accuracy {

/// Every domain that the tests of distributions and BRDFs sweep.
inline constexpr std::array<const char*, 8> direction_domains = {
    "isotropic",       "anisotropic to 1e4", "correlation to 1",    "sheared",
    "sheared horizon", "omega_i -> omega_o", "omega_i -> -omega_o", "near the mean slope"};

template <class T>
struct Pair {
  std::array<T, 3> o, i;
};

/// Pairs of directions under one stretch.
template <class T>
struct Case {
  kernels::Stretch stretch;
  std::vector<Pair<T>> pairs;

  reference::Stretch<Quad> exact_stretch() const {
    return {Quad(stretch.alpha_x), Quad(stretch.alpha_y), Quad(stretch.correlation), Quad(stretch.mean_x),
            Quad(stretch.mean_y)};
  }
};

template <class T>
reference::Vector<Quad> exact(const std::array<T, 3>& v) {
  return {Quad(v[0]), Quad(v[1]), Quad(v[2])};
}

/// Cases of 50 pairs each, `n` pairs in all. The parameters are representable in T.
template <class T>
std::vector<Case<T>> draw_cases(const std::string& domain, std::size_t n);

template <class T>
std::string text(const Case<T>& in, const Pair<T>& pair);

/// The three arrays of one side.
template <class T>
struct Arrays {
  std::vector<T> x, y, z;
  void push_back(const std::array<T, 3>& v) {
    x.push_back(v[0]);
    y.push_back(v[1]);
    z.push_back(v[2]);
  }
  kernels::Vectors<T> view() const { return {x.data(), y.data(), z.data()}; }
};

} // namespace brdfplot::accuracy
