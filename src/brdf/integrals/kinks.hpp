/// \file
/// Where the factors of a BRDF about the half vector are not smooth, as its models declare it.
#pragma once

#include "integrate/slope_domain.hpp"
#include "microfacet/fresnel.hpp"
#include "microfacet/microsurface.hpp"

#include <cstddef>
#include <vector>

namespace brdfplot {

/// What an integral over the light has to know of a BRDF about the half vector, at one viewer.
struct HalfVectorKinks {
  std::vector<Switch> switches{};     ///< functions of the half vector that change their sign at a kink
  bool in_plane_of_incidence = false; ///< a kink where azimuths are equal or opposite
  bool symmetric = false;             ///< the mirror image at the plane of incidence changes nothing
};

/// Which channels of a colour, of `count` from `first` on.
struct ChannelRange {
  std::size_t first = 0;
  std::size_t count = 1;
};

/// Whether a masking function is a formula, which may depend on anything.
bool is_formula(const Masking& masking);
/// Whether the distribution has the mirror image of omega_o's plane of incidence.
bool is_mirrored(const Distribution& distribution, const Direction& omega_o);
/// The same of all about a microsurface: a masking function that is a formula may depend on anything.
bool is_mirrored(const Microsurface& surface, const Direction& omega_o);
/// Whether every viewer's azimuth sees the same.
bool is_isotropic(const Distribution& distribution);
/// Whether it has the planes y = 0 and x = 0 for mirrors.
bool is_aligned(const Distribution& distribution);

/// The kinks of G1(o, m) as a function of the normal m.
std::vector<Switch> masking_kinks(const Microsurface& surface, const Direction& omega_o);
/// Whether one of them is the line u_1 = -a of each component's frame, none of which has radii, beside masking_kinks().
bool has_masking_line(const Microsurface& surface);

/// The kinks of G2 F, h the half vector. References to `surface` are kept.
HalfVectorKinks kinks(const Microsurface& surface, const Fresnel& fresnel, const Direction& omega_o,
                      const ChannelRange& channels);

/// The cosines of viewers at which the masking of an isotropic surface jumps or bends, whatever the normal.
std::vector<double> kinks_of_viewers(const Microsurface& surface);

/// Those of F(o.h) alone.
std::vector<Switch> fresnel_kinks(const Fresnel& fresnel, const Direction& omega_o, const ChannelRange& channels);

} // namespace brdfplot
