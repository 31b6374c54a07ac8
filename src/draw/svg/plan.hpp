/// \file
/// The plan of a figure: everything measured and placed before anything is drawn.
#pragma once

#include <string>
#include <vector>

#include "draw/layout.hpp"
#include "draw/model.hpp"
#include "draw/svg/legend.hpp"
#include "draw/svg/writer.hpp"
#include "draw/ticks.hpp"

namespace brdfplot::plot {

/// The sizes of text, in user units.
namespace font {
inline constexpr double title = 17;
inline constexpr double panel_title = 14;
inline constexpr double axis = 13;
inline constexpr double tick = 12;
} // namespace font

/// The room that a panel needs around its plotting area.
struct Insets {
  double left = 0;
  double right = 0;
  double top = 0;
  double bottom = 0;
};

/// A label of a polar plot, with its place relative to the centre, or of an arrow of a profile.
struct PolarLabel {
  std::string text;
  double size = font::tick;
  Box box;
};

struct PanelPlan {
  const Panel* panel = nullptr;
  Kind kind = Kind::lines;
  std::string id; ///< prefix for ids within the document
  std::vector<Look> looks;
  Range x;
  Range y;
  Range value;
  Ticks x_ticks;
  Ticks y_ticks;
  Ticks value_ticks;
  FittedText title;
  FittedText note; ///< the notes, in a line under the title
  FittedText x_title;
  FittedText y_title;
  FittedText value_title;
  bool bar = false;    ///< whether the colour bar stands beside this panel
  bool narrow = false; ///< whether a polar plot has room for a few labels only
  LegendLayout legend;
  double title_top = 0;
  double legend_top = 0;
  Insets insets;
  Box plot;
  std::vector<PolarLabel> labels;
};

struct FigurePlan {
  std::string id;
  double width = 0;
  double height = 0;
  double shrink = 1; ///< of plots beside what they are in a figure for screens
  int columns = 1;
  bool mixed = false; ///< whether panels are measured in several ways; each then has a cell of one width
  FittedText title;
  LegendLayout legend;
  double legend_top = 0;
  std::vector<PanelPlan> panels;
};

inline constexpr double page_margin = 14;
inline constexpr double column_gap = 14;

/// Measures and places all parts of a figure.
FigurePlan plan_figure(const Figure& figure, const Layout& layout);

/// Panels that share a range have the same group. Rows are those of the figure, though paper may have no room for them.
std::size_t share_group(const Figure& figure, std::size_t panel);

/// Whether the panel below, if there is one, is of its kind and has the same axis there, which then is titled once.
bool repeated_below(const FigurePlan& plan, std::size_t index, Axis Panel::*axis);

/// Sets the ranges of all panels, shared as the figure asks, among those of a kind.
void plan_ranges(const Figure& figure, FigurePlan& plan);

/// Grid lines, under the data.
void draw_grid(SvgWriter& svg, const PanelPlan& plan);
/// Frame, ticks, their labels and the axis titles, over the data.
void draw_axes(SvgWriter& svg, const PanelPlan& plan);

/// The ends of the bars of a simulated series: two standard errors above and below its values.
std::vector<double> upper_bounds(const Series& series);
std::vector<double> lower_bounds(const Series& series);

/// Whether the colours of a heat map diverge from zero: values of both signs on a linear scale.
bool is_diverging(const PanelPlan& plan);

/// The place of a pair of values in the plotting area.
Point to_point(const PanelPlan& plan, double x, double y);

/// Appends a polyline of values, broken where a point cannot be shown and cut at the edges of the plotting area.
void append_curve(PathData& path, const PanelPlan& plan, const std::vector<double>& x, const std::vector<double>& y);

/// The dots of the series whose points have names, and the names, each where it covers nothing.
void draw_named_points(SvgWriter& svg, const PanelPlan& plan);

} // namespace brdfplot::plot
