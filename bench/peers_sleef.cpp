/// \file
/// SLEEF's functions on AVX-512, where this build has SLEEF and the flags that CMakeLists.txt gives this file.
#include "peers.hpp"

#if defined(BRDFPLOT_BENCH_SLEEF) && defined(__AVX512F__)
#include <immintrin.h>
#include <sleef.h>
#endif

namespace brdfplot::bench {

#if defined(BRDFPLOT_BENCH_SLEEF) && defined(__AVX512F__)

namespace {

/// n is a multiple of the vector's size.
void over_doubles(const double* c, const double* s, double* out, std::size_t n) {
  const __m512d half = _mm512_set1_pd(0.5), one = _mm512_set1_pd(1),
                two_root_pi = _mm512_set1_pd(3.5449077018110320546);
  for (std::size_t k = 0; k < n; k += 8) {
    const __m512d a = _mm512_div_pd(_mm512_loadu_pd(c + k), _mm512_loadu_pd(s + k));
    const __m512d first = _mm512_mul_pd(half, _mm512_sub_pd(Sleef_erfd8_u10avx512f(a), one));
    const __m512d power = Sleef_expd8_u10avx512f(_mm512_sub_pd(_mm512_setzero_pd(), _mm512_mul_pd(a, a)));
    _mm512_storeu_pd(out + k, _mm512_add_pd(first, _mm512_div_pd(power, _mm512_mul_pd(two_root_pi, a))));
  }
}

void over_floats(const float* c, const float* s, float* out, std::size_t n) {
  const __m512 half = _mm512_set1_ps(0.5f), one = _mm512_set1_ps(1), two_root_pi = _mm512_set1_ps(3.5449077f);
  for (std::size_t k = 0; k < n; k += 16) {
    const __m512 a = _mm512_div_ps(_mm512_loadu_ps(c + k), _mm512_loadu_ps(s + k));
    const __m512 first = _mm512_mul_ps(half, _mm512_sub_ps(Sleef_erff16_u10avx512f(a), one));
    const __m512 power = Sleef_expf16_u10avx512f(_mm512_sub_ps(_mm512_setzero_ps(), _mm512_mul_ps(a, a)));
    _mm512_storeu_ps(out + k, _mm512_add_ps(first, _mm512_div_ps(power, _mm512_mul_ps(two_root_pi, a))));
  }
}

bool usable() { return __builtin_cpu_supports("avx512f"); }

} // namespace

OverCs<double>* printed_beckmann_sleef() { return usable() ? over_doubles : nullptr; }
OverCs<float>* printed_beckmann_sleef_float() { return usable() ? over_floats : nullptr; }

#else

OverCs<double>* printed_beckmann_sleef() { return nullptr; }
OverCs<float>* printed_beckmann_sleef_float() { return nullptr; }

#endif

} // namespace brdfplot::bench
