/// \file
/// The loops over arrays, and the table of them: the source that is compiled once per instruction set. Expects
/// BRDFPLOT_KERNELS_NAMESPACE to be that instruction set's own namespace.
///
/// Where an element takes more than about a hundred instructions the work is cut into short loops over blocks that stay
/// in the first-level cache: the scheduler of a processor holds some hundred instructions, and a long chain of
/// dependent ones would keep it from starting with the next elements.
#pragma once

#include "math/kernels/brdf_elements.hpp"

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

inline constexpr std::size_t block_size = 128;

/// One value for each element of a block.
template <class T>
struct alignas(64) Column {
  T values[block_size];
  BRDFPLOT_INLINE_MEMBER T& operator[](std::size_t j) { return values[j]; }
};

template <class T>
BRDFPLOT_INLINE Vector3 element(const Vectors<T>& v, std::size_t j) {
  return {static_cast<double>(v.x[j]), static_cast<double>(v.y[j]), static_cast<double>(v.z[j])};
}

/// A result as an element of the array: never infinite; as float, rounded without the processor's slow way to a
/// subnormal number where the result is zero anyway.
BRDFPLOT_INLINE void store(double value, double* to) { *to = smaller(value, 0x1.fffffffffffffp1023); }
BRDFPLOT_INLINE void store(double value, float* to) {
  const double finite = smaller(value, 0x1.fffffep127);
  *to = static_cast<float>(finite < 0x1p-150 ? 0 : finite);
}

template <class T, bool plain>
void project_all(const Constants<T>& constants, Vectors<T> omega, T* __restrict c, T* __restrict s, std::size_t n) {
  const Constants<T> k = constants;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const Projected<T> p = project<plain>(k, Vector<T>{omega.x[j], omega.y[j], omega.z[j]});
    c[j] = p.c;
    s[j] = length(p.along, p.across);
  }
}

template <class T, bool plain, Distribution distribution>
void density_all(const Constants<double>& constants, Vectors<T> m, T* __restrict d, std::size_t n) {
  const Constants<double> k = constants;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j)
    store(distribution == Distribution::ggx ? d_ggx<plain>(k, element(m, j)) : d_beckmann<plain>(k, element(m, j)),
          d + j);
}

template <class T, bool plain, Shadowing shadowing>
void brdf_ggx_all(const Constants<double>& constants, Vectors<T> o, Vectors<T> i, T* __restrict value, std::size_t n) {
  const Constants<double> k = constants;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) store(brdf_ggx<shadowing, plain>(k, element(o, j), element(i, j)), value + j);
}

/// The masking of one side of the Beckmann BRDF, in two loops.
struct BeckmannSides {
  Column<double> c, s, a, area, denominator;
};

BRDFPLOT_INLINE void mask(BeckmannSides& side, std::size_t size) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) {
    const BeckmannSide masked = beckmann_side(side.s[j], side.a[j]);
    side.area[j] = masked.area;
    side.denominator[j] = masked.denominator;
  }
}

template <class T, bool plain, Shadowing shadowing>
void brdf_beckmann_all(const Constants<double>& constants, Vectors<T> o, Vectors<T> i, T* __restrict value,
                       std::size_t n) {
  const Constants<double> k = constants;
  BeckmannSides side_o, side_i;
  Column<double> factor, shifted_k;
  for (std::size_t first = 0; first < n; first += block_size) {
    const std::size_t size = n - first < block_size ? n - first : block_size;
    BRDFPLOT_INDEPENDENT
    for (std::size_t j = 0; j < size; ++j) {
      const BeckmannGeometry g = beckmann_geometry<plain>(k, element(o, first + j), element(i, first + j));
      side_o.c[j] = g.o.c, side_o.s[j] = g.o.s, side_o.a[j] = g.o.a;
      side_i.c[j] = g.i.c, side_i.s[j] = g.i.s, side_i.a[j] = g.i.a;
      factor[j] = g.factor, shifted_k[j] = g.shifted_k;
    }
    mask(side_o, size);
    if (shadowing != Shadowing::none) mask(side_i, size);
    BRDFPLOT_INDEPENDENT
    for (std::size_t j = 0; j < size; ++j) {
      const BeckmannGeometry g{{side_o.c[j], 0, 0}, {side_i.c[j], 0, 0}, factor[j], shifted_k[j]};
      const BeckmannSide none{};
      store(brdf_beckmann<shadowing>(
                g, {side_o.area[j], side_o.denominator[j]},
                shadowing == Shadowing::none ? none : BeckmannSide{side_i.area[j], side_i.denominator[j]}),
            value + first + j);
    }
  }
}

