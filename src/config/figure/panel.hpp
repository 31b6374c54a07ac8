/// \file
/// The panels of a figure.
#pragma once

#include "config/figure/levels.hpp"

namespace brdfplot::config {

/// What a panel takes from its figure.
struct PanelContext {
  const JsonFile& file;
  const Levels& levels;
  plot::Kind kind; ///< where the panel names none
  double tolerance = 0;
};

/// The kind of this name.
plot::Kind kind_named(const std::string& name);

/// The panel at `pointer`, in the scope of its figure or of one value of its `for_each`. Fails where something is wrong
/// with it.
plot::PanelDescription read_panel(const PanelContext& context, const Json& object, const std::string& pointer,
                                  const Scope& scope);

} // namespace brdfplot::config
