/// \file
/// The series of a panel.
#pragma once

#include "config/figure/levels.hpp"

namespace brdfplot::config {

/// What a series takes from its panel.
struct SeriesContext {
  const JsonFile& file;
  const Levels& levels;
  plot::Kind kind;
  double tolerance = 0;
  std::vector<Sweep> swept;
};

/// The series of a panel at `pointer`, with labels where they have none and there are several.
std::vector<plot::SeriesDescription> read_series(const SeriesContext& context, const Json& panel,
                                                 const std::string& pointer, const Scope& scope);

/// A quantity, or an operation on others.
plot::Expression read_expression(const SeriesContext& context, const Json& object, const std::string& pointer,
                                 const Scope& scope);

} // namespace brdfplot::config
