/// \file
/// Legends: which looks need an entry, and a flow of entries in rows that never covers the data.
#pragma once

#include <string>
#include <vector>

#include "draw/model.hpp"
#include "draw/svg/writer.hpp"

namespace brdfplot::plot {

/// How points with errors look: radius of the dot, width of the line that joins them.
inline constexpr double measured_radius = 2.4;
inline constexpr double measured_line = 1;

/// An upright bar with caps.
void append_error_bar(PathData& bars, double x, double top, double bottom);

struct LegendEntry {
  enum class Sample {
    line,
    dot,
    measured, ///< a dot with its bar, on the line that joins them
    band,     ///< a line on its band
    contour,
    undefined,
  };
  std::string label;
  Look look;
  Sample sample = Sample::line;
};

/// The looks of all that is drawn, and the legend entries they need.
struct LegendPlan {
  /// By panel, then by series; for heat maps by contour.
  std::vector<std::vector<Look>> looks;
  /// One legend above all panels, or (where labels belong to single panels) none.
  std::vector<LegendEntry> shared;
  /// By panel; empty where the shared legend does.
  std::vector<std::vector<LegendEntry>> own;
};

/// Decides between one legend for the figure and one for each panel. A shared legend lists each distinct label once; it
/// is possible when equal labels look equal and different labels differ.
LegendPlan plan_legend(const Figure& figure);

/// Entries placed in rows of a given width.
struct LegendLayout {
  struct Placed {
    LegendEntry entry;
    FittedText text;
    Point at; ///< the upper left corner, relative to the legend's
  };
  std::vector<Placed> placed;
  double height = 0;
};

LegendLayout lay_out_legend(const std::vector<LegendEntry>& entries, double width);

void draw_legend(SvgWriter& svg, const LegendLayout& legend, Point corner);

} // namespace brdfplot::plot
