#include "simulation/walk.hpp"

#include "base/random.hpp"
#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "microfacet/visible_normals.hpp"
#include "models/registry.hpp"
#include "simulation/smith_profile.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>

namespace brdfplot::simulation {

namespace {

Direction negated(const Direction& d) { return {-d.x, -d.y, -d.z}; }

/// A direction with the density cos / pi about m.
Direction sample_lambert(const Direction& m, Random& random) {
  const double z = 1 - 2 * random.uniform();
  const double phi = 2 * std::numbers::pi * random.uniform();
  const double r = std::sqrt((1 - z) * (1 + z));
  return normalized({m.x + r * std::cos(phi), m.y + r * std::sin(phi), m.z + z});
}

/// v refracted at m into the side of relative index eta; v.m > 0, no total reflection.
Direction refracted(const Direction& v, const Direction& m, double eta) {
  const double c = dot(v, m);
  const double k = 1 - (1 - c) * (1 + c) / (eta * eta);
  return normalized((c / eta - std::sqrt(std::fmax(k, 0.0))) * m + (-1 / eta) * v);
}

/// The light beneath a surface sees it from below: every vector and height is reversed and the laws are the same. A
/// ray is kept in the frame in which it is above.
struct Ray {
  Direction omega;
  double level = 1; ///< C1(h)
  bool outside = true;
  double weight = 1;
};

/// An outgoing direction that is asked for, in the frame in which it is above.
struct Target {
  Direction omega;
  double Lambda;
  bool outside;
};

/// The facets of a material of one term, and the microsurface that they are on.
struct FacetsOf {
  const Microsurface* surface = nullptr;
  const Fresnel* fresnel = nullptr; ///< of mirrors
  Rgb albedo{1, 1, 1};              ///< of diffuse facets

  bool diffuse() const { return fresnel == nullptr; }
};

/// The relative index of what refracts, none of what does not (fresnel.hpp).
std::optional<double> relative_index_of(const Fresnel& fresnel, std::size_t channel) {
  return std::visit(
      [channel](const auto& f) -> std::optional<double> {
        if constexpr (requires { f.relative_index(channel); })
          return f.relative_index(channel);
        else
          return std::nullopt;
      },
      fresnel);
}

/// \throws InputError where a material has no such facets, or others beside.
FacetsOf facets_of(const Material& material) {
  const WeightedTerm& term = material.terms.front();
  FacetsOf facets{term.surface(), term.fresnel()};
  std::visit(
      [&](const auto& t) {
        if constexpr (requires {
                        t.surface;
                        t.albedo;
                      })
          facets.albedo = t.albedo.value;
      },
      term.term);
  if (material.terms.size() != 1 || facets.surface == nullptr || term.weight.value != Rgb{1, 1, 1})
    throw InputError(material.name, "the walk on Smith's surface knows materials of one term, mirror or facet_diffuse, "
                                    "with weight 1");
  return facets;
}

template <class Shape>
class Walker {
public:
  Walker(const Material& material, Facets facets, const WalkRequest& request)
      : of_(facets_of(material)), profile_{of_.surface->slopes()}, diffuse_(of_.diffuse()), facets_(facets),
        request_(request) {
    if (facets == Facets::dielectric) eta_ = relative_index_of(*of_.fresnel, request.channel).value();
    for (const Direction& omega : request.omega_i) {
      const bool outside = of_.surface->slopes().project(omega).c > 0;
      const Direction up = outside ? omega : negated(omega);
      targets_.push_back({up, profile_.Lambda(up), outside});
    }
  }

