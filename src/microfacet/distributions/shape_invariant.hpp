/// \file
/// Every shape-invariant distribution of slopes, from its 1D shape alone (Heitz 2014, sections 5.3-5.5).
#pragma once

#include "microfacet/slopes.hpp"

#include <cmath>
#include <cstddef>

namespace brdfplot {

/// A distribution made of a unit-roughness shape and a map of slopes. `Shape` has
/// - `static ModelSpec about()`: type, doc, source, and the shape's own parameters where it has some;
/// - `static Shape from(const Values&)`, or `Made<Shape>`, where it has parameters;
/// - `double density(double t2)`: slope density at squared norm t2, Eq. 65 with alpha = 1;
/// - `double scaled_density(double n2, double z2)`: density(n2 / z2) / z2^2, for z2 -> 0 as finite as D is;
/// - `double a_lambda(double a)`: a Lambda(a), finite for a -> 0, a in [0, infinity];
/// - where there are kernels for it: `masked_areas` and `densities`, the same over arrays, and `kernel`, its name
/// there;
/// - `double slope_within(double u)`, where it is a closed form: the slope within which a share u of the ground lies, u
/// in [0, 1), at unit roughness; and `visible_slope(c, s, u1, u2)`, where visible slopes (visible_normals.hpp) are one:
/// both without rejection (sampling/);
/// - `radii`, ascending, where integrals over slopes of unit roughness are to be cut at some norms;
/// - `gaussian_slopes` where they are Gaussian, so that variances add; `infinite_variance` where theirs is;
/// - where random microsurfaces have these slopes: `simulated_surface`, their type (simulation/surface.hpp), and
/// `sample_visible_slope`, for random walks (microfacet/visible_normals.hpp).
/// The functions of a shape without parameters are static, and the shape takes no room.
template <class Shape>
struct ShapeInvariant {
  SlopeMap slopes;
  [[no_unique_address]] Shape shape;

  static ModelSpec spec() {
    ModelSpec spec = Shape::about();
    const std::vector<ParameterSpec> map = SlopeMap::parameters();
    spec.parameters.insert(spec.parameters.begin(), map.begin(), map.end());
    spec.alternatives = SlopeMap::alternatives();
    const std::vector<ParameterSpec> moments = SlopeMap::moments();
    if constexpr (requires { Shape::gaussian_slopes; }) {
      spec.parameters.insert(spec.parameters.begin() + static_cast<std::ptrdiff_t>(map.size()), moments.begin(),
                             moments.end());
      for (auto& group : SlopeMap::moment_alternatives()) spec.alternatives.push_back(std::move(group));
    } else {
      constexpr bool infinite = requires { Shape::infinite_variance; };
      for (const ParameterSpec& moment : moments)
        spec.refused.emplace_back(moment.key, "the slopes of \"" + spec.type + "\" " +
                                                  (infinite ? "have no finite variance" : "are not Gaussian") +
                                                  ", and their roughness does not follow from one; accepted in "
                                                  "\"beckmann\" alone");
    }
    return spec;
  }
  static Made<ShapeInvariant> from(const Values& values) {
    if (auto error = SlopeMap::problem(values)) return std::move(*error);
    const SlopeMap map = SlopeMap::from(values);
    if (auto error = map.problem()) return std::move(*error);
    if constexpr (requires { std::get<ParameterError>(Shape::from(values)); }) {
      auto made = Shape::from(values);
      if (auto* error = std::get_if<ParameterError>(&made)) return std::move(*error);
      return ShapeInvariant{map, std::get<Shape>(std::move(made))};
    } else if constexpr (requires { Shape::from(values); }) {
      return ShapeInvariant{map, Shape::from(values)};
    } else {
      return ShapeInvariant{map, Shape{}};
    }
  }
  static constexpr bool shape_invariant = true;
  using UnitShape = Shape;

  /// P22 at a slope (Eqs. 74, 95; 1).
  double p22(double slope_x, double slope_y) const {
    return shape.density(slopes.scaled_norm2({-slope_x, -slope_y, 1})) / slopes.determinant();
  }

  /// D(omega_m) = P22 / cos^4 (Eq. 64; 1/sr); 0 for normals below the geometric surface.
  double density(const Direction& omega_m) const {
    if (!(omega_m.z > 0)) return 0;
    return shape.scaled_density(slopes.scaled_norm2(omega_m), omega_m.z * omega_m.z) / slopes.determinant();
  }

  /// c Lambda(a) = s a Lambda(a), the area that the masked facets project; finite at grazing, 0 at the normal. Below
  /// the horizon of the mesosurface Lambda(-a) = -1 - Lambda(a), so that it is |c| more.
  double masked_area(const Projection& p) const {
    const double below = p.c < 0 ? -p.c : 0;
    return p.s > 0 ? below + p.s * shape.a_lambda(std::fabs(p.c) / p.s) : below;
  }

  /// masked_area() of n projections.
  void masked_areas(const double* c, const double* s, double* t, std::size_t n) const {
    if constexpr (requires { Shape::masked_areas(c, s, t, n); })
      Shape::masked_areas(c, s, t, n);
    else
      for (std::size_t k = 0; k < n; ++k) t[k] = masked_area({c[k], s[k]});
  }

  /// density() of n normals.
  void densities(const kernels::Vectors<double>& m, double* d, std::size_t n) const {
    if constexpr (requires { Shape::densities(slopes.stretch(), m, d, n); })
      Shape::densities(slopes.stretch(), m, d, n);
    else
      for (std::size_t k = 0; k < n; ++k) d[k] = density({m.x[k], m.y[k], m.z[k]});
  }
};

} // namespace brdfplot
