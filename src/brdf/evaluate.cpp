#include "brdf/evaluate.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace brdfplot {

namespace {

/// Rows are computed in blocks that stay in the first-level cache; each stage visits its model once a block, so that
/// the loop is over concrete code and the number of instantiations is the sum, not the product, of the lists' lengths.
constexpr std::size_t block_size = 256;
using Buffer = std::array<double, block_size>;

struct Side {
  Buffer c, u, t; ///< projected area, c / G1, c Lambda
};

struct Block {
  std::size_t n = 0;
  std::array<Direction, block_size> o, i, m;
  Buffer o_dot_m;
  Side viewer, light;
  Buffer azimuth, density, visibility;
};

void load(std::array<Direction, block_size>& to, const Columns& from, std::size_t first, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) to[k] = {from.x[first + k], from.y[first + k], from.z[first + k]};
}

/// Directions of the block; m is the half vector where none is given but i is.
void load(Block& block, const Batch& batch, std::size_t first, std::size_t n) {
  block.n = n;
  if (batch.o) load(block.o, batch.o, first, n);
  if (batch.i) load(block.i, batch.i, first, n);
  if (batch.m) {
    load(block.m, batch.m, first, n);
  } else if (batch.o && batch.i) {
    for (std::size_t k = 0; k < n; ++k) block.m[k] = half_vector(block.o[k], block.i[k]);
  } else {
    for (std::size_t k = 0; k < n; ++k) block.m[k] = {0, 0, 1};
  }
}

/// c, u and t of one side. `facing`: the normal is taken to face the direction (no m given).
void mask(const Material& material, Block& block, const std::array<Direction, block_size>& omega, Side& side) {
  std::visit(
      [&](const auto& distribution, const auto& masking) {
        for (std::size_t k = 0; k < block.n; ++k) {
          const Projection p = distribution.slopes.project(omega[k]);
          side.c[k] = p.c;
          side.t[k] = 0;
          side.u[k] = 1;
          if (!(p.c > 0)) continue;
          if constexpr (std::remove_cvref_t<decltype(masking)>::has_lambda) {
            // Integrals hold one direction fixed, and Lambda may itself be an integral.
            const bool repeated = k > 0 && omega[k].x == omega[k - 1].x && omega[k].y == omega[k - 1].y &&
                                  omega[k].z == omega[k - 1].z;
            side.t[k] = repeated ? side.t[k - 1] : masking.masked_area(distribution, p, omega[k]);
            side.u[k] = p.c + side.t[k];
          } else {
            const Direction& m = block.m[k];
            const double facing = dot(omega[k], m);
            if (facing > 0 && m.z > 0) side.u[k] = masking.unmasked_area(p, facing, m.z);
          }
        }
      },
      material.distribution, material.masking);
}

/// phi_o - phi_i wrapped to [0, pi]; 0 where one of them is at the normal.
double azimuth_difference(const Direction& o, const Direction& i) {
  return std::atan2(std::fabs(o.x * i.y - o.y * i.x), o.x * i.x + o.y * i.y);
}

/// G2 / (c_o c_i), 0 where it is undefined or a side is hidden.
void shadow(const Material& material, Block& block) {
  mask(material, block, block.o, block.viewer);
  mask(material, block, block.i, block.light);
  std::visit(
      [&](const auto& shadowing) {
        for (std::size_t k = 0; k < block.n; ++k) {
          const MaskedPair pair{block.viewer.c[k],
                                block.viewer.u[k],
                                block.viewer.t[k],
                                block.light.c[k],
                                block.light.u[k],
                                block.light.t[k],
                                azimuth_difference(block.o[k], block.i[k])};
          const bool lit = pair.c_o > 0 && pair.c_i > 0 && dot(block.o[k], block.m[k]) > 0 &&
                           dot(block.i[k], block.m[k]) > 0 && block.m[k].z > 0;
          block.visibility[k] = lit ? shadowing.visibility(pair) : 0;
        }
      },
      material.shadowing);
}

void normals(const Material& material, Block& block) {
  std::visit(
      [&](const auto& distribution) {
        for (std::size_t k = 0; k < block.n; ++k) block.density[k] = distribution.density(block.m[k]);
      },
      material.distribution);
}

/// Multiplies `value` by F(o.m) into the channels of `out`, n apart.
void colour(const Material& material, const Block& block, const Buffer& value, std::size_t stride, double* out) {
  const int channels = material.channels();
  std::visit(
      [&](const auto& fresnel) {
        for (std::size_t k = 0; k < block.n; ++k) {
          const Rgb f = fresnel.reflectance(std::max(0.0, dot(block.o[k], block.m[k])));
          for (int channel = 0; channel < channels; ++channel) {
            const auto index = static_cast<std::size_t>(channel);
            out[index * stride + k] = value[k] == 0 ? 0 : f[index] * value[k];
          }
        }
      },
      material.fresnel);
}

/// Quantities of masking alone: lambda, g1, d_visible.
void evaluate_masking(const Material& material, Quantity quantity, bool has_m, Block& block, double* out) {
  mask(material, block, block.o, block.viewer);
  if (quantity == Quantity::d_visible) normals(material, block);
  const Side& v = block.viewer;
  for (std::size_t k = 0; k < block.n; ++k) {
    const double facing = dot(block.o[k], block.m[k]);
    const bool seen = v.c[k] > 0 && ((facing > 0 && block.m[k].z > 0) || !has_m);
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
  if (quantity == Quantity::p22) {
    std::visit(
        [&](const auto& distribution) {
          for (std::size_t k = 0; k < block.n; ++k) {
            const Direction& m = block.m[k];
            out[k] = m.z > 0 ? distribution.p22(-m.x / m.z, -m.y / m.z) : 0;
          }
        },
        material.distribution);
    return;
  }
  normals(material, block);
  for (std::size_t k = 0; k < block.n; ++k)
    out[k] = block.density[k] == 0 ? 0 : block.density[k] * (quantity == Quantity::d_cos ? block.m[k].z : 1);
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

void evaluate(const Material& material, Quantity quantity, const Batch& batch, double* out) {
  require(material, quantities()[static_cast<std::size_t>(quantity)], bool(batch.o), bool(batch.i), bool(batch.m));
  const bool has_m = batch.m || (batch.o && batch.i);
  Block block;
  for (std::size_t first = 0; first < batch.n; first += block_size) {
    load(block, batch, first, std::min(block_size, batch.n - first));
    double* to = out + first;
    switch (quantity) {
    case Quantity::lambda:
    case Quantity::g1:
    case Quantity::d_visible: evaluate_masking(material, quantity, has_m, block, to); break;
    case Quantity::p22:
    case Quantity::d:
    case Quantity::d_cos: evaluate_normal(material, quantity, block, to); break;
    case Quantity::fresnel: {
      Buffer ones;
      ones.fill(1);
      colour(material, block, ones, batch.n, to);
      break;
    }
    case Quantity::g2:
    case Quantity::brdf:
    case Quantity::brdf_cos: evaluate_pair(material, quantity, block, batch.n, to); break;
    }
  }
}

double evaluate(const Material& material, Quantity quantity, const Direction& o, const std::optional<Direction>& i,
                const std::optional<Direction>& m) {
  const auto columns = [](const std::optional<Direction>& d) { return d ? Columns{&d->x, &d->y, &d->z} : Columns{}; };
  std::array<double, 3> out{};
  evaluate(material, quantity, {1, {&o.x, &o.y, &o.z}, columns(i), columns(m)}, out.data());
  return out[0];
}

} // namespace brdfplot
