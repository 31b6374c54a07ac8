/// \file
/// Labels for series that have none: made from what differs between the series of a panel.
#pragma once

#include "config/figure/scope.hpp"

#include <string>
#include <vector>

namespace brdfplot::config {

/// What tells one series from another: the name of a trait with its text, in the order in which a label has them.
struct Trait {
  std::string name, text;
};
using Traits = std::vector<Trait>;

/// "alpha" as in labels: Greek letters, one subscript.
std::string symbol(const std::string& variable);

/// Adds what a term is of, at which settings; what another term of the series has already is said once.
void add_traits(Traits& traits, const plot::Term& term, const Scope& scope);

/// The trait of an operation on terms, before theirs.
Trait operation_trait(plot::Expression::Operation operation);

/// A label for each series: the traits in which not all agree. `without`: a trait that is left out.
std::vector<std::string> labels_of(const std::vector<Traits>& series, const std::string& without = {});

} // namespace brdfplot::config
