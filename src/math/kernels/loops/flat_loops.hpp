/// \file
/// The loops of the flat terms over arrays of pairs. Included once per instruction set, like loops.hpp.
#pragma once

#include "math/kernels/flat_elements.hpp"

#include <utility>

namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE {

constexpr int parts_in(FlatTerm term) {
  if (term == FlatTerm::hammon || term == FlatTerm::velvet) return 3;
  return term == FlatTerm::eon || term == FlatTerm::oren_nayar ? 2 : 1;
}

template <int parts>
BRDFPLOT_INLINE double combined(const double (&factors)[3], const Parts& of) {
  if constexpr (parts == 1) return factors[0] * of.a;
  if constexpr (parts == 2) return factors[0] * of.a + factors[1] * of.b;
  return factors[0] * of.a + factors[1] * of.b + factors[2] * of.c;
}

template <FlatTerm term, bool times_cosine, bool rgb>
void flat_all(const FlatParameters& parameters, Vectors<double> o, Vectors<double> i, double* const* out,
              std::size_t n) {
  const FlatParameters k = parameters;
  constexpr int parts = parts_in(term);
  double* __restrict const red = out[0];
  double* __restrict const green = rgb ? out[1] : nullptr;
  double* __restrict const blue = rgb ? out[2] : nullptr;
  BRDFPLOT_INDEPENDENT
  for (std::size_t j = 0; j < n; ++j) {
    const Vector3 viewer{o.x[j], o.y[j], o.z[j]}, light{i.x[j], i.y[j], i.z[j]};
    const bool lit = (viewer.z > 0) & (light.z > 0);
    const Parts of = parts_of<term>(k.p, viewer, light, times_cosine ? light.z : 1);
    red[j] = lit ? combined<parts>(k.factors[0], of) : 0;
    if constexpr (rgb) {
      green[j] = lit ? combined<parts>(k.factors[1], of) : 0;
      blue[j] = lit ? combined<parts>(k.factors[2], of) : 0;
    }
  }
}

template <int... term>
constexpr detail::FlatKernels flat_kernels(std::integer_sequence<int, term...>) {
  return {{{{flat_all<FlatTerm(term), false, false>, flat_all<FlatTerm(term), false, true>},
            {flat_all<FlatTerm(term), true, false>, flat_all<FlatTerm(term), true, true>}}...}};
}
constexpr detail::FlatKernels flat_kernels() { return flat_kernels(std::make_integer_sequence<int, flat_terms>{}); }

} // namespace brdfplot::kernels::BRDFPLOT_KERNELS_NAMESPACE
