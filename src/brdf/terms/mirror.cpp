#include "brdf/terms/mirror.hpp"

#include "brdf/blocks/kernel_choice.hpp"
#include "brdf/blocks/surface_block.hpp"

#include <algorithm>
#include <utility>

namespace brdfplot {

namespace {

/// Writes `value` times F(o.m) into the channels.
void write_channels(const Mirror& mirror, SurfaceBlock& block, const Buffer& value, const ChannelRows& out) {
  if (std::holds_alternative<NoFresnel>(mirror.fresnel)) {
    std::copy_n(value.data(), block.n, out.rho[0]);
    return;
  }
  compute_reflectances(mirror.fresnel, block);
  for (std::size_t channel = 0; channel < static_cast<std::size_t>(mirror.channels()); ++channel) {
    const Buffer& f = block.reflectances[channel];
    double* const to = out.rho[channel];
    for (std::size_t k = 0; k < block.n; ++k) to[k] = value[k] == 0 ? 0 : f[k] * value[k];
  }
}

/// By the whole kernel.
void evaluate_whole(const Mirror& mirror, const WholeKernel& kernel, bool times_cosine, SurfaceBlock& block,
                    const ChannelRows& out) {
  const kernels::Stretch stretch = mirror.surface.slopes().stretch();
  const std::size_t n = block.n;
  if (!std::exchange(block.done.white, true))
    kernels::brdf(stretch, kernel.first, kernel.second, vectors(block.o), vectors(block.i), block.white.data(), n);
  Buffer weighted;
  if (times_cosine) {
    Buffer c, s;
    const double* cosine = block.i.z; // where the slopes are centred
    if (stretch.mean_x != 0 || stretch.mean_y != 0) {
      kernels::project(stretch, vectors(block.i), c.data(), s.data(), n);
      cosine = c.data();
    }
    for (std::size_t k = 0; k < n; ++k) weighted[k] = block.white[k] * std::max(0.0, cosine[k]);
  }
  write_channels(mirror, block, times_cosine ? weighted : block.white, out);
}

/// Where only the form of shadowing has no kernel: the BRDF with the masking of heights alone, times how much more the
/// two directions see. The half vector is not rounded on the way.
void evaluate_by_heights(const Mirror& mirror, kernels::Distribution distribution, bool times_cosine,
                         SurfaceBlock& block, const ChannelRows& out) {
  compute_both_maskings(mirror.surface, block);
  compute_visibility(mirror.surface, block);
  const MaskedSide& v = block.viewer;
  const MaskedSide& l = block.light;
  Buffer value;
  kernels::brdf(mirror.surface.slopes().stretch(), distribution, kernels::Shadowing::height_correlated,
                vectors(block.o), vectors(block.i), value.data(), block.n);
  for (std::size_t k = 0; k < block.n; ++k) {
    const double inverse_by_heights = v.c[k] * l.c[k] + l.c[k] * v.masked_area[k] + v.c[k] * l.masked_area[k];
    const double ratio = block.visibility[k] * inverse_by_heights;
    value[k] = value[k] == 0 || ratio == 0 ? 0 : value[k] * (times_cosine ? ratio * l.c[k] : ratio);
  }
  write_channels(mirror, block, value, out);
}

/// By the kernel of sheen.
void evaluate_sheen(const Mirror& mirror, const SheenKernel& kernel, bool times_cosine, SurfaceBlock& block,
                    const ChannelRows& out) {
  Buffer value;
  kernels::sheen_brdf(kernel.masking, kernel.parameters, vectors(block.o), vectors(block.i), times_cosine, value.data(),
                      block.n);
  write_channels(mirror, block, value, out);
}

/// Factor by factor.
void evaluate_factors(const Mirror& mirror, bool times_cosine, SurfaceBlock& block, const ChannelRows& out) {
  compute_visibility(mirror.surface, block);
  compute_densities(mirror.surface, block);
  Buffer value;
  for (std::size_t k = 0; k < block.n; ++k) {
    const double weight = block.visibility[k] * (times_cosine ? block.light.c[k] : 1);
    value[k] = block.density[k] == 0 || weight == 0 ? 0 : 0.25 * block.density[k] * weight;
  }
  write_channels(mirror, block, value, out);
}

} // namespace

Mirror Mirror::from(const TermDescription& description) {
  return {build_microsurface(description), make_or_throw<Fresnel>("fresnel", description.fresnel)};
}

int Mirror::channels() const {
  return std::visit([](const auto& f) { return f.coloured(); }, fresnel) ? 3 : 1;
}

void Mirror::evaluate(const PairBlock& pairs, SurfaceBlock& work, const ChannelRows& out) const {
  if (const auto kernel = whole_kernel(surface))
    evaluate_whole(*this, *kernel, pairs.times_cosine, work, out);
  else if (const auto distribution = smith_kernel(surface))
    evaluate_by_heights(*this, *distribution, pairs.times_cosine, work, out);
  else if (const auto sheen = sheen_kernel(surface))
    evaluate_sheen(*this, *sheen, pairs.times_cosine, work, out);
  else
    evaluate_factors(*this, pairs.times_cosine, work, out);
}

} // namespace brdfplot
