/// \file
/// What terms without a microsurface share.
#pragma once

#include "brdf/term.hpp"
#include "math/kernels/flat.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace brdfplot {

/// A reflectance per channel, given as one number or as three.
struct Colour {
  Rgb value{1, 1, 1};
  bool is_rgb = false;

  int channels() const { return is_rgb ? 3 : 1; }
  static ParameterSpec parameter(const std::string& key, const std::string& doc) {
    return {
        .key = key, .kind = ParameterKind::number_or_rgb, .bounds = {.min = 0, .max = 1}, .fallback = 1.0, .doc = doc};
  }
  static Colour from(const Values& values, const std::string& key) { return {values.rgb(key), values.is_rgb(key)}; }
};

/// F0 of Schlick's (1994) approximation, F = F0 + (1 - F0)(1 - cos)^5, as a term's own parameter.
inline ParameterSpec f0_parameter() {
  ParameterSpec spec = Colour::parameter("f0", "reflectance at normal incidence, of each channel");
  spec.fallback = 0.04;
  return spec;
}

inline int channels_of(const Colour& a, const Colour& b) { return a.is_rgb || b.is_rgb ? 3 : 1; }

/// The parameters of a flat kernel, with the factors of its parts that `factors` gives of each channel.
template <class Factors>
kernels::FlatParameters flat_parameters(const std::array<double, 5>& p, const Factors& factors) {
  kernels::FlatParameters parameters{};
  std::ranges::copy(p, parameters.p);
  for (std::size_t c = 0; c < 3; ++c) std::ranges::copy(std::array<double, 3>(factors(c)), parameters.factors[c]);
  return parameters;
}

/// Writes what a flat kernel computes into the channels, for rows with both directions above the horizon; 0 elsewhere.
inline void evaluate_flat(const PairBlock& block, kernels::FlatTerm term, const kernels::FlatParameters& parameters,
                          int channels, const ChannelRows& out) {
  kernels::flat_brdf(term, parameters, {block.o.x, block.o.y, block.o.z}, {block.i.x, block.i.y, block.i.z},
                     block.times_cosine, channels, out.rho, block.n);
}

/// The values of a term, completed by its spec. \throws MaterialError at "/key".
template <class T>
Values completed_values(const TermDescription& description) {
  auto completed = complete(T::spec(), description.values);
  if (const auto* error = std::get_if<ParameterError>(&completed)) throw MaterialError("/" + error->key, error->what);
  return std::get<Values>(std::move(completed));
}

} // namespace brdfplot
