#include "brdf/blocks/surface_block.hpp"

#include "math/kernels/directions.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace brdfplot {

namespace {

/// o.h = i.h = |o + i| / 2 of unit vectors. Near grazing, where o + i is short, the rounding of h would be much of o.h
/// as a product. Relative error a few roundings and those of the components of o and i over |o + i|.
void half_cosines(const Columns& o, const Columns& i, Buffer& out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const Direction one = o[k], other = i[k];
    const double x = one.x + other.x, y = one.y + other.y, z = one.z + other.z;
    out[k] = 0.5 * std::sqrt(x * x + y * y + z * z);
  }
}

/// omega.m of the facets, omega one of the block's directions.
void compute_facing(const SurfaceBlock& block, const Columns& omega, Buffer& out) {
  if (block.has_half)
    half_cosines(block.o, block.i, out, block.n);
  else
    kernels::careful_dots(vectors(omega), vectors(block.m), out.data(), block.n);
}

/// c Lambda or c / G1 of a formula, which are wanted where the direction is above the mesosurface and sees the facet.
void mask_by_formula(const CustomMasking& masking, const SlopeMap& map, const SurfaceBlock& block, const Columns& omega,
                     MaskedSide& side) {
  Buffer facing;
  if (!masking.has_lambda) compute_facing(block, omega, facing);
  for (std::size_t k = 0; k < block.n; ++k) {
    const Projection p{side.c[k], side.s[k]};
    const Direction direction = omega[k], m = block.m[k];
    side.unmasked_area[k] = 1;
    side.masked_area[k] = 0;
    if (!(p.c > 0)) continue;
    if (masking.has_lambda)
      side.masked_area[k] = masking.masked_area(map, p, direction);
    else if (facing[k] > 0 && m.z > 0)
      side.unmasked_area[k] = masking.unmasked_area(map, p, direction, m, facing[k]);
  }
}

template <class M>
void mask_mixture(const Mixture& mixture, const M& masking, const SurfaceBlock& block, const Columns& omega,
                  MaskedSide& side);

/// The masked or the unmasked area of one side, whose c and s are known.
template <class D, class M>
void mask_by(const D& distribution, const M& masking, const SurfaceBlock& block, const Columns& omega,
             MaskedSide& side) {
  const std::size_t n = block.n;
  if constexpr (std::is_same_v<M, CustomMasking>) {
    mask_by_formula(masking, distribution.slopes, block, omega, side);
  } else if constexpr (M::has_lambda && std::is_same_v<D, Mixture>) {
    mask_mixture(distribution, masking, block, omega, side);
  } else if constexpr (requires {
                         masking.masked_areas(distribution, side.c.data(), side.s.data(), side.masked_area.data(), n);
                       }) {
    masking.masked_areas(distribution, side.c.data(), side.s.data(), side.masked_area.data(), n);
  } else if constexpr (M::has_lambda) {
    // Seen from below Lambda(-a) = -1 - Lambda(a), as of the distributions.
    for (std::size_t k = 0; k < n; ++k)
      side.masked_area[k] = masking.masked_area({std::fabs(side.c[k]), side.s[k]}, omega[k]) + std::fmax(-side.c[k], 0);
  } else {
    Buffer facing;
    compute_facing(block, omega, facing);
    for (std::size_t k = 0; k < n; ++k)
      side.unmasked_area[k] =
          facing[k] > 0 ? masking.unmasked_area({side.c[k], side.s[k]}, facing[k], block.m.z[k]) : 1;
  }
}

/// Masked areas add.
template <class M>
void mask_mixture(const Mixture& mixture, const M& masking, const SurfaceBlock& block, const Columns& omega,
                  MaskedSide& side) {
  std::fill_n(side.masked_area.data(), block.n, 0.0);
  MaskedSide own;
  for (const auto& part : mixture.parts) {
    kernels::project(part.slopes().stretch(), vectors(omega), own.c.data(), own.s.data(), block.n);
    std::visit([&](const auto& distribution) { mask_by(distribution, masking, block, omega, own); }, part.distribution);
    for (std::size_t k = 0; k < block.n; ++k) side.masked_area[k] += part.weight * own.masked_area[k];
  }
}

/// The horizontal part of a direction, by a power of two away from where products of components are 0.
Vec2 scaled(const Vec2& v) {
  const double scale = std::fabs(v[0]) + std::fabs(v[1]) < 1e-100 ? 0x1p600 : 1;
  return {scale * v[0], scale * v[1]};
}

/// phi_o - phi_i wrapped to [0, pi]; 0 where one of them is at the normal, which has no azimuth: atan2 would go by the
/// signs of zeros.
double azimuth_difference(const Vec2& omega_o, const Vec2& omega_i) {
  const Vec2 o = scaled(omega_o), i = scaled(omega_i);
  if ((o[0] == 0 && o[1] == 0) || (i[0] == 0 && i[1] == 0)) return 0;
  return std::atan2(std::fabs(o[0] * i[1] - o[1] * i[0]), o[0] * i[0] + o[1] * i[1]);
}

/// The pair as the factor of a form of shadowing sees it, if it has one.
template <class S>
DirectionPair direction_pair(const S& shadowing, const SlopeMap& map, const Direction& o, const Projection& viewer,
                             const Direction& i, const Projection& light) {
  if constexpr (!S::needs_azimuth)
    return {};
  else if (azimuth_after_stretching(shadowing.lambda))
    return {azimuth_difference(map.on_unit_surface(o), map.on_unit_surface(i)), viewer, light};
  else
    return {azimuth_difference({o.x, o.y}, {i.x, i.y}), viewer, light};
}

