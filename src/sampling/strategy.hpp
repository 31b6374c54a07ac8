/// \file
/// The ways to draw directions of the light.
#pragma once

#include <string>
#include <vector>

namespace brdfplot {

/// How directions are drawn.
enum class Strategy {
  cosine,          ///< cos theta_i / pi about the normal of the mesosurface
  half_vector,     ///< omega_o mirrored at a normal with the density D(m) (m.g)
  visible_normals, ///< omega_o mirrored at a normal with the density <o, m> D(m) / sigma(o) (Heitz 2014, Eq. 16)
  heitz_2018,      ///< the same of GGX, where visible_normals are Dupuy and Benyoub's (2023), by Heitz's map (2018)
  kelemen,         ///< what Kelemen and Szirmay-Kalos (2001) do: half_vector, and `complement` by a table
  eon,             ///< what Portsmouth, Kutz and Hill (2024) do for `eon`
};

/// Whether normals are drawn as they are seen.
inline bool draws_visible(Strategy strategy) {
  return strategy == Strategy::visible_normals || strategy == Strategy::heitz_2018;
}

std::string name_of(Strategy strategy);
/// The names that `Sampler` takes, "default" first.
std::vector<std::string> strategy_names();

} // namespace brdfplot
