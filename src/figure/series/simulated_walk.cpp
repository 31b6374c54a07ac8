#include "figure/series/simulated.hpp"

#include "simulation/walk.hpp"

#include <array>

namespace brdfplot::plot {

namespace {

using simulation::bounce_classes;
using simulation::Facets;
using simulation::WalkResult;

struct Bounces {
  const char* name;
  std::size_t first, last;
};

constexpr std::array<Bounces, 6> bounces = {
    {{"1", 1, 1}, {"2", 2, 2}, {"3", 3, 3}, {"4", 4, 4}, {"2+", 2, bounce_classes}, {"all", 1, bounce_classes}}};

/// What facets do with light, by name: the material says whether they are diffuse, and `facets` may say it again.
std::string facets_of(const Term& term, const Configuration::Ready& at) {
  const std::string& named = term.simulate->facets;
  const bool diffuse = at.material.terms.front().fresnel() == nullptr;
  if (named.empty()) return diffuse ? "diffuse" : "conductor";
  if ((named == "diffuse") != diffuse)
    throw InputError("", "found \"facets\": \"" + named + "\" with a material of \"" +
                             at.description.terms.front().type +
                             "\"; accepted: " + (diffuse ? "diffuse" : "conductor, dielectric"));
  return named;
}

Facets beyond_mirrors(const Term& term, const Configuration::Ready& at) {
  return facets_of(term, at) == "dielectric" ? Facets::dielectric : Facets::conductor;
}

class SmithWalkSource final : public SimulationSource {
public:
  std::string name() const override { return "smith_walk"; }

  std::string doc() const override { return "the random walk on Smith's microsurface (Heitz et al. 2016)"; }

  std::vector<std::string> quantities() const override {
    return {"brdf_cos", "albedo", "transmittance", "mean_fresnel"};
  }

  void check(const Term& term, const Configuration::Ready& at) const override {
    if (!at.o) throw InputError("", "this simulation needs theta_o");
    if (is_lobe(term) && !at.i) throw InputError("", "this simulation needs theta_i");
    require_channel(at.description, at.material, at.channel, term.quantity);
    if (at.material.channels() > 1) single_channel(at.channel, term.quantity);
    simulation::check_walk(at.material, beyond_mirrors(term, at), *at.o);
  }

  std::string group(const Term&, const Configuration::Ready& at) const override {
    return defining_text(at.description) + " from " + defining_text(*at.o);
  }

  std::string key(const Term& term, const Points& points) const override {
    std::string text = "smith_walk " + group(term, points.front()) + " " + facets_of(term, points.front()) + " " +
                       std::to_string(term.simulate->paths) + " " + std::to_string(term.simulate->seed);
    if (points.front().material.channels() > 1) text += " channel " + std::to_string(channel_of(term, points));
    if (!is_lobe(term)) return text;
    text += " towards";
    for (const auto& point : points) text += " " + defining_text(*point.i);
    return text;
  }

  simulation::Result run(const Term& term, const Points& points, int threads) const override {
    simulation::WalkRequest request;
    request.omega_o = *points.front().o;
    request.paths = term.simulate->paths;
    request.seed = term.simulate->seed;
    request.threads = threads;
    request.channel = channel_of(term, points);
    if (is_lobe(term))
      for (const auto& point : points) request.omega_i.push_back(*point.i);
    const WalkResult walked = simulation::walk(points.front().material, beyond_mirrors(term, points.front()), request);
    simulation::Result out;
    for (const auto& [name, first, last] : bounces) {
      out[std::string("albedo/") + name] = WalkResult::energy(walked.reflected, first, last);
      out[std::string("transmittance/") + name] = WalkResult::energy(walked.transmitted, first, last);
      out[std::string("mean_fresnel/") + name] = walked.mean_fresnel(first, last);
      if (is_lobe(term)) out[std::string("brdf_cos/") + name] = walked.lobe_of(first, last);
    }
    return out;
  }

  /// A path of the walk meets no surface that it has to be followed on.
  double work(const Term& term, const Points& points) const override {
    constexpr double of_one = 0.05;
    return of_one * static_cast<double>(term.simulate->paths) * static_cast<double>(points.size());
  }

  std::string output(const Term& term) const override { return term.quantity + "/" + term.simulate->bounces; }

  bool is_binned(const Term&) const override { return false; }

private:
  static std::size_t channel_of(const Term& term, const Points& points) {
    if (points.front().material.channels() == 1) return 0;
    return static_cast<std::size_t>(single_channel(points.front().channel, term.quantity));
  }
  static bool is_lobe(const Term& term) { return term.quantity == "brdf_cos"; }
};

} // namespace

const SimulationSource& smith_walk_source() {
  static const SmithWalkSource source;
  return source;
}

} // namespace brdfplot::plot
