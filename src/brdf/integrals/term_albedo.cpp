#include "brdf/integrals/term_albedo.hpp"

#include "base/number.hpp"
#include "brdf/integrals/kinks.hpp"
#include "brdf/integrals/reflected_light.hpp"
#include "brdf/material.hpp"
#include "microfacet/remembered.hpp"
#include "models/model_text.hpp"

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

AlbedoTable table_of(const WeightedTerm& term, const std::string& own_name) {
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
  const std::string name = "\"" + own_name + "\"";
  if (!(table.error() <= largest_error))
    throw AccuracyError("albedo of " + name, "reached an error of " + format_number(table.error()) +
                                                 " in its table (asked: " + format_number(largest_error) + ")");
  if (table.largest() > 1 + table.error())
    throw InputError(own_name, "has an albedo of " + format_number(table.largest()) + " at " + format_number(angle) +
                                   "deg; accepted: a term that reflects no more than it gets");
  return table;
}

/// What the albedo depends on: all but the name.
std::string key_of(const TermDescription& d) {
  return d.type + " " + text_of_value(d.weight) + " " + text_of_model(d.distribution) + text_of_model(d.masking) +
         (d.shadowing ? text_of_model(*d.shadowing) : "") + text_of_model(d.fresnel) + text_of_model({"", d.values});
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
    : name_(term.name.empty() ? term.type : term.name), shared_(remembered<std::shared_ptr<Shared>>(key_of(term), [&] {
        auto shared = std::make_shared<Shared>();
        shared->term = build_term(term);
        require_symmetry(shared->term);
        require_smooth(shared->term);
        return shared;
      })) {}

std::size_t TermAlbedo::channels() const { return static_cast<std::size_t>(shared_->term.channels()); }

bool TermAlbedo::is_isotropic() const { return shared_->term.is_isotropic(); }

const AlbedoTable& TermAlbedo::table() const {
  std::call_once(shared_->made, [&] { shared_->table = table_of(shared_->term, name_); });
  return shared_->table;
}

} // namespace brdfplot