  /// The chunk's paths, added to the estimates of the chunk.
  void run(std::size_t chunk, WalkResult& result, std::size_t& unfinished) const {
    const std::size_t paths = result.paths / walk_chunks;
    for (std::size_t k = 0; k < paths; ++k) {
      Random random(request_.seed, chunk * paths + k);
      if (!run_path(chunk, random, result)) ++unfinished;
      if (k % 1024 == 0) throw_if_interrupted();
    }
    const double scale = 1 / static_cast<double>(paths);
    for (std::size_t b = 0; b < bounce_classes; ++b) {
      for (auto* estimates : {&result.reflected, &result.transmitted, &result.fresnel, &result.hits})
        (*estimates)[b][chunk] *= scale;
      double* lobe = result.lobe[b].data() + chunk * targets_.size();
      for (std::size_t d = 0; d < targets_.size(); ++d) lobe[d] *= scale;
    }
  }

private:
  /// False when the path does not end.
  bool run_path(std::size_t chunk, Random& random, WalkResult& result) const {
    Ray ray{negated(request_.omega_o)};
    for (int bounces = 0; bounces <= most_bounces; ++bounces) {
      const double level = ray.level * std::exp(-std::log(random.uniform()) / profile_.Lambda(ray.omega));
      // NaN: level 0 times infinity, a ray from the lowest point straight up.
      if (!(level <= 1)) {
        auto& left = ray.outside ? result.reflected : result.transmitted;
        left[class_of(bounces)][chunk] += ray.weight;
        return true;
      }
      ray.level = level;
      scatter(ray, class_of(bounces + 1), chunk, random, result);
    }
    return false;
  }

  static std::size_t class_of(int bounces) {
    return std::min(static_cast<std::size_t>(std::max(bounces, 1)), bounce_classes) - 1;
  }

  void scatter(Ray& ray, std::size_t bounce, std::size_t chunk, Random& random, WalkResult& result) const {
    const Direction v = negated(ray.omega);
    const Direction m = sample_visible_normal<Shape>(profile_.slopes, v, random);
    const double facing = std::clamp(dot(v, m), 0.0, 1.0);
    double* lobe = result.lobe[bounce].data() + chunk * targets_.size();
    for (std::size_t d = 0; d < targets_.size(); ++d) lobe[d] += ray.weight * leaving(ray, v, m, targets_[d]);
    const double f = reflectance(facing, ray.outside);
    result.fresnel[bounce][chunk] += f;
    result.hits[bounce][chunk] += 1;
    if (diffuse_) {
      ray.omega = sample_lambert(m, random);
    } else if (facets_ == Facets::conductor) {
      ray.omega = reflected(v, m);
      ray.weight *= f;
    } else if (random.uniform() < f) {
      ray.omega = reflected(v, m);
    } else {
      ray.omega = negated(refracted(v, m, relative_index(ray.outside)));
      ray.level = 1 - ray.level;
      ray.outside = !ray.outside;
    }
  }

  /// The phase function towards the target times its chance to leave from there.
  double leaving(const Ray& ray, const Direction& v, const Direction& m, const Target& target) const {
    const bool crosses = target.outside != ray.outside;
    if (crosses && facets_ != Facets::dielectric) return 0;
    const double level = crosses ? 1 - ray.level : ray.level;
    const double phase = diffuse_  ? std::fmax(dot(target.omega, m), 0.0) * std::numbers::inv_pi
                         : crosses ? transmitting(v, negated(target.omega), ray.outside)
                                   : reflecting(v, target.omega, ray.outside);
    return phase > 0 ? phase * std::pow(level, target.Lambda) : 0;
  }

  /// F D_v(h) / (4 |v.h|), h the half vector.
  double reflecting(const Direction& v, const Direction& omega, bool outside) const {
    const Direction h = half_vector(v, omega);
    const double facing = dot(v, h);
    if (!(h.z > 0) || !(facing > 0)) return 0;
    return reflectance(facing, outside) * profile_.density(h) / (4 * profile_.sigma(v));
  }

  /// (1 - F) D_v(h) <omega, h> eta^2 / (v.h + eta omega.h)^2 (Walter et al. 2007, Eq. 21, as a phase function).
  double transmitting(const Direction& v, const Direction& omega, bool outside) const {
    const double eta = relative_index(outside);
    Direction h = normalized(v + eta * omega);
    if (h.z < 0) h = negated(h);
    const double in = dot(v, h), out = dot(omega, h);
    if (!(in > 0) || !(out < 0)) return 0;
    const double visible = in * profile_.density(h) / profile_.sigma(v);
    const double denominator = in + eta * out;
    return (1 - reflectance(in, outside)) * visible * -out * eta * eta / (denominator * denominator);
  }

  double relative_index(bool outside) const { return outside ? eta_ : 1 / eta_; }

