/// \file
/// What the dispatcher and the sources of one instruction set share. Only plain data and function pointers: an inline
/// function here might be compiled with AVX-512 and then be the copy that the linker keeps for everybody.
#pragma once

#include "math/kernels/cloth.hpp"
#include "math/kernels/flat.hpp"
#include "math/kernels/kernels.hpp"
#include "math/kernels/sampling.hpp"

namespace brdfplot::kernels::detail {

/// A constant in twice the precision of T.
template <class T>
struct Constant {
  T high, low;
};

/// What the loops need of a Stretch.
template <class T>
struct StretchConstants {
  bool plain; ///< uncorrelated and centred: nothing in it cancels
  T alpha_x, alpha_y;
  Constant<T> skew;   ///< r alpha_y
  Constant<T> across; ///< sqrt(1 - r^2) alpha_y
  T mean_x, mean_y;
  Constant<T> inverse_x;   ///< 1 / alpha_x
  Constant<T> inverse_y;   ///< 1 / alpha_y
  Constant<T> inverse_det; ///< 1 / det, det = alpha_x alpha_y sqrt(1 - r^2)
  T pi_det;
  T inverse_pi_det;
};

/// The kernels for arrays of one type, compiled for one instruction set. Densities and BRDFs are computed in double,
/// whatever the arrays hold.
template <class T>
struct Kernels {
  using Project = void (*)(const StretchConstants<T>&, Vectors<T>, T*, T*, std::size_t);
  using Area = void (*)(const T*, const T*, T*, std::size_t);
  using OfA = void (*)(const T*, T*, std::size_t);
  using Density = void (*)(const StretchConstants<double>&, Vectors<T>, T*, std::size_t);
  using Brdf = void (*)(const StretchConstants<double>&, Vectors<T>, Vectors<T>, T*, std::size_t);

  Project project[2]; ///< [plain]
  Area masked_area_beckmann;
  Area masked_area_ggx;
  Area masked_area_walter;
  Area lambda_beckmann;
  Area lambda_ggx;
  Area lambda_walter;
  OfA lambda_beckmann_of_a;
  OfA lambda_ggx_of_a;
  Density density[2][2]; ///< [distribution][plain]
  Brdf brdf[2][4][2];    ///< [distribution][shadowing][plain]
};

/// What the loops need of a relative index n = eta + i k.
struct IndexConstants {
  double above[3];          ///< Re(n^2) - 1 as a sum, the largest part first
  double imaginary;         ///< Im(n^2)
  double imaginary_squared; ///< its square
  double contrast;          ///< |n^2 - 1|^2
};

struct SchlickConstants {
  double f0, f90, exponent;
};

/// Reflectances of arrays of cosines.
struct FresnelKernels {
  using OfIndex = void (*)(const IndexConstants&, const double*, double*, std::size_t);
  using Schlick = void (*)(const SchlickConstants&, const double*, double*, std::size_t);

  OfIndex dielectric;
  OfIndex conductor;
  Schlick schlick[2]; ///< [the exponent is 5]
};

/// The flat terms, of one colour and of three.
struct FlatKernels {
  using Flat = void (*)(const FlatParameters&, Vectors<double>, Vectors<double>, double* const*, std::size_t);

  Flat flat[flat_terms][2][2]; ///< [term][times cosine][rgb]
};

/// What the loops need of a stretch and what it is seen from.
struct VisibleConstants {
  double o[3];
  double c, s;
  double versine;                         ///< 1 - c
  double facing[2], across[2];            ///< the horizontal part of a normal, per unit of either unit slope
  double mean[2];                         ///< of the slopes
  double density;                         ///< 1 / (4 sigma pi det)
  double first_power, below, rest;        ///< the guess of Beckmann's slopes, see `first_facing`
  double rise, bend;                      ///< the same where slopes start
  double lowest, share_lost;              ///< the least slope that is seen, -c / s, or -9; see `share_below`
  double c_root_pi, whole, inverse_whole; ///< c sqrt(pi), and int (c + s x) e^(-x^2) dx over all that is seen
};

/// Directions mirrored at visible normals.
struct SamplingKernels {
  using Mirror = void (*)(const VisibleConstants&, const double*, const double*, const MirroredAtNormals&, std::size_t);

  Mirror mirror[2]; ///< [distribution]
};

/// Wrap lighting, and mirrors of sheen.
struct ClothKernels {
  using Wrap = void (*)(const WrapParameters&, const double*, const double*, double* const*, std::size_t);
  using Sheen = void (*)(const SheenParameters&, double, Vectors<double>, Vectors<double>, double*, std::size_t);

  Wrap wrap[2][2];   ///< [times cosine][rgb]
  Sheen sheen[2][2]; ///< [masking][times cosine]
};

struct DirectionKernels {
  using Half = void (*)(Vectors<double>, Vectors<double>, double*, double*, double*, std::size_t);
  using Dots = void (*)(Vectors<double>, Vectors<double>, double*, std::size_t);

  Half half_vectors;
  Dots careful_dots;
};

struct Table {
  Kernels<double> for_double;
  Kernels<float> for_float;
  FresnelKernels fresnel;
  FlatKernels flat;
  SamplingKernels sampling;
  ClothKernels cloth;
  DirectionKernels directions;
};

extern const Table baseline_table;
// Declared everywhere: a const that only its own source knows would not leave it.
extern const Table avx2_table;
extern const Table avx512_table;

} // namespace brdfplot::kernels::detail
