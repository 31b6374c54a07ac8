/// \file
/// What terms without a microsurface share.
#pragma once

#include "brdf/term.hpp"

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

/// The values of a term, completed by its spec. \throws MaterialError at "/key".
template <class T>
Values completed_values(const TermDescription& description) {
  auto completed = complete(T::spec(), description.values);
  if (const auto* error = std::get_if<ParameterError>(&completed)) throw MaterialError("/" + error->key, error->what);
  return std::get<Values>(std::move(completed));
}

} // namespace brdfplot
