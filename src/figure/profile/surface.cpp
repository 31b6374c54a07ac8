#include "figure/profile/surface.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/random.hpp"
#include "base/threads/interruptible.hpp"
#include "brdf/evaluate.hpp"
#include "microfacet/remembered.hpp"
#include "models/model_text.hpp"
#include "models/registry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <type_traits>

namespace brdfplot::plot {

namespace {

/// Facets are drawn a little apart.
constexpr double facet_width = 0.86;

/// Two independent normal numbers (Box and Muller).
std::pair<double, double> normal_pair(Random& random) {
  const double radius = std::sqrt(-2 * std::log(random.uniform()));
  const double phi = 2 * std::numbers::pi * random.uniform();
  return {radius * std::cos(phi), radius * std::sin(phi)};
}

Profile uncorrelated(const UncorrelatedSurface& surface, std::uint64_t seed) {
  Profile out;
  IndependentFacets facets{surface.alpha, 0, {}, {}, {}};
  Random random(seed, 0);
  const auto count = static_cast<std::size_t>(surface.samples);
  for (std::size_t k = 0; k < count; ++k) {
    const auto [u, v] = normal_pair(random);
    const double x = static_cast<double>(k) + 0.5, h = surface.rms_height * u;
    const double rise = facet_width / 2 * surface.alpha / std::numbers::sqrt2 * v;
    out.facets.push_back({x - facet_width / 2, h - rise, x + facet_width / 2, h + rise});
    facets.below.push_back(std::erfc(-u / std::numbers::sqrt2) / 2);
    facets.viewer.push_back(random.uniform());
    facets.light.push_back(random.uniform());
  }
  out.period = surface.samples;
  out.independent = std::move(facets);
  return out;
}

/// The slopes' roughness in the plane of a cut.
double alpha_along(const SlopeMap& slopes, bool along_y) { return along_y ? slopes.alpha_y : slopes.alpha_x; }

/// Lengths along the axes go with 1 / sqrt(covariance), and the mesh's is along that of the steepest slopes.
HeightLaw law_of(const simulation::RandomMesh& mesh, bool along_y) {
  const auto slopes = simulation::covariance(mesh.slopes);
  const double steepest = (slopes.xx + slopes.yy) / 2 + std::hypot((slopes.xx - slopes.yy) / 2, slopes.xy);
  return {mesh.autocorrelation, mesh.correlation_length * std::sqrt(steepest / (along_y ? slopes.yy : slopes.xx))};
}

Microsurface model_of(ModelChoice distribution, const std::string& masking) {
  return build_microsurface({.distribution = std::move(distribution), .masking = {.type = masking}, .shadowing = {}});
}

Made<ProfileSurface> made(const ModelChoice& choice) {
  auto surface = make_model<ProfileSurface>(choice);
  if (std::holds_alternative<ParameterError>(surface)) return surface;
  const auto problem = std::visit([](const auto& s) { return s.problem(); }, std::get<ProfileSurface>(surface));
  if (problem) return *problem;
  if (choice.values.has("mean_slope") && choice.values.vec2("mean_slope") != Vec2{0, 0})
    return ParameterError{"mean_slope", "a profile is level, and is inclined by \"shear\"; accepted: [0, 0]"};
  return surface;
}

} // namespace

ModelSpec UncorrelatedSurface::spec() {
  const Bounds positive{.min = 0, .open_min = true};
  return {.type = "uncorrelated",
          .doc = "facets whose heights and slopes are independent and Gaussian, as Smith's model has them",
          .source = "Smith 1967; Heitz 2014, section 4.1",
          .parameters = {{.key = "alpha", .bounds = positive, .doc = "roughness"},
                         {.key = "rms_height", .bounds = positive, .fallback = 1.0, .doc = "in widths of a facet"},
                         {.key = "samples",
                          .bounds = {.min = 8, .max = 1e6},
                          .fallback = 4096.0,
                          .doc = "facets, over which numbers are measured; a whole number"}}};
}

UncorrelatedSurface UncorrelatedSurface::from(const Values& values) {
  return {values.number("alpha"), values.number("rms_height"), values.number("samples")};
}

std::optional<ParameterError> UncorrelatedSurface::problem() const {
  if (samples == std::floor(samples)) return std::nullopt;
  return ParameterError{"samples", "found " + format_number(samples) + ", accepted: a whole number in [8, 1e6]"};
}

std::optional<ParameterError> problem_of(const ModelChoice& choice) {
  const auto made_surface = made(choice);
  const auto* error = std::get_if<ParameterError>(&made_surface);
  return error == nullptr ? std::nullopt : std::optional(*error);
}

SurfaceFacts facts_of(const ModelChoice& choice) {
  return std::visit(
      [](const auto& of) {
        if constexpr (requires { of.facts; })
          return of.facts;
        else
          return SurfaceFacts{.has_heights = !of.ruled, .cavities = of.ruled};
      },
      std::get<ProfileSurface>(made(choice)));
}

std::size_t cut_count(const ModelChoice& choice) {
  const auto surface = std::get<ProfileSurface>(made(choice));
  return std::visit(
      [](const auto& of) -> std::size_t {
        if constexpr (requires { of.mesh; }) return static_cast<std::size_t>(of.mesh.samples);
        if constexpr (requires { of.pairs; }) return static_cast<std::size_t>(of.pairs);
        return 1;
      },
      surface);
}

namespace {

/// The surface of a seed. Many profiles are cut from one: the last few stay, but large ones.
template <class Surface>
std::shared_ptr<const simulation::Realisation> realised(const Surface& surface, const ModelChoice& choice,
                                                        std::uint64_t seed) {
  const auto make = [&] {
    return std::make_shared<const simulation::Realisation>(
        interruptible([surface, seed] { return surface.realise(seed, 0); }));
  };
  constexpr std::size_t kept = 8, largest = 1024;
  if (cut_count(choice) > largest) return make();
  return remembered<std::shared_ptr<const simulation::Realisation>, kept>(
      text_of_model(choice) + " " + std::to_string(seed), make);
}

} // namespace

Cuts::Cuts(const ModelChoice& choice, std::uint64_t seed, bool along_y) : along_y_(along_y) {
  const auto made_surface = made(choice);
  if (const auto* error = std::get_if<ParameterError>(&made_surface)) throw InputError(error->key, error->what);
  const auto& surface = std::get<ProfileSurface>(made_surface);
  count_ = cut_count(choice);
  cavities_ = facts_of(choice).cavities;
  std::visit(
      [&](const auto& of) {
        if constexpr (requires { of.realise(seed, 0); }) {
          realised_ = realised(of, choice, seed);
          alpha_ = alpha_along(of.asked().value(), along_y);
          if (!cavities_) slopes_ = of.target().value().type;
          if constexpr (std::is_same_v<std::decay_t<decltype(of)>, simulation::GaussianSurface>)
            law_ = law_of(of.mesh, along_y);
        } else if constexpr (requires { of.alpha; }) {
          only_ = uncorrelated(of, seed);
          slopes_ = of.slopes;
          alpha_ = of.alpha;
        } else {
          only_ = joined({0, 0});
        }
      },
      surface);
}

std::vector<double> Cuts::heights(std::size_t k) const {
  const auto& field = realised_->fields.at(cavities_ ? k : 0);
  const int cut = cavities_ ? 0 : static_cast<int>(k);
  std::vector<double> out;
  const int count = along_y_ && !cavities_ ? field.ny() : field.nx();
  for (int i = 0; i < count; ++i) out.push_back(along_y_ && !cavities_ ? field.height(cut, i) : field.height(i, cut));
  return out;
}

Profile Cuts::profile(std::size_t k) const {
  if (!realised_) return only_;
  std::vector<double> all = heights(k);
  // Heights are from the mean of the surface; one row of a ridge has its mean.
  const double mean = cavities_ ? std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size()) : 0;
  for (double& h : all) h -= mean;
  return joined(all);
}

