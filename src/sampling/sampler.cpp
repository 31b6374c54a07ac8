#include "sampling/sampler.hpp"

#include "base/errors.hpp"
#include "sampling/cosine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

double mean(const Rgb& colour) { return (colour[0] + colour[1] + colour[2]) / 3; }

/// The weight of a term times what it has of a constant albedo.
double size_of(const WeightedTerm& term) {
  const double own = std::visit(
      [](const auto& t) {
        if constexpr (requires { t.albedo.value; })
          return mean(t.albedo.value);
        else if constexpr (requires { t.color.value; })
          return mean(t.color.value);
        else
          return 1.0;
      },
      term.term);
  return mean(term.weight.value) * own;
}

double mean_reflectance(const Fresnel& fresnel, double cosine) {
  return std::visit(
      [&](const auto& f) {
        const std::size_t channels = f.coloured() ? 3 : 1;
        double sum = 0;
        for (std::size_t c = 0; c < channels; ++c) {
          double value = 0;
          f.reflectances(&cosine, c, &value, 1);
          sum += value;
        }
        return sum / static_cast<double>(channels);
      },
      fresnel);
}

bool is_about_half_vector(const WeightedTerm& term) {
  return std::visit(
      [](const auto& t) {
        return requires { t.about_half_vector; };
      },
      term.term);
}

/// null: cosine.
std::shared_ptr<const DirectLobe> direct_lobe(const WeightedTerm& term, Strategy by) {
  if (by == Strategy::eon) return eon_lobe(std::get<Eon>(term.term).roughness);
  if (by == Strategy::kelemen) return matte_lobe(std::get<Complement>(term.term).of);
  return nullptr;
}

std::string names_of(const std::vector<Strategy>& strategies) {
  std::string names;
  for (const Strategy strategy : strategies) names += (names.empty() ? "" : ", ") + name_of(strategy);
  return names;
}

/// "TERM accepts A, B; ...".
std::string what_terms_accept(const Material& material) {
  std::string text;
  for (const WeightedTerm& term : material.terms)
    text += (text.empty() ? "\"" : "; \"") + term.name + "\": " + names_of(strategies_of(term));
  return text;
}

Strategy strategy_of(const Material& material, const WeightedTerm& term, const std::string& name) {
  if (name == "default") return default_strategy(term);
  for (const Strategy strategy : strategies_of(term))
    if (name_of(strategy) == name) return strategy;
  throw InputError(material.name, "the term \"" + term.name + "\" has no strategy \"" + name +
                                      "\"; accepted: default, or what each term has, " + what_terms_accept(material));
}

} // namespace

std::string name_of(Strategy strategy) {
  switch (strategy) {
  case Strategy::cosine: return "cosine";
  case Strategy::half_vector: return "half_vector";
  case Strategy::visible_normals: return "visible_normals";
  case Strategy::heitz_2018: return "heitz_2018";
  case Strategy::kelemen: return "kelemen";
  case Strategy::eon: return "eon";
  }
  return {};
}

std::vector<std::string> strategy_names() {
  std::vector<std::string> names{"default"};
  for (const Strategy strategy : {Strategy::cosine, Strategy::half_vector, Strategy::visible_normals,
                                  Strategy::heitz_2018, Strategy::kelemen, Strategy::eon})
    names.push_back(name_of(strategy));
  return names;
}

std::vector<Strategy> strategies_of(const WeightedTerm& term) {
  std::vector<Strategy> all{Strategy::cosine};
  if (std::holds_alternative<Eon>(term.term)) all.push_back(Strategy::eon);
  if (const auto* complement = std::get_if<Complement>(&term.term); complement != nullptr && complement->isotropic())
    all.push_back(Strategy::kelemen);
  if (!is_about_half_vector(term)) return all;
  all.push_back(Strategy::half_vector);
  if (std::holds_alternative<Kelemen2001>(term.term)) all.push_back(Strategy::kelemen);
  const Facets facets(*term.facets());
  if (facets.visible()) all.push_back(Strategy::visible_normals);
  if (facets.visible() && facets.ggx()) all.push_back(Strategy::heitz_2018);
  return all;
}

Strategy default_strategy(const WeightedTerm& term) {
  if (!is_about_half_vector(term)) return Strategy::cosine;
  const std::vector<Strategy> all = strategies_of(term);
  const bool by_lambda = term.surface() != nullptr && term.surface()->has_lambda();
  const bool visible = std::ranges::find(all, Strategy::visible_normals) != all.end();
  return visible && by_lambda ? Strategy::visible_normals : Strategy::half_vector;
}

void require_strategy(const Material& material, const std::string& strategy, const std::string& where) {
  const std::vector<std::string> names = strategy_names();
  if (std::ranges::find(names, strategy) == names.end())
    throw InputError(where, unknown_name("strategy", strategy, names));
  for (const WeightedTerm& term : material.terms) strategy_of(material, term, strategy);
}