/// The loop of a function of (c, s).
template <class T, T (*function)(T, T)>
void over_cs(const T* __restrict c, const T* __restrict s, T* __restrict out, std::size_t n) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) out[j] = function(c[j], s[j]);
}

/// Where a Beckmann kernel finds a, and what it makes of the parts of Lambda: the masked area of arrays of c and s.
template <class T>
struct AreaOverCs {
  static constexpr bool careful = true;
  const T* __restrict c;
  const T* __restrict s;
  T* __restrict out;
  BRDFPLOT_INLINE_MEMBER Ratio<T> first_step(std::size_t j) const { return ratio(magnitude(c[j]), s[j]); }
  BRDFPLOT_INLINE_MEMBER void finish(std::size_t j, T, const Exponential<T>& e, const Quotient<T>& r) const {
    out[j] = masked_area_beckmann(c[j], s[j], e, r);
  }
};

/// Lambda of arrays of c and s. Below the horizon a is 0, where Lambda is infinite.
template <class T>
struct LambdaOverCs {
  static constexpr bool careful = false;
  const T* __restrict c;
  const T* __restrict s;
  T* __restrict out;
  BRDFPLOT_INLINE_MEMBER Ratio<T> first_step(std::size_t j) const { return ratio(larger(c[j], T(0)), s[j]); }
  BRDFPLOT_INLINE_MEMBER void finish(std::size_t j, T a, const Exponential<T>& e, const Quotient<T>& r) const {
    out[j] = lambda_beckmann(a, e, r);
  }
};

/// Lambda of an array of a.
template <class T>
struct LambdaOverA {
  static constexpr bool careful = false;
  const T* __restrict a;
  T* __restrict out;
  BRDFPLOT_INLINE_MEMBER Ratio<T> first_step(std::size_t j) const { return ratio_of(larger(a[j], T(0))); }
  BRDFPLOT_INLINE_MEMBER void finish(std::size_t j, T bounded_a, const Exponential<T>& e, const Quotient<T>& r) const {
    out[j] = lambda_beckmann(bounded_a, e, r);
  }
};

/// A block of Beckmann's masked area or Lambda on its way through four steps. `careful`: with what roundings drop.
template <class T, bool careful>
struct BeckmannBlock {
  Column<T> a, square, square_low, value, shifted_k, numerator, denominator;
  Column<T> value_low, denominator_low; ///< where careful

  BRDFPLOT_INLINE_MEMBER void first_step(std::size_t j, const Ratio<T>& r) {
    a[j] = r.a;
    square[j] = r.square;
    square_low[j] = r.square_low;
  }
  BRDFPLOT_INLINE_MEMBER void exponential_step(std::size_t j) {
    const Exponential<T> e = exponential(-square[j], -square_low[j], quarter_over_root_pi<T>);
    value[j] = e.value;
    shifted_k[j] = e.shifted_k;
    if constexpr (careful) value_low[j] = e.value_low;
  }
  BRDFPLOT_INLINE_MEMBER void quotient_step(std::size_t j) {
    const Quotient<T> r = scaled_beckmann_lambda(a[j], square[j], square_low[j]);
    numerator[j] = r.numerator;
    denominator[j] = r.denominator;
    if constexpr (careful) denominator_low[j] = r.denominator_low;
  }
  BRDFPLOT_INLINE_MEMBER Exponential<T> exponential_of(std::size_t j) {
    return {value[j], shifted_k[j], careful ? value_low[j] : 0};
  }
  BRDFPLOT_INLINE_MEMBER Quotient<T> quotient_of(std::size_t j) {
    return {numerator[j], denominator[j], careful ? denominator_low[j] : 0};
  }
};

template <class T, bool careful, class Arrays>
void begin(BeckmannBlock<T, careful>& b, const Arrays& arrays, std::size_t first, std::size_t size) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) b.first_step(j, arrays.first_step(first + j));
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) b.exponential_step(j);
}

template <class T, bool careful, class Arrays>
void finish(BeckmannBlock<T, careful>& b, const Arrays& arrays, std::size_t first, std::size_t size) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) b.quotient_step(j);
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < size; ++j) arrays.finish(first + j, b.a[j], b.exponential_of(j), b.quotient_of(j));
}

