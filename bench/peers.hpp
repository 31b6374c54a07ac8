/// \file
/// Plain implementations of what the kernels compute, and calls of other libraries. Each function runs over n elements.
#pragma once

#include "math/kernels/kernels.hpp"

#include <array>
#include <cstddef>

namespace brdfplot::bench {

template <class T>
using OverCs = void(const T* c, const T* s, T* out, std::size_t n);

/// Lambda as printed, a = c / s (Heitz 2014, Eqs. 69 and 72), one element after the other.
template <class T>
OverCs<T> printed_beckmann;
template <class T>
OverCs<T> printed_beckmann_boost;
template <class T>
OverCs<T> printed_ggx;
template <class T>
OverCs<T> walter_scalar;

/// The same source, vectorised by the compiler: Eq. 72, and Eq. 69 with GCC's vector mathematics library (-ffast-math,
/// AVX-512). Null pointers where the compiler or the machine has it not.
OverCs<double>* printed_ggx_vectorised();
OverCs<double>* printed_beckmann_libmvec();
/// Eq. 69 with SLEEF's erf and exp of 1 ulp, AVX-512.
OverCs<double>* printed_beckmann_sleef();
OverCs<float>* printed_beckmann_sleef_float();

/// Eq. 69 for an a that is given.
template <class T>
void printed_beckmann_of_a(const T* a, T* out, std::size_t n);

template <class T>
using Brdf = void(double alpha, kernels::Vectors<T> o, kernels::Vectors<T> i, T* out, std::size_t n);

/// D G / (4 cos cos) as pbrt-v4 writes it (util/scattering.h: tan^2, cos phi and sin phi of an anisotropic
/// distribution, Lambda twice, a division at the end), and the same for Beckmann with std::erf, as pbrt-v3 had it but
/// with the exact Lambda.
template <class T>
Brdf<T> pbrt_ggx;
template <class T>
Brdf<T> pbrt_beckmann;

/// D alone, of the first of the two directions.
template <class T>
Brdf<T> pbrt_d_ggx;
template <class T>
Brdf<T> pbrt_d_beckmann;

/// The BRDF of a rough conductor, pbrt_ggx times the reflectance at the half vector in complex arithmetic (util/
/// scattering.h, FrComplex).
inline constexpr double conductor_eta = 0.2, conductor_k = 3.9;
Brdf<double> pbrt_conductor;

/// The same of gold in three channels, the later ones n values apart each.
inline constexpr std::array<double, 3> gold_eta = {0.14, 0.38, 1.44}, gold_k = {3.98, 2.39, 1.60};
Brdf<double> pbrt_gold;

/// The leanest isotropic transcription: tan^2 from cos, Lambda twice, a division.
template <class T>
Brdf<T> lean_ggx;
template <class T>
Brdf<T> lean_beckmann;

} // namespace brdfplot::bench
