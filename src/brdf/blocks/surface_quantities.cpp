#include "brdf/blocks/surface_quantities.hpp"

#include "brdf/blocks/kernel_choice.hpp"
#include "brdf/blocks/surface_block.hpp"
#include "math/kernels/directions.hpp"

#include <algorithm>

namespace brdfplot {

namespace {

/// Quantities of masking alone: lambda, g1, d_visible.
void evaluate_masking(const Microsurface& surface, Quantity quantity, bool has_m, SurfaceBlock& block, double* out) {
  compute_masking(surface, block);
  if (quantity == Quantity::d_visible) compute_densities(surface, block);
  const MaskedSide& v = block.viewer;
  Buffer facing;
  kernels::careful_dots(vectors(block.o), vectors(block.m), facing.data(), block.n);
  for (std::size_t k = 0; k < block.n; ++k) {
    const bool seen = v.c[k] > 0 && ((facing[k] > 0 && block.m.z[k] > 0) || !has_m);
    if (quantity == Quantity::lambda)
      out[k] = v.c[k] > 0 ? v.masked_area[k] / v.c[k] : infinity;
    else if (quantity == Quantity::g1)
      out[k] = seen ? v.c[k] / v.unmasked_area[k] : 0;
    else
      out[k] = seen && block.density[k] > 0 ? block.density[k] * (facing[k] / v.unmasked_area[k]) : 0;
  }
}

/// Quantities of the normal alone: p22, d, d_cos.
void evaluate_normal(const Microsurface& surface, Quantity quantity, SurfaceBlock& block, double* out) {
  if (quantity == Quantity::p22 && !density_kernel(surface.distribution)) {
    std::visit(
        [&](const auto& distribution) {
          for (std::size_t k = 0; k < block.n; ++k) {
            const Direction m = block.m[k];
            out[k] = m.z > 0 ? distribution.p22(-m.x / m.z, -m.y / m.z) : 0;
          }
        },
        surface.distribution);
    return;
  }
  compute_densities(surface, block);
  for (std::size_t k = 0; k < block.n; ++k) {
    const double z = block.m.z[k], d = block.density[k];
    // P22 = D z^4 of the kernel, which knows the normal as it is: the slope would be a rounded one.
    const double value = quantity == Quantity::p22 ? (d * (z * z)) * (z * z) : quantity == Quantity::d_cos ? d * z : d;
    out[k] = d == 0 ? 0 : value;
  }
}

void evaluate_g2(const Microsurface& surface, SurfaceBlock& block, double* out) {
  compute_visibility(surface, block);
  for (std::size_t k = 0; k < block.n; ++k) out[k] = block.visibility[k] * block.viewer.c[k] * block.light.c[k];
}

} // namespace

void require(const Microsurface& surface, const std::string& where, Quantity quantity, bool has_o, bool has_i,
             bool has_m) {
  const QuantityInfo& info = info_of(quantity);
  const std::string name = "\"" + info.name + "\" ";
  if (quantity == Quantity::lambda && !surface.has_lambda())
    throw InputError(where, name + "is not defined: the masking function depends on the normal and has no Lambda");
  if (info.needs.o && !has_o) throw InputError(where, name + "needs omega_o: theta_o [phi_o] or x_o y_o z_o");
  if (info.needs.i && !has_i) throw InputError(where, name + "needs omega_i: theta_i [phi_i] or x_i y_i z_i");
  const bool facing = quantity == Quantity::g1 && surface.has_lambda();
  if (info.needs.m && !has_m && !(has_o && has_i) && !facing)
    throw InputError(where, name +
                                "needs omega_m: theta_m [phi_m] or x_m y_m z_m, or omega_o with omega_i for their half "
                                "vector");
}

namespace {

/// Calls write(block, has_m, first) with each block of the batch, and its first row.
template <class Write>
void for_each_block(const Batch& batch, const Write& write) {
  const bool has_m = batch.m || (batch.o && batch.i);
  SurfaceBlock block;
  for (std::size_t first = 0; first < batch.n; first += PairBlock::capacity) {
    const std::size_t n = std::min(PairBlock::capacity, batch.n - first);
    set_directions(block, n, batch.o.from(first), batch.i.from(first), batch.m.from(first));
    write(block, has_m, first);
  }
}

} // namespace

void evaluate(const Microsurface& surface, Quantity quantity, const Batch& batch, double* out) {
  for_each_block(batch, [&](SurfaceBlock& block, bool has_m, std::size_t first) {
    evaluate(surface, quantity, has_m, block, out + first);
  });
}

void evaluate(const Microsurface& surface, const std::array<Quantity, 2>& quantities, const Batch& batch,
              const std::array<double*, 2>& out) {
  for_each_block(batch, [&](SurfaceBlock& block, bool has_m, std::size_t first) {
    for (std::size_t k = 0; k < quantities.size(); ++k) evaluate(surface, quantities[k], has_m, block, out[k] + first);
  });
}

void evaluate(const Microsurface& surface, Quantity quantity, bool has_m, SurfaceBlock& block, double* out) {
  switch (quantity) {
  case Quantity::lambda:
  case Quantity::g1:
  case Quantity::d_visible: return evaluate_masking(surface, quantity, has_m, block, out);
  case Quantity::p22:
  case Quantity::d:
  case Quantity::d_cos: return evaluate_normal(surface, quantity, block, out);
  default: return evaluate_g2(surface, block, out);
  }
}

double evaluate(const Microsurface& surface, Quantity quantity, const Direction& o, const std::optional<Direction>& i,
                const std::optional<Direction>& m) {
  const auto columns = [](const std::optional<Direction>& d) { return d ? Columns{&d->x, &d->y, &d->z} : Columns{}; };
  double out = 0;
  evaluate(surface, quantity, {1, {&o.x, &o.y, &o.z}, columns(i), columns(m)}, &out);
  return out;
}

} // namespace brdfplot
