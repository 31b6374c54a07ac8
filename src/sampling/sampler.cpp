#include "sampling/sampler.hpp"

#include "base/errors.hpp"
#include "sampling/cosine.hpp"
#include "sampling/own_strategy.hpp"

#include <algorithm>
#include <cmath>

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

/// F of each cosine, as a mean of channels.
std::vector<double> mean_reflectances(const Fresnel& fresnel, const std::vector<double>& cosines) {
  std::vector<double> sums(cosines.size(), 0), values(cosines.size());
  std::visit(
      [&](const auto& f) {
        const std::size_t channels = f.coloured() ? 3 : 1;
        for (std::size_t c = 0; c < channels; ++c) {
          f.reflectances(cosines.data(), c, values.data(), values.size());
          for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += values[k] / static_cast<double>(channels);
        }
      },
      fresnel);
  return sums;
}

/// What is not reflected, as a mean of channels.
double mean_loss(const AlbedoTable& table, const Direction& omega_o) {
  double loss = 0;
  for (std::size_t c = 0; c < table.channels(); ++c)
    loss += table.loss(c, omega_o) / static_cast<double>(table.channels());
  return loss;
}

bool is_about_half_vector(const WeightedTerm& term) {
  return std::visit(
      [](const auto& t) {
        return requires { t.about_half_vector; };
      },
      term.term);
}

/// null: none, or half_vector.
std::shared_ptr<const DirectLobe> own_lobe(const WeightedTerm& term) {
  return with_own_strategy<std::shared_ptr<const DirectLobe>>(term,
                                                              [](const auto& own, auto& t) { return own.lobe(t); });
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
  const bool mirrors = is_about_half_vector(term);
  if (mirrors) all.push_back(Strategy::half_vector);
  const auto own = with_own_strategy<std::optional<Strategy>>(term, [](const auto& of, auto&) { return of.strategy; });
  if (own) all.push_back(*own);
  if (!mirrors) return all;
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
                      term.fresnel(), mirrors || by == Strategy::cosine ? nullptr : own_lobe(term)});
    if (lobes_.back().direct != nullptr && material.terms.size() == 2)
      other_ = with_own_strategy<const AlbedoTable*>(term, [](const auto& own, auto& t) { return own.other(t); });
  }
}

std::vector<double> Sampler::sizes(std::size_t n, const Columns& omega_o) const {
  std::vector<double> sizes(lobes_.size() * n), cosines(n), losses(n);
  for (std::size_t k = 0; k < n; ++k) {
    cosines[k] = std::clamp(dot(omega_o[k], mean_normal_), 0.0, 1.0);
    if (other_ != nullptr) losses[k] = mean_loss(*other_, omega_o[k]);
  }
  for (std::size_t l = 0; l < lobes_.size(); ++l) {
    const Lobe& lobe = lobes_[l];
    std::vector<double> own(n, 1);
    if (other_ != nullptr)
      for (std::size_t k = 0; k < n; ++k) own[k] = lobe.direct != nullptr ? lobe.size * losses[k] : 1 - losses[k];
    else if (lobe.fresnel != nullptr)
      own = mean_reflectances(*lobe.fresnel, cosines);
    const double factor = other_ == nullptr ? lobe.size : 1;
    for (std::size_t k = 0; k < n; ++k) sizes[l * n + k] = factor * own[k];
  }
  return sizes;
}

std::vector<double> Sampler::shares_of_rows(std::size_t n, const Columns& omega_o) const {
  constexpr double even = 0.1;
  const std::size_t count = lobes_.size();
  std::vector<double> shares = count > 1 ? sizes(n, omega_o) : std::vector<double>(n, 1);
  for (std::size_t k = 0; k < n; ++k) {
    double sum = 0;
    for (std::size_t l = 0; l < count; ++l) sum += shares[l * n + k];
    const double each = 1 / static_cast<double>(count);
    const bool above = map_.project(omega_o[k]).c > 0;
    for (std::size_t l = 0; l < count; ++l) {
      double& share = shares[l * n + k];
      share = !above ? 0 : sum > 0 ? (1 - even) * share / sum + even * each : each;
    }
  }
  return shares;
}

std::vector<double> Sampler::shares(const Direction& omega_o) const {
  return shares_of_rows(1, {&omega_o.x, &omega_o.y, &omega_o.z});
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

} // namespace brdfplot
