#include "brdf/terms/eon.hpp"

#include "brdf/surface_block.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace brdfplot {

namespace {

using std::numbers::inv_pi;
using std::numbers::pi;

constexpr double k1 = 0.5 - 2 / (3 * pi);       ///< what is lost at the normal, over A r
constexpr double k2 = 2.0 / 3 - 28 / (15 * pi); ///< mean E = A (1 + k2 r)

std::vector<ParameterSpec> rough_parameters() {
  return {Colour::parameter("albedo", "of each channel"),
          {.key = "roughness", .bounds = {.min = 0, .max = 1}, .doc = "0: Lambert's"}};
}

double scale(double roughness) { return 1 / (1 + k1 * roughness); }

/// rho of albedo 1, reflected once. At grazing s is divided by what is small: it must be right where the azimuths are
/// at right angles, and its terms cancel.
double once(const Direction& o, const Direction& i, double roughness) {
  const double s = careful_dot({o.x, o.y, 0}, {i.x, i.y, 0});
  const double t = s > 0 ? std::max(o.z, i.z) : 1;
  return inv_pi * scale(roughness) * (1 + roughness * s / t);
}

/// k1 pi - G(mu), G as in the source, with arccos as pi/2 - arcsin and every difference that cancels as a product.
double lost(double mu) {
  const double s = std::sqrt((1 - mu) * (1 + mu));
  return (pi / 2 - 2.0 / 3) * mu * mu / (1 + s) + s * std::asin(mu) + s * s * mu -
         2.0 / 3 * s * mu * (1 + s + s * s) / (1 + s);
}

} // namespace

double FujiiOrenNayar::missing(double mu, double roughness) { return scale(roughness) * roughness * inv_pi * lost(mu); }

ModelSpec FujiiOrenNayar::spec() {
  return {.type = "fujii_oren_nayar",
          .doc = "rough diffuse surface, without the cusps of Oren and Nayar's qualitative fit",
          .source = "Fujii 2012; Portsmouth, Kutz and Hill 2024",
          .parameters = rough_parameters()};
}

FujiiOrenNayar FujiiOrenNayar::from(const TermDescription& description) {
  const Values values = completed_values<FujiiOrenNayar>(description);
  return {Colour::from(values, "albedo"), values.number("roughness")};
}

void FujiiOrenNayar::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  evaluate_flat(block, albedo, out, [&](const Direction& o, const Direction& i) { return once(o, i, roughness); });
}

ModelSpec Eon::spec() {
  return {.type = "eon",
          .doc = "rough diffuse surface that loses nothing: Fujii's with the light of further bounces",
          .source = "Portsmouth, Kutz and Hill 2024",
          .parameters = rough_parameters()};
}

Eon Eon::from(const TermDescription& description) {
  const Values values = completed_values<Eon>(description);
  return {Colour::from(values, "albedo"), values.number("roughness")};
}

void Eon::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  const double mean = scale(roughness) * (1 + k2 * roughness);
  // (1 - E) (1 - E') / (1 - mean E) = A r B B' / (pi^2 (k1 - k2)), which is as good for r = 0.
  const double further = inv_pi * scale(roughness) * roughness * inv_pi * inv_pi / (k1 - k2);
  std::array<double, 3> multiple{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double a = albedo.value[c];
    multiple[c] = a * a * mean / (1 - a * (1 - mean)) * further;
  }
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction o = block.o[k], i = block.i[k];
    const bool lit = o.z > 0 && i.z > 0;
    const double factor = block.times_cosine ? i.z : 1;
    const double single = lit ? once(o, i, roughness) * factor : 0;
    const double both = lit ? lost(o.z) * lost(i.z) * factor : 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c)
      out.rho[c][k] = albedo.value[c] * single + multiple[c] * both;
  }
}

} // namespace brdfplot
