/// \file
/// What a type of term is drawn by besides what its facets give: a line of the list here for each.
#pragma once

#include "brdf/material.hpp"
#include "sampling/direct_lobe.hpp"
#include "sampling/strategy.hpp"

#include <memory>

namespace brdfplot {

/// `strategy`, whether a term `has` it with its parameters, and its `lobe`; null: the strategy is half_vector under the
/// name of who wrote of it. `other`: the table of a term's albedo whose rest the lobe reflects, null where there is
/// none.
template <class Term>
struct OwnStrategy {};

template <>
struct OwnStrategy<Eon> {
  static constexpr Strategy strategy = Strategy::eon;
  static bool has(const Eon&) { return true; }
  static std::shared_ptr<const DirectLobe> lobe(const Eon& term) { return eon_lobe(term.roughness); }
  static const AlbedoTable* other(const Eon&) { return nullptr; }
};

template <>
struct OwnStrategy<Complement> {
  static constexpr Strategy strategy = Strategy::kelemen;
  static bool has(const Complement& term) { return term.isotropic(); }
  static std::shared_ptr<const DirectLobe> lobe(const Complement& term) { return matte_lobe(term.of); }
  static const AlbedoTable* other(const Complement& term) { return &term.of.table(); }
};

template <>
struct OwnStrategy<Kelemen2001> {
  static constexpr Strategy strategy = Strategy::kelemen;
  static bool has(const Kelemen2001&) { return true; }
  static std::shared_ptr<const DirectLobe> lobe(const Kelemen2001&) { return nullptr; }
  static const AlbedoTable* other(const Kelemen2001&) { return nullptr; }
};

/// What `f(own, term)` gives of the OwnStrategy of a term that has one; else R().
template <class R, class F>
R with_own_strategy(const WeightedTerm& weighted, const F& f) {
  return std::visit(
      [&]<class T>(const T& term) -> R {
        if constexpr (requires { OwnStrategy<T>::strategy; })
          if (OwnStrategy<T>::has(term)) return f(OwnStrategy<T>{}, term);
        return R();
      },
      weighted.term);
}

} // namespace brdfplot
