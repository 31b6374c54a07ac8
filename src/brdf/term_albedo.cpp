#include "brdf/term_albedo.hpp"

#include "base/number.hpp"
#include "brdf/kinks.hpp"
#include "brdf/material.hpp"
#include "brdf/reflected_light.hpp"
#include "microfacet/remembered.hpp"

#include <cmath>
#include <mutex>
#include <numbers>

namespace brdfplot {

namespace {

const Distribution* distribution_of(const WeightedTerm& term) {
  return term.surface() != nullptr ? &term.surface()->distribution : term.facets();
}

/// The table is a function of cos 2 phi: E has to be symmetric about x and y.
void require_symmetry(const WeightedTerm& term) {
  if (!has_mirror_planes(term))
    throw MaterialError("/of", "\"" + term.name +
                                   "\" is not symmetric about x and y; accepted: a term that is centred, "
                                   "without correlation, and without a masking formula");
}

/// What has a rule of its own is measured, and its albedo takes seconds to 1e-6 and is hardly known better.
void require_smooth(const WeightedTerm& term) {
  if (is_measured(term.term))
    throw MaterialError("/of", "\"" + term.name +
                                   "\" is measured, and its albedo not known as closely as a table of it "
                                   "takes; accepted: a term that is a formula");
}

AlbedoTable table_of(const WeightedTerm& term) {
  const double tolerance = term.is_isotropic() ? 1e-8 : 1e-7; // of two dimensions, which takes seconds
  constexpr double largest_error = 1e-6;
  const auto channels = static_cast<std::size_t>(term.channels());
  const bool cut = term.is_isotropic() && term.surface() != nullptr;
  AlbedoTable table(
      channels, term.is_isotropic(),
      [&](const Direction& o) {
        return reflected_light({&term}, o, 0.1 * tolerance, {0, channels}, every_direction);
      },
      tolerance, cut ? kinks_of_viewers(*term.surface()) : std::vector<double>{});
  const double angle = std::acos(table.where_largest().z) * 180 / std::numbers::pi;
  const std::string name = "\"" + term.name + "\"";
  if (!(table.error() <= largest_error))
    throw AccuracyError("albedo of " + name, "reached an error of " + format_number(table.error()) +
                                                 " in its table (asked: " + format_number(largest_error) + ")");
  if (table.largest() > 1 + table.error())
    throw InputError(term.name, "has an albedo of " + format_number(table.largest()) + " at " + format_number(angle) +
                                    "deg; accepted: a term that reflects no more than it gets");
  return table;
}

std::string key_of(const ModelChoice& choice);

/// A value as a text that no other has.
std::string key_of(const Value& value) {
  const auto joined = [](const auto& numbers) {
    std::string text = "[";
    for (const double number : numbers) text += format_number(number) + ",";
    return text + "]";
  };
  if (const auto* number = std::get_if<double>(&value)) return format_number(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return '"' + *text + '"';
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* pair = std::get_if<Vec2>(&value)) return joined(*pair);
  if (const auto* rgb = std::get_if<Rgb>(&value)) return joined(*rgb);
  std::string text;
  for (const auto& part : std::get<WeightedChoices>(value)) text += format_number(part.weight) + key_of(part.model);
  return text;
}

std::string key_of(const Values& values) {
  std::string text = "{";
  for (const auto& [key, value] : values.map()) text += key + ":" + key_of(value) + ";";
  return text + "}";
}

std::string key_of(const ModelChoice& choice) { return choice.type + key_of(choice.values); }

std::string key_of(const TermDescription& d) {
  return d.name + " " + d.type + key_of(d.weight) + key_of(d.distribution) + key_of(d.masking) +
         (d.shadowing ? key_of(*d.shadowing) : "") + key_of(d.fresnel) + key_of(d.values);
}

} // namespace

bool has_mirror_planes(const WeightedTerm& term) {
  const Distribution* facets = distribution_of(term);
  const bool formula = term.surface() != nullptr && is_formula(term.surface()->masking);
  return !formula && (facets == nullptr || is_aligned(*facets));
}

struct TermAlbedo::Shared {
  WeightedTerm term;
  std::once_flag made;
  AlbedoTable table;
};

TermAlbedo::TermAlbedo(const TermDescription& term)
    : shared_(remembered<std::shared_ptr<Shared>>(key_of(term), [&] {
        auto shared = std::make_shared<Shared>();
        shared->term = build_term(term);
        require_symmetry(shared->term);
        require_smooth(shared->term);
        return shared;
      })) {}

std::size_t TermAlbedo::channels() const { return static_cast<std::size_t>(shared_->term.channels()); }

bool TermAlbedo::is_isotropic() const { return shared_->term.is_isotropic(); }

const AlbedoTable& TermAlbedo::table() const {
  std::call_once(shared_->made, [&] { shared_->table = table_of(shared_->term); });
  return shared_->table;
}

} // namespace brdfplot