  double reflectance(double facing, bool outside) const {
    if (diffuse_) return of_.albedo[request_.channel];
    const double cosine = std::min(facing, 1.0);
    if (facets_ == Facets::dielectric) return dielectric_reflectance(cosine, relative_index(outside));
    double f = 0;
    std::visit([&](const auto& fresnel) { fresnel.reflectances(&cosine, request_.channel, &f, 1); }, *of_.fresnel);
    return f;
  }

  FacetsOf of_;
  SmithProfile<Shape> profile_;
  bool diffuse_;
  Facets facets_;
  const WalkRequest& request_;
  std::vector<Target> targets_;
  double eta_ = 1;
};

Estimates sum_of(const WalkResult::ByBounce& classes, std::size_t first, std::size_t last, std::size_t points) {
  Estimates sums{points, std::vector<double>(walk_chunks * points, 0)};
  for (std::size_t b = first; b <= std::min(last, bounce_classes); ++b)
    for (std::size_t k = 0; k < sums.values.size(); ++k) sums.values[k] += classes[b - 1][k];
  return sums;
}

template <class Shape>
WalkResult run_all(const Material& material, Facets facets, const WalkRequest& request) {
  const Walker<Shape> walker(material, facets, request);
  WalkResult result;
  result.directions = request.omega_i.size();
  result.paths = (request.paths + walk_chunks - 1) / walk_chunks * walk_chunks;
  for (auto* estimates : {&result.reflected, &result.transmitted, &result.fresnel, &result.hits})
    estimates->fill(std::vector<double>(walk_chunks, 0));
  result.lobe.fill(std::vector<double>(walk_chunks * result.directions, 0));
  std::array<std::size_t, walk_chunks> unfinished{};
  parallel_for(walk_chunks, request.threads, [&](std::size_t chunk) { walker.run(chunk, result, unfinished[chunk]); });
  for (const std::size_t count : unfinished) result.unfinished += count;
  return result;
}

} // namespace

Estimates WalkResult::energy(const ByBounce& from, std::size_t first, std::size_t last) {
  return sum_of(from, first, last, 1);
}

Estimates WalkResult::lobe_of(std::size_t first, std::size_t last) const {
  return sum_of(lobe, first, last, directions);
}

Estimates WalkResult::mean_fresnel(std::size_t first, std::size_t last) const {
  const Estimates sums = sum_of(fresnel, first, last, 1), counts = sum_of(hits, first, last, 1);
  const double count = counts.at(0).value;
  const double ratio = sums.at(0).value / count;
  Estimates out{1, {}};
  for (std::size_t chunk = 0; chunk < walk_chunks; ++chunk)
    out.values.push_back(ratio + (sums.values[chunk] - ratio * counts.values[chunk]) / count);
  return out;
}

void check_walk(const Material& material, Facets facets, const Direction& omega_o) {
  const FacetsOf of = facets_of(material);
  const Distribution& distribution = of.surface->distribution;
  if (!(of.surface->slopes().project(omega_o).c > 0))
    throw InputError(material.name, "omega_o is below the horizon of the mesosurface");
  if (!std::visit([]<class D>(const D&) { return SamplesVisibleNormals<D>; }, distribution))
    throw InputError(material.name, "the walk on Smith's surface knows the distributions " +
                                        types_that<Distribution>(
                                            []<class D>(std::type_identity<D>) { return SamplesVisibleNormals<D>; }));
  if (facets == Facets::dielectric && of.diffuse())
    throw InputError(material.name,
                     "diffuse facets refract nothing; accepted with \"dielectric\": \"facet\": \"specular\"");
  if (facets == Facets::dielectric && !relative_index_of(*of.fresnel, 0))
    throw InputError(material.name, "dielectric facets need the Fresnel term \"dielectric\"");
}

WalkResult walk(const Material& material, Facets facets, const WalkRequest& request) {
  check_walk(material, facets, request.omega_o);
  return std::visit(
      [&]<class D>(const D&) -> WalkResult {
        if constexpr (SamplesVisibleNormals<D>)
          return run_all<typename D::UnitShape>(material, facets, request);
        else
          return {}; // refused by check_walk()
      },
      material.surface().distribution);
}

} // namespace brdfplot::simulation
