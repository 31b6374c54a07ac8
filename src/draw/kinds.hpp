/// \file
/// The list of kinds of panels. A new one is one file in svg/ and its lines here: in `Kind`, what it declares, and in
/// panel_kinds.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace brdfplot::plot {

struct Figure;
struct FigurePlan;
struct PanelPlan;
class Extent;
class SvgWriter;

enum class Kind {
  lines,   ///< cartesian curves, y against x
  polar,   ///< lobes in the plane of incidence: radius y at the signed angle x from the normal
  heatmap, ///< a value over two swept variables, with a colour bar
  profile, ///< a microsurface in profile, height y at x on one scale, with directions and rays
  spheres, ///< lit spheres, each a picture
};

/// What the drawing of a kind gives.
struct PanelKind {
  std::string_view name; ///< in JSON
  /// Sets the range of the value's axis from the data of the panels that share it.
  void (*set_range)(PanelPlan& panel, const Extent& data, int columns);
  /// Sets ticks, axis titles, insets and sizes of the plots that it measures, in a grid of the given width; other
  /// panels are left alone.
  void (*measure)(const Figure& figure, FigurePlan& plan, double width);
  void (*draw)(SvgWriter& svg, const PanelPlan& plan);
};

/// Straight axes.
void set_lines_range(PanelPlan& panel, const Extent& data, int columns);
void measure_cartesian(const Figure& figure, FigurePlan& plan, double width);
void draw_lines(SvgWriter& svg, const PanelPlan& plan);

void set_polar_range(PanelPlan& panel, const Extent& data, int columns);
void measure_polar(const Figure& figure, FigurePlan& plan, double width);
void draw_polar(SvgWriter& svg, const PanelPlan& plan);

void set_heatmap_range(PanelPlan& panel, const Extent& data, int columns);
void draw_heatmap(SvgWriter& svg, const PanelPlan& plan);

/// The scale of a profile is that of both axes; Share other than none: that of all panels. measure_profile() sets it.
void set_no_range(PanelPlan& panel, const Extent& data, int columns);
void measure_profile(const Figure& figure, FigurePlan& plan, double width);
void draw_profile(SvgWriter& svg, const PanelPlan& plan);

void measure_spheres(const Figure& figure, FigurePlan& plan, double width);
void draw_spheres(SvgWriter& svg, const PanelPlan& plan);

/// In the order of `Kind`.
inline constexpr std::array panel_kinds = {
    PanelKind{"lines", set_lines_range, measure_cartesian, draw_lines},
    PanelKind{"polar", set_polar_range, measure_polar, draw_polar},
    PanelKind{"heatmap", set_heatmap_range, measure_cartesian, draw_heatmap},
    PanelKind{"profile", set_no_range, measure_profile, draw_profile},
    PanelKind{"spheres", set_no_range, measure_spheres, draw_spheres},
};

constexpr const PanelKind& kind_of(Kind kind) { return panel_kinds[static_cast<std::size_t>(kind)]; }

} // namespace brdfplot::plot
