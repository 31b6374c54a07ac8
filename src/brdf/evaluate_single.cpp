#include "brdf/evaluate_single.hpp"

#include "brdf/blocks/kernel_choice.hpp"

#include <algorithm>
#include <array>

namespace brdfplot {

namespace {

constexpr std::size_t block_size = 256;
using FloatBlock = std::array<float, block_size>;

/// Vectors of a block, rounded to float.
struct Rounded {
  FloatBlock x, y, z;

  Rounded(const Columns& columns, std::size_t first, std::size_t n) {
    for (std::size_t k = 0; columns && k < n; ++k) {
      x[k] = static_cast<float>(columns.x[first + k]);
      y[k] = static_cast<float>(columns.y[first + k]);
      z[k] = static_cast<float>(columns.z[first + k]);
    }
  }
  kernels::Vectors<float> view() const { return {x.data(), y.data(), z.data()}; }
};

/// What the float kernels of one quantity are called with.
struct Call {
  kernels::Stretch stretch;
  kernels::Distribution distribution;
  kernels::Shadowing shadowing;
};

/// The call that computes `quantity`, where there are float kernels for it: for Beckmann and GGX, of lambda and g1 with
/// Smith masking, of d, and of the BRDF with F = 1 and a form of shadowing that has a kernel.
std::optional<Call> call_for(const Microsurface& surface, bool whole_brdf, Quantity quantity, const Batch& batch) {
  const auto call = [&](std::optional<kernels::Distribution> distribution) -> std::optional<Call> {
    if (!distribution) return std::nullopt;
    return Call{surface.slopes().stretch(), *distribution, kernels::Shadowing::none};
  };
  const bool half_vector = !batch.m && batch.i;
  switch (quantity) {
  case Quantity::lambda: return call(smith_kernel(surface));
  case Quantity::g1: return half_vector ? std::nullopt : call(smith_kernel(surface));
  case Quantity::d:
  case Quantity::d_cos: return half_vector ? std::nullopt : call(density_kernel(surface.distribution));
  case Quantity::brdf:
  case Quantity::brdf_cos: {
    const auto whole = whole_kernel(surface);
    if (!whole || !whole_brdf) return std::nullopt;
    return Call{surface.slopes().stretch(), whole->first, whole->second};
  }
  default: return std::nullopt;
  }
}

void mask(const Call& call, Quantity quantity, const Rounded& o, const Rounded& m, bool has_m, std::size_t n,
          float* out) {
  const bool beckmann = call.distribution == kernels::Distribution::beckmann;
  FloatBlock c, s;
  kernels::project(call.stretch, o.view(), c.data(), s.data(), n);
  if (quantity == Quantity::lambda)
    return beckmann ? kernels::lambda_beckmann(c.data(), s.data(), out, n)
                    : kernels::lambda_ggx(c.data(), s.data(), out, n);
  beckmann ? kernels::masked_area_beckmann(c.data(), s.data(), out, n)
           : kernels::masked_area_ggx(c.data(), s.data(), out, n);
  for (std::size_t k = 0; k < n; ++k) {
    const float facing = o.x[k] * m.x[k] + o.y[k] * m.y[k] + o.z[k] * m.z[k];
    const bool seen = c[k] > 0 && (!has_m || (facing > 0 && m.z[k] > 0));
    out[k] = seen ? c[k] / (c[k] + out[k]) : 0;
  }
}

void run(const Call& call, Quantity quantity, const Batch& batch, std::size_t first, std::size_t n, float* out) {
  const Rounded o(batch.o, first, n), i(batch.i, first, n), m(batch.m, first, n);
  switch (quantity) {
  case Quantity::lambda:
  case Quantity::g1: return mask(call, quantity, o, m, bool(batch.m), n, out);
  case Quantity::d:
  case Quantity::d_cos:
    call.distribution == kernels::Distribution::beckmann ? kernels::d_beckmann(call.stretch, m.view(), out, n)
                                                         : kernels::d_ggx(call.stretch, m.view(), out, n);
    if (quantity == Quantity::d_cos)
      for (std::size_t k = 0; k < n; ++k) out[k] *= m.z[k];
    return;
  default: kernels::brdf(call.stretch, call.distribution, call.shadowing, o.view(), i.view(), out, n);
  }
  if (quantity != Quantity::brdf_cos) return;
  FloatBlock c, s;
  kernels::project(call.stretch, i.view(), c.data(), s.data(), n);
  for (std::size_t k = 0; k < n; ++k) out[k] *= std::max(0.0F, c[k]);
}

/// Whether a term is all of its microsurface: mirrors with F = 1.
bool is_white(const WeightedTerm& term) {
  const Fresnel* fresnel = term.fresnel();
  return term.surface() != nullptr && fresnel != nullptr && std::holds_alternative<NoFresnel>(*fresnel) &&
         term.weight.value == Rgb{1, 1, 1} && term.channels() == 1 && term.coats.empty();
}

/// The call that computes a quantity of a material, where there is one.
std::optional<Call> call_for(const Material& material, Quantity quantity, const Batch& batch, const std::string& term) {
  const Owner owner = info_of(quantity).owner;
  if (owner == Owner::fresnel) return std::nullopt;
  if (owner == Owner::microsurface) return call_for(material.surface(term), false, quantity, batch);
  const auto terms = terms_of(material, term);
  if (terms.size() > 1 || !is_white(*terms[0])) return std::nullopt;
  return call_for(*terms[0]->surface(), true, quantity, batch);
}

} // namespace

void evaluate(const Material& material, Quantity quantity, const Batch& batch, float* out, const std::string& term) {
  const Batch used = used_by(quantity, batch);
  require(material, info_of(quantity), bool(used.o), bool(used.i), bool(used.m), term);
  if (const auto call = call_for(material, quantity, used, term)) {
    for (std::size_t first = 0; first < used.n; first += block_size)
      run(*call, quantity, used, first, std::min(block_size, used.n - first), out + first);
    return;
  }
  const auto channels = static_cast<std::size_t>(channels_of(material, quantity, term));
  std::vector<double> values(used.n * channels);
  evaluate(material, quantity, used, values.data(), term);
  std::ranges::transform(values, out, [](double value) { return static_cast<float>(value); });
}

} // namespace brdfplot