Sampler::Sampler(const Material& material, const std::string& strategy, const std::string& where)
    : map_(material.mesosurface()), mean_normal_(normalized({-map_.mean_x, -map_.mean_y, 1})) {
  require_strategy(material, strategy, where);
  for (const WeightedTerm& term : material.terms) {
    const Strategy by = strategy_of(material, term, strategy);
    const bool mirrors = by != Strategy::cosine && is_about_half_vector(term);
    lobes_.push_back({by, mirrors ? std::make_shared<const Facets>(*term.facets()) : nullptr, size_of(term),
                      term.fresnel(), mirrors ? nullptr : direct_lobe(term, by)});
    if (by == Strategy::kelemen && !mirrors && material.terms.size() == 2)
      complement_ = &std::get<Complement>(term.term);
  }
}

std::vector<double> Sampler::sizes(const Direction& omega_o) const {
  const double cosine = std::clamp(dot(omega_o, mean_normal_), 0.0, 1.0);
  std::vector<double> sizes;
  for (const Lobe& lobe : lobes_) {
    if (complement_ == nullptr) {
      sizes.push_back(lobe.fresnel == nullptr ? lobe.size : lobe.size * mean_reflectance(*lobe.fresnel, cosine));
      continue;
    }
    const AlbedoTable& table = complement_->of.table();
    double loss = 0;
    for (std::size_t c = 0; c < table.channels(); ++c)
      loss += table.loss(c, omega_o) / static_cast<double>(table.channels());
    sizes.push_back(lobe.direct != nullptr ? lobe.size * loss : 1 - loss);
  }
  return sizes;
}

std::vector<double> Sampler::shares(const Direction& omega_o) const {
  constexpr double even = 0.1;
  const auto count = static_cast<double>(lobes_.size());
  std::vector<double> shares = sizes(omega_o);
  double sum = 0;
  for (const double share : shares) sum += share;
  for (double& share : shares) share = sum > 0 ? (1 - even) * share / sum + even / count : 1 / count;
  return shares;
}

Sampler::Viewer::Viewer(const Sampler& sampler, const Direction& omega_o) : sampler_(&sampler), omega_o_(omega_o) {
  if (!(sampler.map_.project(omega_o).c > 0)) return;
  shares_ = sampler.shares(omega_o);
  for (const Lobe& lobe : sampler.lobes_) {
    facets_.emplace_back();
    if (draws_visible(lobe.strategy))
      facets_.back().emplace(*lobe.facets, omega_o, lobe.strategy == Strategy::heitz_2018);
  }
}

Direction Sampler::Viewer::sample(const SamplePoint& point) const {
  if (shares_.empty()) return sampler_->mean_normal_;
  SamplePoint rest = point;
  const std::size_t k = chosen(shares_, rest[2]);
  const Lobe& lobe = sampler_->lobes_[k];
  if (lobe.direct != nullptr) return lobe.direct->sample(omega_o_, rest);
  if (lobe.facets == nullptr) return sample_cosine(sampler_->mean_normal_, rest[0], rest[1]);
  const Direction m = facets_[k] ? facets_[k]->normal(rest) : lobe.facets->normal(rest);
  return normalized(reflected(omega_o_, m));
}

void Sampler::lobe_densities(const Lobe& lobe, std::size_t n, const Columns& omega_o, const Columns& omega_i,
                             double* out) const {
  if (lobe.direct != nullptr) {
    for (std::size_t k = 0; k < n; ++k) out[k] = lobe.direct->density(omega_o[k], omega_i[k]);
    return;
  }
  if (lobe.facets == nullptr) {
    for (std::size_t k = 0; k < n; ++k) out[k] = std::fmax(dot(omega_i[k], mean_normal_), 0.0) * std::numbers::inv_pi;
    return;
  }
  // A mirror with a normal that turns away from the viewer is seen from behind: its half vector is -m.
  DirectionArrays normals;
  normals.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Direction h = half_vector(omega_o[k], omega_i[k]);
    normals.set(k, !draws_visible(lobe.strategy) && h.z < 0 ? -1.0 * h : h);
  }
  const Columns m = normals.view();
  std::visit([&](const auto& d) { d.densities({m.x, m.y, m.z}, out, n); }, lobe.facets->distribution());
  for (std::size_t k = 0; k < n; ++k) {
    if (!(out[k] > 0)) continue;
    const Direction sum = omega_o[k] + omega_i[k]; // |o + i| = 2 |o.m|
    if (!draws_visible(lobe.strategy))
      out[k] *= m.z[k] / (2 * std::sqrt(dot(sum, sum)));
    else
      out[k] /= 4 * lobe.facets->visible_area(omega_o[k]);
  }
}

void Sampler::densities(std::size_t n, const Columns& omega_o, const Columns& omega_i, double* out) const {
  std::vector<std::vector<double>> shares_of_row(n);
  for (std::size_t k = 0; k < n; ++k)
    if (map_.project(omega_o[k]).c > 0) shares_of_row[k] = shares(omega_o[k]);
  std::fill_n(out, n, 0.0);
  std::vector<double> of_lobe(n);
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    lobe_densities(lobes_[l], n, omega_o, omega_i, of_lobe.data());
    for (std::size_t k = 0; k < n; ++k)
      if (!shares_of_row[k].empty()) out[k] += shares_of_row[k][l] * of_lobe[k];
  }
}

} // namespace brdfplot