/// Begins `next`, which starts at `first`, and finishes `last`, the block before it. A loop that divides for the one
/// computes polynomials for the other, so that the divider and the multipliers work at the same time.
template <class T, bool careful, class Arrays>
void begin_and_finish(BeckmannBlock<T, careful>& next, BeckmannBlock<T, careful>& last, const Arrays& arrays,
                      std::size_t first) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < block_size; ++j) {
    next.first_step(j, arrays.first_step(first + j));
    last.quotient_step(j);
  }
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < block_size; ++j) {
    arrays.finish(first - block_size + j, last.a[j], last.exponential_of(j), last.quotient_of(j));
    next.exponential_step(j);
  }
}

/// Masked area or Lambda of Beckmann.
template <class T, class Arrays>
void beckmann_all(const Arrays& arrays, std::size_t n) {
  BeckmannBlock<T, Arrays::careful> blocks[2];
  const std::size_t whole = n / block_size * block_size;
  if (whole > 0) {
    begin(blocks[0], arrays, 0, block_size);
    std::size_t parity = 0;
    for (std::size_t first = block_size; first < whole; first += block_size) {
      begin_and_finish(blocks[1 - parity], blocks[parity], arrays, first);
      parity = 1 - parity;
    }
    finish(blocks[parity], arrays, whole - block_size, block_size);
  }
  begin(blocks[0], arrays, whole, n - whole);
  finish(blocks[0], arrays, whole, n - whole);
}

template <class T, class Arrays>
void beckmann_over_cs(const T* c, const T* s, T* out, std::size_t n) {
  beckmann_all<T>(Arrays{c, s, out}, n);
}

template <class T>
void beckmann_over_a(const T* a, T* out, std::size_t n) {
  beckmann_all<T>(LambdaOverA<T>{a, out}, n);
}

template <class T>
void ggx_over_a(const T* __restrict a, T* __restrict out, std::size_t n) {
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) out[j] = lambda_ggx(a[j], T(1));
}

template <class T, bool plain, Distribution distribution, Shadowing shadowing>
constexpr typename detail::Kernels<T>::Brdf brdf_of() {
  if constexpr (distribution == Distribution::ggx)
    return brdf_ggx_all<T, plain, shadowing>;
  else
    return brdf_beckmann_all<T, plain, shadowing>;
}

template <class T, bool plain, Distribution distribution>
constexpr void add_distribution(detail::Kernels<T>& table) {
  table.density[static_cast<int>(distribution)][plain] = density_all<T, plain, distribution>;
  auto& row = table.brdf[static_cast<int>(distribution)];
  row[static_cast<int>(Shadowing::none)][plain] = brdf_of<T, plain, distribution, Shadowing::none>();
  row[static_cast<int>(Shadowing::separable)][plain] = brdf_of<T, plain, distribution, Shadowing::separable>();
  row[static_cast<int>(Shadowing::minimum)][plain] = brdf_of<T, plain, distribution, Shadowing::minimum>();
  row[static_cast<int>(Shadowing::height_correlated)][plain] =
      brdf_of<T, plain, distribution, Shadowing::height_correlated>();
}

template <class T, bool plain>
constexpr void add_stretched(detail::Kernels<T>& table) {
  table.project[plain] = project_all<T, plain>;
  add_distribution<T, plain, Distribution::beckmann>(table);
  add_distribution<T, plain, Distribution::ggx>(table);
}

template <class T>
constexpr detail::Kernels<T> kernels_of() {
  detail::Kernels<T> table{};
  add_stretched<T, false>(table);
  add_stretched<T, true>(table);
  table.masked_area_beckmann = beckmann_over_cs<T, AreaOverCs<T>>;
  table.masked_area_ggx = over_cs<T, masked_area_ggx<T>>;
  table.masked_area_walter = over_cs<T, masked_area_walter<T>>;
  table.lambda_beckmann = beckmann_over_cs<T, LambdaOverCs<T>>;
  table.lambda_ggx = over_cs<T, lambda_ggx<T>>;
  table.lambda_walter = over_cs<T, lambda_walter<T>>;
  table.lambda_beckmann_of_a = beckmann_over_a<T>;
  table.lambda_ggx_of_a = ggx_over_a<T>;
  return table;
}

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
