/// \file
/// A figure from a few words: what `brdfplot plot MATERIAL.json -q QUANTITY` draws, as the figure file that it stands
/// for.
#pragma once

#include "config/load.hpp"

#include <string>
#include <utility>
#include <vector>

namespace brdfplot::config {

struct QuickFigure {
  std::vector<std::string> materials;  ///< files, or JSON (material_of_argument())
  std::vector<std::string> quantities; ///< a panel each
  std::vector<std::string> at;         ///< "VARIABLE=VALUE", what is fixed
  std::vector<std::string> over;       ///< "VARIABLE=VALUE,VALUE...", a series for each value
  std::vector<std::string> vs;         ///< "masking=TYPE" and the like: a series beside that without it
  std::string x;                       ///< "VARIABLE=FROM:TO", what is swept; empty: by the quantity
  std::string channel;                 ///< of what is coloured; empty: each, where they differ
};

/// The text of the figure file. Files of materials are referred to by their paths relative to `folder`.
/// What is swept, and how it is drawn: brdf, brdf_cos over theta_i and d_visible over theta_m as lobes; p22, d, d_cos
/// over theta_m, g2 over theta_i, fresnel over theta_d, all else over theta_o, as curves; where `at` or `over` fixes
/// that, the next direction of which it is a function. Several quantities are panels of their own kinds; a theta_o of
/// `at` is for lobes and g2 where there are any, and the others go over it. It is 45 degrees where they are given none.
/// \throws InputError
std::string quick_figure(const QuickFigure& figure, const std::string& folder);

/// The same, read as a figure.
plot::FigureDescription load_quick_figure(const QuickFigure& figure);

} // namespace brdfplot::config