/// Whether a form of shadowing brings its own c Lambda, whatever masks.
template <class S>
constexpr bool masks_itself = requires(const Projection& p, const Direction& omega) {
  S::masked_area(p, omega);
};

} // namespace

void set_directions(SurfaceBlock& block, std::size_t n, const Columns& o, const Columns& i, const Columns& m) {
  block.n = n;
  block.done = {};
  block.o = o;
  block.i = i;
  block.m = m;
  block.has_half = !m && o && i;
  if (m) return;
  if (block.has_half) {
    kernels::half_vectors(vectors(o), vectors(i), block.half_x.data(), block.half_y.data(), block.half_z.data(), n);
  } else {
    block.half_x.fill(0);
    block.half_y.fill(0);
    block.half_z.fill(1);
  }
  block.m = {block.half_x.data(), block.half_y.data(), block.half_z.data()};
}

namespace {

/// Computes c and s of `omega`, one of the block's directions, unless they are there.
void project_side(const Microsurface& surface, const SurfaceBlock& block, const Columns& omega, MaskedSide& side,
                  SurfaceBlock::Side& done) {
  if (std::exchange(done.projected, true)) return;
  kernels::project(surface.slopes().stretch(), vectors(omega), side.c.data(), side.s.data(), block.n);
}

/// Computes its masking too.
void compute_side(const Microsurface& surface, const SurfaceBlock& block, const Columns& omega, MaskedSide& side,
                  SurfaceBlock::Side& done) {
  if (std::exchange(done.masked, true)) return;
  project_side(surface, block, omega, side, done);
  const std::size_t n = block.n;
  std::visit([&](const auto& distribution, const auto& masking) { mask_by(distribution, masking, block, omega, side); },
             surface.distribution, surface.masking);
  if (!surface.has_lambda()) return;
  for (std::size_t k = 0; k < n; ++k) side.unmasked_area[k] = side.c[k] + side.masked_area[k];
}

} // namespace

void compute_masking(const Microsurface& surface, SurfaceBlock& block) {
  compute_side(surface, block, block.o, block.viewer, block.done.viewer);
}

void compute_both_maskings(const Microsurface& surface, SurfaceBlock& block) {
  compute_side(surface, block, block.o, block.viewer, block.done.viewer);
  compute_side(surface, block, block.i, block.light, block.done.light);
}

void compute_visibility(const Microsurface& surface, SurfaceBlock& block) {
  if (std::exchange(block.done.visibility, true)) return;
  const SlopeMap& map = surface.slopes();
  Buffer facing_viewer, facing_light;
  if (!block.has_half) {
    kernels::careful_dots(vectors(block.o), vectors(block.m), facing_viewer.data(), block.n);
    kernels::careful_dots(vectors(block.i), vectors(block.m), facing_light.data(), block.n);
  }
  std::visit(
      [&]<class S>(const S& shadowing) {
        const MaskedSide& v = block.viewer;
        const MaskedSide& l = block.light;
        if constexpr (masks_itself<S>) {
          project_side(surface, block, block.o, block.viewer, block.done.viewer);
          project_side(surface, block, block.i, block.light, block.done.light);
        } else {
          compute_both_maskings(surface, block);
        }
        for (std::size_t k = 0; k < block.n; ++k) {
          const Direction o = block.o[k], i = block.i[k];
          const bool facing = block.has_half || (facing_viewer[k] > 0 && facing_light[k] > 0);
          const bool lit = v.c[k] > 0 && l.c[k] > 0 && facing && block.m.z[k] > 0;
          const Projection viewer{v.c[k], v.s[k]}, light{l.c[k], l.s[k]};
          const DirectionPair pair = direction_pair(shadowing, map, o, viewer, i, light);
          MaskedPair masked;
          if constexpr (masks_itself<S>) {
            const double t_o = S::masked_area(viewer, o), t_i = S::masked_area(light, i);
            masked = {v.c[k], v.c[k] + t_o, t_o, l.c[k], l.c[k] + t_i, t_i, pair};
          } else {
            masked = {v.c[k], v.unmasked_area[k], v.masked_area[k], l.c[k], l.unmasked_area[k], l.masked_area[k], pair};
          }
          const double visibility = shadowing.visibility(masked);
          block.visibility[k] = lit ? visibility : 0;
        }
      },
      surface.shadowing);
}

void compute_densities(const Microsurface& surface, SurfaceBlock& block) {
  if (std::exchange(block.done.densities, true)) return;
  std::visit([&](const auto& distribution) { distribution.densities(vectors(block.m), block.density.data(), block.n); },
             surface.distribution);
}

void compute_reflectances(const Fresnel& fresnel, SurfaceBlock& block) {
  if (std::exchange(block.done.reflectances, true)) return;
  Buffer c;
  for (std::size_t k = 0; k < block.n; ++k) c[k] = std::clamp(dot(block.o[k], block.m[k]), 0.0, 1.0);
  std::visit(
      [&](const auto& of) {
        for (std::size_t channel = 0; channel < (of.coloured() ? 3U : 1U); ++channel)
          of.reflectances(c.data(), channel, block.reflectances[channel].data(), block.n);
      },
      fresnel);
}

} // namespace brdfplot
