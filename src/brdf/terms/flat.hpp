/// \file
/// What terms without a microsurface share.
#pragma once

#include "brdf/term.hpp"

#include <cmath>
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

/// x^5.
inline double fifth(double x) {
  const double x2 = x * x;
  return x2 * x2 * x;
}

/// 1 - m^5 for l = 1 - m, as a product of what does not cancel.
inline double one_less_fifth(double m, double l) { return l * (1 + m * (1 + m * (1 + m * (1 + m)))); }

/// What the BRDFs of a flat surface are functions of: cosines of a pair of directions above it, each to a few roundings
/// at every angle. o + i and o - i are exact to a rounding where a dot product would cancel.
struct PairCosines {
  PairCosines(const Direction& o, const Direction& i) : v(o.z), l(i.z) {
    const Direction sum = o + i, difference = o + -1.0 * i;
    // Of opposite directions at grazing the sum may be so short that its square is 0.
    const double size = std::fmax(std::fmax(std::fabs(sum.x), std::fabs(sum.y)), sum.z);
    const Direction scaled = {sum.x / size, sum.y / size, sum.z / size};
    const double across2 = scaled.x * scaled.x + scaled.y * scaled.y;
    const double length2 = across2 + scaled.z * scaled.z;
    const double length = std::sqrt(length2);
    lh = 0.5 * length * size;
    one_less_lh = dot(difference, difference) / (4 * (1 + lh));
    nh = scaled.z / length;
    sin2_h = across2 / length2;
  }

  double v, l; ///< n.v and n.l
  double lh;   ///< l.h = v.h
  double one_less_lh;
  double nh;     ///< n.h
  double sin2_h; ///< 1 - (n.h)^2
};

/// Writes the colour times rho(o, i) into the channels, for rows with both directions above the horizon; 0 elsewhere.
template <class Rho>
void evaluate_flat(const PairBlock& block, const Colour& colour, const ChannelRows& out, const Rho& rho) {
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction o = block.o[k], i = block.i[k];
    const double value = o.z > 0 && i.z > 0 ? rho(o, i) * (block.times_cosine ? i.z : 1) : 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(colour.channels()); ++c)
      out.rho[c][k] = colour.value[c] * value;
  }
}

/// Writes rho(channel, cosines) of each row with both directions above the horizon; 0 elsewhere.
template <class Rho>
void evaluate_channels(const PairBlock& block, int channels, const ChannelRows& out, const Rho& rho) {
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
    double* const to = out.rho[c];
    for (std::size_t k = 0; k < block.n; ++k) {
      const Direction o = block.o[k], i = block.i[k];
      const double value = rho(c, PairCosines(o, i)) * (block.times_cosine ? i.z : 1);
      to[k] = o.z > 0 && i.z > 0 ? value : 0;
    }
  }
}

/// The values of a term, completed by its spec. \throws MaterialError at "/key".
template <class T>
Values completed_values(const TermDescription& description) {
  auto completed = complete(T::spec(), description.values);
  if (const auto* error = std::get_if<ParameterError>(&completed)) throw MaterialError("/" + error->key, error->what);
  return std::get<Values>(std::move(completed));
}

} // namespace brdfplot
