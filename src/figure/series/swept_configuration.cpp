#include "figure/series/configuration.hpp"

#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <map>

namespace brdfplot::plot {

namespace {

/// So many of direction_variables() move directions; what comes after them, and parameters, change the surface.
constexpr std::ptrdiff_t moving_variables = 12;

bool changes_surface(const std::string& variable) {
  const auto& names = direction_variables();
  return std::ranges::find(names, variable) - names.begin() >= moving_variables;
}

} // namespace

SweptConfiguration::SweptConfiguration(const Term& term, std::vector<std::string> swept)
    : fixed_(term.material), swept_(std::move(swept)) {
  for (const auto& setting : term.at) fixed_.set(setting);
  for (std::size_t k = 0; k < swept_.size(); ++k)
    if (std::ranges::find(term.at, swept_[k], &Setting::variable) == term.at.end())
      (changes_surface(swept_[k]) ? changing_ : moving_).push_back(k);
  if (changing_.empty()) surface_ = fixed_.surface();
}

bool SweptConfiguration::is_constant() const { return changing_.empty() && moving_.empty(); }

Configuration::Ready SweptConfiguration::at(const std::vector<double>& values) const {
  Configuration configuration = fixed_;
  for (const auto* variables : {&changing_, &moving_})
    for (const std::size_t k : *variables) configuration.set({swept_[k], values[k]});
  return configuration.ready();
}

std::vector<SweptConfiguration::Rows> SweptConfiguration::rows_by_surface(const SweptColumns& columns) const {
  const std::size_t count = columns.empty() ? 1 : columns.front().size();
  std::vector<Rows> groups;
  std::map<std::vector<double>, std::size_t> known;
  for (std::size_t row = 0; row < count; ++row) {
    std::vector<double> values;
    for (const std::size_t k : changing_) values.push_back(columns[k][row]);
    const auto [place, is_new] = known.emplace(std::move(values), groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(row);
  }
  return groups;
}

void SweptConfiguration::for_each_surface(const SweptColumns& columns, const Visitor& visit) const {
  constexpr std::size_t most = 1024;
  Configuration configuration = fixed_;
  const auto set = [&](const std::vector<std::size_t>& variables, std::size_t row) {
    for (const std::size_t k : variables) configuration.set({swept_[k], columns[k][row]});
  };
  for (const Rows& rows : rows_by_surface(columns)) {
    set(changing_, rows.front());
    const auto changed = surface_ ? std::nullopt : std::optional(configuration.surface());
    const Configuration::Surface& surface = surface_ ? *surface_ : *changed;
    for (std::size_t first = 0; first < rows.size(); first += most) {
      throw_if_interrupted();
      const auto from = rows.begin() + static_cast<std::ptrdiff_t>(first);
      const Rows some(from, from + static_cast<std::ptrdiff_t>(std::min(most, rows.size() - first)));
      std::vector<Directions> directions;
      for (const std::size_t row : some) {
        set(moving_, row);
        directions.push_back(configuration.directions(surface));
      }
      visit(surface, some, directions);
    }
  }
}

} // namespace brdfplot::plot
