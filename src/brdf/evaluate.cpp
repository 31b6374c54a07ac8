#include "brdf/evaluate.hpp"

#include "brdf/diffuse.hpp"
#include "brdf/kernel_choice.hpp"
#include "math/number.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <type_traits>
#include <utility>

namespace brdfplot {

namespace {

/// Rows are computed in blocks that stay in the first-level cache; each stage visits its model once a block, so that
/// the loop is over concrete code and the number of instantiations is the sum, not the product, of the lists' lengths.
constexpr std::size_t block_size = 256;
using Buffer = std::array<double, block_size>;

struct Side {
  Buffer c, s, u, t; ///< projected area, projected roughness, c / G1, c Lambda
};

/// What of a block is already there, for the next quantity.
struct Done {
  bool viewer = false, light = false, visibility = false, density = false, white = false, reflectances = false;
};

struct Block {
  std::size_t n = 0;
  Done done;
  Columns o, i, m;       ///< of the batch, from the first row of the block on; m may be `half`
  bool has_half = false; ///< m is the half vector, which both directions face where it is defined
  Buffer half_x, half_y, half_z;
  Side viewer, light;
  Buffer density, visibility;
  Buffer white; ///< the BRDF of F = 1, where a kernel computes it whole
  std::array<Buffer, 3> reflectances;
};

kernels::Vectors<double> vectors(const Columns& columns) { return {columns.x, columns.y, columns.z}; }

Direction at(const Columns& columns, std::size_t k) { return {columns.x[k], columns.y[k], columns.z[k]}; }

Columns from_row(const Columns& columns, std::size_t first) {
  return columns ? Columns{columns.x + first, columns.y + first, columns.z + first} : Columns{};
}

/// u.v with the rounding of every step added at the end (Ogita, Rump, Oishi 2005): right where the two are all but
/// perpendicular, and the terms cancel.
double careful_dot(const Direction& u, const Direction& v) {
  const double x = u.x * v.x, y = u.y * v.y, z = u.z * v.z;
  const double products = std::fma(u.x, v.x, -x) + std::fma(u.y, v.y, -y) + std::fma(u.z, v.z, -z);
  const auto low = [](double a, double b, double sum) {
    const double part = sum - a;
    return (a - (sum - part)) + (b - part);
  };
  const double xy = x + y, xyz = xy + z;
  return xyz + (low(x, y, xy) + low(xy, z, xyz) + products);
}

void halve(Block& block) {
  for (std::size_t k = 0; k < block.n; ++k) {
    const double x = block.o.x[k] + block.i.x[k];
    const double y = block.o.y[k] + block.i.y[k];
    const double z = block.o.z[k] + block.i.z[k];
    const double norm2 = x * x + y * y + z * z; // of unit vectors: 0 or no less than 1e-33
    const double scale = norm2 > 0 ? 1 / std::sqrt(norm2) : 0;
    block.half_x[k] = x * scale;
    block.half_y[k] = y * scale;
    block.half_z[k] = z * scale;
  }
  block.m = {block.half_x.data(), block.half_y.data(), block.half_z.data()};
}

/// Directions of the block; m is the half vector where none is given but i is, else the normal.
void load(Block& block, const Batch& batch, std::size_t first) {
  block.n = std::min(block_size, batch.n - first);
  block.done = {};
  block.o = from_row(batch.o, first);
  block.i = from_row(batch.i, first);
  block.m = from_row(batch.m, first);
  if (batch.m) return;
  block.has_half = batch.o && batch.i;
  if (block.has_half) return halve(block);
  block.half_x.fill(0);
  block.half_y.fill(0);
  block.half_z.fill(1);
  block.m = {block.half_x.data(), block.half_y.data(), block.half_z.data()};
}

/// c Lambda or c / G1 of a formula, which are wanted where the direction is above the mesosurface and sees the facet.
void mask_by_formula(const CustomMasking& masking, const SlopeMap& map, const Block& block, const Columns& omega,
                     Side& side) {
  for (std::size_t k = 0; k < block.n; ++k) {
    const Projection p{side.c[k], side.s[k]};
    const Direction direction = at(omega, k), m = at(block.m, k);
    side.u[k] = 1;
    side.t[k] = 0;
    if (!(p.c > 0)) continue;
    if (masking.has_lambda)
      side.t[k] = masking.masked_area(map, p, direction);
    else if (dot(direction, m) > 0 && m.z > 0)
      side.u[k] = masking.unmasked_area(map, p, direction, m);
  }
}

template <class M>
void mask_mixture(const Mixture& mixture, const M& masking, const Block& block, const Columns& omega, Side& side);

/// t or u of one side, whose c and s are known.
template <class D, class M>
void mask_by(const D& distribution, const M& masking, const Block& block, const Columns& omega, Side& side) {
  const std::size_t n = block.n;
  if constexpr (std::is_same_v<M, CustomMasking>) {
    mask_by_formula(masking, distribution.slopes, block, omega, side);
  } else if constexpr (M::has_lambda && std::is_same_v<D, Mixture>) {
    mask_mixture(distribution, masking, block, omega, side);
  } else if constexpr (requires {
                         masking.masked_areas(distribution, side.c.data(), side.s.data(), side.t.data(), n);
                       }) {
    masking.masked_areas(distribution, side.c.data(), side.s.data(), side.t.data(), n);
  } else if constexpr (M::has_lambda) {
    for (std::size_t k = 0; k < n; ++k) side.t[k] = masking.masked_area({side.c[k], side.s[k]}, at(omega, k));
  } else {
    for (std::size_t k = 0; k < n; ++k) {
      const double facing = careful_dot(at(omega, k), at(block.m, k));
      side.u[k] = facing > 0 ? masking.unmasked_area({side.c[k], side.s[k]}, facing, block.m.z[k]) : 1;
    }
  }
}

/// Masked areas add.
template <class M>
void mask_mixture(const Mixture& mixture, const M& masking, const Block& block, const Columns& omega, Side& side) {
  std::fill_n(side.t.data(), block.n, 0.0);
  Side own;
  for (const auto& part : mixture.parts) {
    kernels::project(part.slopes().stretch(), vectors(omega), own.c.data(), own.s.data(), block.n);
    std::visit([&](const auto& distribution) { mask_by(distribution, masking, block, omega, own); }, part.distribution);
    for (std::size_t k = 0; k < block.n; ++k) side.t[k] += part.weight * own.t[k];
  }
}

/// c, s, u and t of one side, unless `done`. t is 0 and u meaningless where c <= 0.
void mask(const Material& material, const Block& block, const Columns& omega, Side& side, bool& done) {
  if (std::exchange(done, true)) return;
  const std::size_t n = block.n;
  kernels::project(material.slopes().stretch(), vectors(omega), side.c.data(), side.s.data(), n);
  std::visit([&](const auto& distribution, const auto& masking) { mask_by(distribution, masking, block, omega, side); },
             material.distribution, material.masking);
  if (!material.has_lambda()) return;
  for (std::size_t k = 0; k < n; ++k) side.u[k] = side.c[k] + side.t[k];
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

/// G2 / (c_o c_i), 0 where it is undefined or a side is hidden.
void shadow(const Material& material, Block& block) {
  if (std::exchange(block.done.visibility, true)) return;
  mask(material, block, block.o, block.viewer, block.done.viewer);
  mask(material, block, block.i, block.light, block.done.light);
  const SlopeMap& map = material.slopes();
  std::visit(
      [&](const auto& shadowing) {
        const Side& v = block.viewer;
        const Side& l = block.light;
        for (std::size_t k = 0; k < block.n; ++k) {
          const Direction o = at(block.o, k), i = at(block.i, k), m = at(block.m, k);
          const bool facing = block.has_half || (careful_dot(o, m) > 0 && careful_dot(i, m) > 0);
          const bool lit = v.c[k] > 0 && l.c[k] > 0 && facing && m.z > 0;
          const DirectionPair pair = direction_pair(shadowing, map, o, {v.c[k], v.s[k]}, i, {l.c[k], l.s[k]});
          const double visibility = shadowing.visibility({v.c[k], v.u[k], v.t[k], l.c[k], l.u[k], l.t[k], pair});
          block.visibility[k] = lit ? visibility : 0;
        }
      },
      material.shadowing);
}

void normals(const Material& material, Block& block) {
  if (std::exchange(block.done.density, true)) return;
  std::visit([&](const auto& distribution) { distribution.densities(vectors(block.m), block.density.data(), block.n); },
             material.distribution);
}

/// F(o.m) of every channel.
void reflect(const Material& material, Block& block) {
  if (std::exchange(block.done.reflectances, true)) return;
  const auto channels = static_cast<std::size_t>(material.channels());
  Buffer c;
  for (std::size_t k = 0; k < block.n; ++k) c[k] = std::clamp(dot(at(block.o, k), at(block.m, k)), 0.0, 1.0);
  std::visit(
      [&](const auto& fresnel) {
        for (std::size_t channel = 0; channel < channels; ++channel)
          fresnel.reflectances(c.data(), channel, block.reflectances[channel].data(), block.n);
      },
      material.fresnel);
}

/// Multiplies `value` by F(o.m) into the channels of `out`, n apart.
void colour(const Material& material, Block& block, const Buffer& value, std::size_t stride, double* out) {
  reflect(material, block);
  const auto channels = static_cast<std::size_t>(material.channels());
  for (std::size_t channel = 0; channel < channels; ++channel) {
    const Buffer& f = block.reflectances[channel];
    double* const to = out + channel * stride;
    for (std::size_t k = 0; k < block.n; ++k) to[k] = value[k] == 0 ? 0 : f[k] * value[k];
  }
}

/// Quantities of masking alone: lambda, g1, d_visible.
void evaluate_masking(const Material& material, Quantity quantity, bool has_m, Block& block, double* out) {
  mask(material, block, block.o, block.viewer, block.done.viewer);
  if (quantity == Quantity::d_visible) normals(material, block);
  const Side& v = block.viewer;
  for (std::size_t k = 0; k < block.n; ++k) {
    const double facing = careful_dot(at(block.o, k), at(block.m, k));
    const bool seen = v.c[k] > 0 && ((facing > 0 && block.m.z[k] > 0) || !has_m);
    if (quantity == Quantity::lambda)
      out[k] = v.c[k] > 0 ? v.t[k] / v.c[k] : infinity;
    else if (quantity == Quantity::g1)
      out[k] = seen ? v.c[k] / v.u[k] : 0;
    else
      out[k] = seen && block.density[k] > 0 ? block.density[k] * (facing / v.u[k]) : 0;
  }
}

/// Quantities of the normal alone: p22, d, d_cos.
void evaluate_normal(const Material& material, Quantity quantity, Block& block, double* out) {
  if (quantity == Quantity::p22 && !density_kernel(material)) {
    std::visit(
        [&](const auto& distribution) {
          for (std::size_t k = 0; k < block.n; ++k) {
            const Direction m = at(block.m, k);
            out[k] = m.z > 0 ? distribution.p22(-m.x / m.z, -m.y / m.z) : 0;
          }
        },
        material.distribution);
    return;
  }
  normals(material, block);
  for (std::size_t k = 0; k < block.n; ++k) {
    const double z = block.m.z[k], d = block.density[k];
    // P22 = D z^4 of the kernel, which knows the normal as it is: the slope would be a rounded one.
    const double value = quantity == Quantity::p22 ? (d * (z * z)) * (z * z) : quantity == Quantity::d_cos ? d * z : d;
    out[k] = d == 0 ? 0 : value;
  }
}

/// brdf and brdf_cos by the whole kernel.
void evaluate_whole(const Material& material, const WholeKernel& kernel, Quantity quantity, Block& block,
                    std::size_t stride, double* out) {
  const kernels::Stretch stretch = material.slopes().stretch();
  if (!std::exchange(block.done.white, true))
    kernels::brdf(stretch, kernel.first, kernel.second, vectors(block.o), vectors(block.i), block.white.data(),
                  block.n);
  Buffer weighted;
  if (quantity == Quantity::brdf_cos) {
    kernels::project(stretch, vectors(block.i), block.light.c.data(), block.light.s.data(), block.n);
    for (std::size_t k = 0; k < block.n; ++k) weighted[k] = block.white[k] * std::max(0.0, block.light.c[k]);
  }
  const Buffer& value = quantity == Quantity::brdf_cos ? weighted : block.white;
  if (std::holds_alternative<NoFresnel>(material.fresnel))
    std::copy_n(value.data(), block.n, out);
  else
    colour(material, block, value, stride, out);
}

/// brdf and brdf_cos of facets that are no mirrors: an integral a row.
void evaluate_diffuse(const Material& material, Quantity quantity, const Block& block, double* out) {
  constexpr double accepted = 1e-9;
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction i = at(block.i, k);
    const Estimate brdf = facet_brdf(material, at(block.o, k), i);
    if (!(brdf.error <= accepted * std::fabs(brdf.value)))
      throw AccuracyError("brdf", "reached an error estimate of " + format_number(brdf.error) + " for a value of " +
                                      format_number(brdf.value) + " (asked: a relative error of 1e-9)");
    out[k] = brdf.value * (quantity == Quantity::brdf_cos ? std::max(0.0, material.slopes().project(i).c) : 1);
  }
}

/// brdf and brdf_cos where only the form of shadowing has no kernel: the BRDF with the masking of heights alone, times
/// how much more the two directions see. The half vector is not rounded on the way.
void evaluate_by_heights(const Material& material, kernels::Distribution distribution, Quantity quantity, Block& block,
                         std::size_t stride, double* out) {
  shadow(material, block);
  const Side& v = block.viewer;
  const Side& l = block.light;
  Buffer value;
  kernels::brdf(material.slopes().stretch(), distribution, kernels::Shadowing::height_correlated, vectors(block.o),
                vectors(block.i), value.data(), block.n);
  for (std::size_t k = 0; k < block.n; ++k) {
    const double inverse_by_heights = v.c[k] * l.c[k] + l.c[k] * v.t[k] + v.c[k] * l.t[k];
    const double ratio = block.visibility[k] * inverse_by_heights;
    value[k] = value[k] == 0 || ratio == 0 ? 0 : value[k] * (quantity == Quantity::brdf_cos ? ratio * l.c[k] : ratio);
  }
  colour(material, block, value, stride, out);
}

/// Quantities of both directions: g2, brdf, brdf_cos.
void evaluate_pair(const Material& material, Quantity quantity, Block& block, std::size_t stride, double* out) {
  shadow(material, block);
  const auto& light = block.light;
  if (quantity == Quantity::g2) {
    for (std::size_t k = 0; k < block.n; ++k) out[k] = block.visibility[k] * block.viewer.c[k] * light.c[k];
    return;
  }
  normals(material, block);
  Buffer value;
  for (std::size_t k = 0; k < block.n; ++k) {
    const double weight = block.visibility[k] * (quantity == Quantity::brdf_cos ? light.c[k] : 1);
    value[k] = block.density[k] == 0 || weight == 0 ? 0 : 0.25 * block.density[k] * weight;
  }
  colour(material, block, value, stride, out);
}

} // namespace

const std::vector<QuantityInfo>& quantities() {
  static const std::vector<QuantityInfo> all = {
      {Quantity::lambda, "lambda", "Lambda(o), Smith's auxiliary function", {.o = true}, false},
      {Quantity::p22, "p22", "density of slopes at the slope of m", {.m = true}, false},
      {Quantity::d, "d", "D(m), distribution of normals, 1/sr", {.m = true}, false},
      {Quantity::d_cos, "d_cos", "(m.g) D(m), 1/sr", {.m = true}, false},
      {Quantity::g1, "g1", "G1(o, m), masking", {.o = true, .m = true}, false},
      {Quantity::g2, "g2", "G2(o, i, m), masking and shadowing", {.o = true, .i = true}, false},
      {Quantity::d_visible,
       "d_visible",
       "D_o(m), distribution of visible normals, 1/sr",
       {.o = true, .m = true},
       false},
      {Quantity::fresnel, "fresnel", "F(o.m)", {.o = true, .m = true}, true},
      {Quantity::brdf, "brdf", "rho(o, i), 1/sr", {.o = true, .i = true}, true},
      {Quantity::brdf_cos, "brdf_cos", "rho(o, i) cos theta_i, 1/sr", {.o = true, .i = true}, true},
  };
  return all;
}

void require(const Material& material, const QuantityInfo& info, bool has_o, bool has_i, bool has_m) {
  const std::string name = "\"" + info.name + "\" ";
  if (info.quantity == Quantity::lambda && !material.has_lambda())
    throw InputError(material.name,
                     name + "is not defined: the masking function depends on the normal and has no Lambda");
  if (info.needs.o && !has_o) throw InputError(material.name, name + "needs omega_o: theta_o [phi_o] or x_o y_o z_o");
  if (info.needs.i && !has_i) throw InputError(material.name, name + "needs omega_i: theta_i [phi_i] or x_i y_i z_i");
  const bool facing = info.quantity == Quantity::g1 && material.has_lambda();
  if (info.needs.m && !has_m && !(has_o && has_i) && !facing)
    throw InputError(
        material.name,
        name + "needs omega_m: theta_m [phi_m] or x_m y_m z_m, or omega_o with omega_i for their half vector");
}

bool is_told(Quantity quantity, double value) {
  return std::isfinite(value) || (quantity == Quantity::lambda && value == infinity);
}

Batch used_by(Quantity quantity, const Batch& batch) {
  Batch used = batch;
  if (quantity == Quantity::brdf || quantity == Quantity::brdf_cos) used.m = {};
  return used;
}

namespace {

/// Which kernels compute the BRDF of a batch.
struct BrdfKernels {
  std::optional<WholeKernel> whole;
  std::optional<kernels::Distribution> by_heights;
};

/// One quantity of a block.
void evaluate_block(const Material& material, const BrdfKernels& kernel, Quantity quantity, const Batch& batch,
                    Block& block, double* out) {
  switch (quantity) {
  case Quantity::lambda:
  case Quantity::g1:
  case Quantity::d_visible: return evaluate_masking(material, quantity, batch.m || (batch.o && batch.i), block, out);
  case Quantity::p22:
  case Quantity::d:
  case Quantity::d_cos: return evaluate_normal(material, quantity, block, out);
  case Quantity::fresnel: {
    Buffer ones;
    ones.fill(1);
    return colour(material, block, ones, batch.n, out);
  }
  case Quantity::g2: return evaluate_pair(material, quantity, block, batch.n, out);
  case Quantity::brdf:
  case Quantity::brdf_cos: break;
  }
  if (material.facet != Facet::specular)
    evaluate_diffuse(material, quantity, block, out);
  else if (kernel.whole)
    evaluate_whole(material, *kernel.whole, quantity, block, batch.n, out);
  else if (kernel.by_heights)
    evaluate_by_heights(material, *kernel.by_heights, quantity, block, batch.n, out);
  else
    evaluate_pair(material, quantity, block, batch.n, out);
}

/// Those of `wanted` that are used_by() with a normal, or those without.
void evaluate_those(const Material& material, std::span<const Wanted> wanted, const Batch& batch, bool with_normal) {
  const auto is_of_those = [&](Quantity quantity) { return bool(used_by(quantity, batch).m) == with_normal; };
  Batch used = batch;
  if (!with_normal) used.m = {};
  const BrdfKernels kernel = used.m ? BrdfKernels{} : BrdfKernels{whole_kernel(material), smith_kernel(material)};
  Block block;
  for (std::size_t first = 0; first < used.n; first += block_size) {
    load(block, used, first);
    for (const auto& [quantity, out] : wanted)
      if (is_of_those(quantity)) evaluate_block(material, kernel, quantity, used, block, out + first);
  }
}

} // namespace

void evaluate(const Material& material, std::span<const Wanted> wanted, const Batch& batch) {
  bool with_normal = false, without = false;
  for (const auto& [quantity, out] : wanted) {
    const Batch used = used_by(quantity, batch);
    require(material, quantities()[static_cast<std::size_t>(quantity)], bool(used.o), bool(used.i), bool(used.m));
    (used.m ? with_normal : without) = true;
  }
  if (with_normal) evaluate_those(material, wanted, batch, true);
  if (without) evaluate_those(material, wanted, batch, false);
}

void evaluate(const Material& material, Quantity quantity, const Batch& batch,
              double* out) { // NOLINT(readability-non-const-parameter): Wanted has it
  const Wanted wanted{quantity, out};
  evaluate(material, std::span(&wanted, 1), batch);
}

double evaluate(const Material& material, Quantity quantity, const Direction& o, const std::optional<Direction>& i,
                const std::optional<Direction>& m) {
  const auto columns = [](const std::optional<Direction>& d) { return d ? Columns{&d->x, &d->y, &d->z} : Columns{}; };
  std::array<double, 3> out{};
  evaluate(material, quantity, {1, {&o.x, &o.y, &o.z}, columns(i), columns(m)}, out.data());
  return out[0];
}

} // namespace brdfplot
