#include "brdf/terms/diffuse/eon.hpp"

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

} // namespace

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
  const auto factors = [this](std::size_t c) {
    return std::array{albedo.value[c] * inv_pi * scale(roughness), 0.0, 0.0};
  };
  evaluate_flat(block, kernels::FlatTerm::fujii, flat_parameters({roughness}, factors), channels(), out);
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
  const auto factors = [&](std::size_t c) {
    const double a = albedo.value[c];
    return std::array{a * inv_pi * scale(roughness), a * a * mean / (1 - a * (1 - mean)) * further, 0.0};
  };
  evaluate_flat(block, kernels::FlatTerm::eon, flat_parameters({roughness}, factors), channels(), out);
}

} // namespace brdfplot
