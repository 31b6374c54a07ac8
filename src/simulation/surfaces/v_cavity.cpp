#include "simulation/surfaces/v_cavity.hpp"

#include "base/number.hpp"
#include "base/random.hpp"
#include "simulation/streams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brdfplot::simulation {

namespace {

/// What the slopes may be, the first where nothing is said.
constexpr std::array shapes = {&beckmann_slopes, &ggx_slopes};

} // namespace

ModelSpec VCavitySurface::spec() {
  ModelSpec spec{.type = "v_cavity",
                 .doc = "a ridged surface for every pair of a normal and its mirror image",
                 .source = "Torrance and Sparrow 1967; Heitz 2014, section 4.2",
                 .parameters = SlopeMap::parameters(),
                 .alternatives = SlopeMap::alternatives()};
  spec.parameters.push_back({.key = "slopes",
                             .kind = ParameterKind::choice,
                             .fallback = std::string(shapes.front()->distribution),
                             .doc = "what their distribution is",
                             .choices = {}});
  for (const UnitSlopes* shape : shapes) spec.parameters.back().choices.emplace_back(shape->distribution);
  spec.parameters.push_back({.key = "pairs",
                             .bounds = {.min = 16, .max = 65536},
                             .fallback = 1024.0,
                             .doc = "normal pairs in a realisation; a whole number"});
  return spec;
}

VCavitySurface VCavitySurface::from(const Values& values) {
  const std::string asked = values.text("slopes");
  const auto* shape = *std::ranges::find(shapes, asked, [](const UnitSlopes* one) { return one->distribution; });
  return {SlopeMap::from(values), shape, values.number("pairs")};
}

std::optional<ParameterError> VCavitySurface::problem() const {
  if (auto of_slopes = slopes.problem()) return of_slopes;
  if (pairs == std::floor(pairs)) return std::nullopt;
  return ParameterError{"pairs", "found " + format_number(pairs) + ", accepted: a whole number in [16, 65536]"};
}

Realisation VCavitySurface::realise(std::uint64_t seed, std::uint64_t realisation) const {
  Realisation out;
  SlopeMap centred = slopes;
  centred.mean_x = centred.mean_y = 0;
  const auto count = static_cast<std::uint64_t>(pairs);
  double squares = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    Random random(seed, stream(Purpose::surface, realisation, k));
    // Strata of equal weight, in the radius, where the long tail of GGX would make the most noise.
    const double u = (static_cast<double>(k) + random.uniform()) / static_cast<double>(count);
    const double phi = 2 * std::numbers::pi * random.uniform();
    const double radius = shape->norm_within(u);
    const Slope slope = slope_at(centred, radius * std::cos(phi), radius * std::sin(phi));
    const auto height = static_cast<float>(std::hypot(slope.x, slope.y));
    squares += height * height / 12.0;
    // Two cells across the ridge, up and down; along it nothing changes.
    out.fields.emplace_back(2, 2, std::vector<float>{0, height, 0, height}, std::atan2(slope.y, slope.x),
                            Slope{slopes.mean_x, slopes.mean_y});
  }
  out.rms_height = std::sqrt(squares / pairs);
  return out;
}

} // namespace brdfplot::simulation
