/// \file
/// The inputs of the benchmarks: theta uniform in [0, pi / 2], phi uniform, alpha log-uniform in [0.01, 1], a million.
#pragma once

#include "math/kernels/kernels.hpp"

#include <cstddef>
#include <vector>

namespace brdfplot::bench {

inline constexpr std::size_t count = 1'000'000;
/// A BRDF gets a thousand pairs of directions of each of a thousand roughnesses.
inline constexpr std::size_t batch = 1000;

template <class T>
struct Directions {
  std::vector<T> x, y, z;
  kernels::Vectors<T> from(std::size_t first) const { return {x.data() + first, y.data() + first, z.data() + first}; }
};

template <class T>
struct Inputs {
  std::vector<T> c, s, a;    ///< of one direction and one roughness each
  Directions<T> o, i;        ///< pairs of directions
  std::vector<double> alpha; ///< of the batches of pairs, representable in T
};

/// The same numbers in every run.
template <class T>
const Inputs<T>& inputs();

} // namespace brdfplot::bench
