/// \file
/// Peers that need flags of their own: see CMakeLists.txt.
#include "peers.hpp"

#include <cmath>

namespace brdfplot::bench {

namespace {

void beckmann(const double* __restrict c, const double* __restrict s, double* __restrict out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const double a = c[k] / s[k];
    out[k] = 0.5 * (std::erf(a) - 1) + std::exp(-a * a) / (2 * a * 1.7724538509055160273);
  }
}

void ggx(const double* __restrict c, const double* __restrict s, double* __restrict out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const double a = c[k] / s[k];
    out[k] = (std::sqrt(1 + 1 / (a * a)) - 1) / 2;
  }
}

bool usable() {
#if defined(__AVX512F__)
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#else
  return false;
#endif
}

} // namespace

OverCs<double>* printed_beckmann_libmvec() { return usable() ? beckmann : nullptr; }
OverCs<double>* printed_ggx_vectorised() { return usable() ? ggx : nullptr; }

} // namespace brdfplot::bench