std::vector<std::size_t> Cuts::surface_of(std::size_t k) const {
  if (cavities_) return {k};
  std::vector<std::size_t> all(count_);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

double Cuts::theta_m(std::size_t k) const {
  const auto& field = realised_->fields.at(k);
  return std::atan(std::fabs(field.height(1, 0) - field.height(0, 0)));
}

std::optional<double> Cuts::g1(std::size_t k, double theta, const Distortion& distortion) const {
  if (cavities_) {
    // The normal that leans towards the viewer: whenever one faces theta, this one does.
    const double towards = std::copysign(theta_m(k), theta);
    ModelChoice any{.type = "beckmann", .values = {}}; // Eq. 49 asks for no distribution
    any.values.set("alpha", 1.0);
    const Microsurface surface = model_of(std::move(any), "v_cavity");
    return evaluate(surface, Quantity::g1, from_angles(theta, 0), std::nullopt, from_angles(towards, 0));
  }
  if (slopes_.empty()) return std::nullopt;
  ModelChoice distribution{.type = slopes_, .values = {}};
  distribution.values.set("alpha", alpha_ / distortion.stretch);
  distribution.values.set("mean_slope", Vec2{distortion.shear, 0});
  return evaluate(model_of(std::move(distribution), "smith"), Quantity::g1, from_angles(distortion.of(theta), 0),
                  std::nullopt, std::nullopt);
}

std::size_t Cuts::correlation_length() const {
  return static_cast<std::size_t>(std::max(std::lround(realised_ ? realised_->correlation_length : 0), 1L));
}

double HeightLaw::at(double distance) const {
  const double t = distance / length;
  return std::exp(shape == simulation::Autocorrelation::gaussian ? -t * t : -t);
}

std::vector<double> autocorrelation(const Cuts& cuts, const std::vector<std::size_t>& distances) {
  std::vector<double> products(distances.size());
  double squares = 0;
  for (std::size_t k = 0; k < cuts.count(); ++k) {
    throw_if_interrupted();
    const Profile profile = cuts.profile(k);
    const std::size_t count = profile.facets.size();
    std::vector<double> heights;
    for (const Segment& s : profile.facets) heights.push_back((s.h0 + s.h1) / 2);
    for (const double h : heights) squares += h * h;
    for (std::size_t d = 0; d < distances.size(); ++d)
      for (std::size_t i = 0; i < count; ++i) products[d] += heights[i] * heights[(i + distances[d]) % count];
  }
  if (squares > 0)
    for (double& product : products) product /= squares;
  return products;
}

} // namespace brdfplot::plot
