/// \file
/// Facets that reflect diffusely (Heitz 2014, section 3.2).
#pragma once

#include "math/direction.hpp"
#include "math/quadrature.hpp"
#include "microfacet/microsurface.hpp"

#include <cstddef>

namespace brdfplot {

/// rho(o, i) = 1 / (pi c_o c_i) int <o,m> <i,m> G2(o, i, m) D(m) dm (Eq. 31, 1/sr): facets that are Lambertian with
/// albedo 1, single scattering, any distribution and any G2; c is the projected area of the mesosurface (cos theta when
/// centred). By quadrature over the normals that face both. 0 where c_o <= 0 or c_i <= 0.
/// The estimate's error bounds the true one; default: a relative error of 1e-10.
Estimate diffuse_brdf(const Microsurface& surface, const Direction& omega_o, const Direction& omega_i,
                      const Tolerance& tolerance = {.relative = 1e-10});

/// Eq. 37, the weak white furnace test for diffuse facets: 1 / (pi c_o) int int <o,m> <i,m> G1(o, m) D(m) dm di over
/// all directions i, which for every m are taken around m. 1 for a masking function that is physically based.
/// Domain c_o > 0. `tolerance` is absolute.
Estimate diffuse_weak_furnace(const Microsurface& surface, const Direction& omega_o, double tolerance);

/// int (m.g) D(m) dm (Heitz 2014, Eq. 9): 1 for a distribution of normals. `tolerance` is absolute.
Estimate ground_area(const Microsurface& surface, double tolerance);

/// A component (0, 1 or 2) of int m D(m) dm, whose product with a direction is what all facets project to it, those
/// that face away counted negative: the normal of the mesosurface, (-mean_x, -mean_y, 1), for a distribution of normals
/// (Akenine-Moller et al. 2018, Eq. 9.22). `tolerance` is absolute. Domain: a finite mean slope.
Estimate sum_of_normals(const Microsurface& surface, std::size_t axis, double tolerance);

} // namespace brdfplot
