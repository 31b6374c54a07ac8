/// \file
/// A figure as data: what the writers (SVG, CSV, HTML) draw. It knows nothing of materials or JSON.
#pragma once

#include "draw/kinds.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::plot {

enum class Scale { linear, logarithmic };

/// How the axis is labelled. Angles are radians everywhere in the model; `degrees` converts for tick labels only.
enum class Unit { none, radians, degrees };

/// NaN in a bound means: take it from the data.
inline constexpr double automatic = std::numeric_limits<double>::quiet_NaN();

/// Text of every label may use `_x`, `_{xyz}`, `^x` and `^{xyz}` for sub- and superscripts: "θ_o", "10^{-3}".
struct Axis {
  std::string label;  ///< drawn, with markup
  std::string column; ///< name of the CSV column
  Scale scale = Scale::linear;
  Unit unit = Unit::none;
  double from = automatic;
  double to = automatic;
};

/// Red, green or blue.
enum class Hue { red, green, blue };

/// A polyline. A NaN in y breaks the line.
struct Series {
  std::string label;
  std::vector<double> x; ///< the swept variable (radians for angles), ascending
  std::vector<double> y; ///< the value (for polar plots: the radius, >= 0)
  /// Which entry of the palette; series of equal label share it across panels.
  int style = 0;
  /// In [0, 1]: the place in a sequential ramp, for families such as alpha = 0.1 ... 1; absent: categorical palette.
  std::optional<double> ramp;
  /// Standard error of each y, drawn as bars or a band of twice its size; empty: y is exact.
  std::vector<double> error{};
  /// Of each point: a dot with this name beside it, instead of a line; an empty name: the dot alone. Empty: a line.
  /// Kind::lines only. A name that has no room without covering another, a dot or the frame is the dot's title.
  std::vector<std::string> names{};
  /// The channel of which the curve is: drawn in its colour, and `style` tells materials apart by dashes.
  std::optional<Hue> hue{};
};

/// A direction of a polar plot, drawn as an arrow from (or, when `incoming`, towards) the surface point.
struct Arrow {
  std::string label;
  double theta = 0; ///< signed angle from the normal, radians; positive to the right
  bool incoming = false;
};

/// A number about a panel, drawn under its title.
struct Note {
  std::string text;  ///< drawn, with markup
  std::string label; ///< in the CSV
  double value = 0;
  double error = 0; ///< standard error
};

/// Values on a grid, row-major with x fastest: value[iy * x.size() + ix]. Cell centres are (x[ix], y[iy]).
struct Grid {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> value;
};

/// A curve over a heat map (a boundary), with a label for the legend: a set of open or closed polylines.
struct Contour {
  std::string label;
  struct Line {
    std::vector<double> x;
    std::vector<double> y;
  };
  std::vector<Line> lines;
};

/// What stands about the surface of a profile, in its own units; angles are true.
struct Sketch {
  struct Line {
    double x0, y0, x1, y1;
  };
  struct Pointer {
    std::string label;
    double x, y;  ///< where it touches the surface
    double theta; ///< signed angle from the vertical
  };
  Line window{};                    ///< corners of the surface that is drawn
  std::vector<Line> surface{};      ///< the body below it, if it is one: the upper edges of it
  std::vector<Line> rays{};         ///< that leave the surface
  std::vector<Line> stopped_rays{}; ///< that meet it again, from their beginning to there
  std::vector<Line> once{}; ///< paths of light that are reflected once: the ray to the surface and the one from it
  std::vector<Line> more_often{};  ///< those that are reflected more often
  std::vector<Pointer> exits{};    ///< where paths leave
  std::vector<Line> sight_lines{}; ///< from the ends of what is visible to the line on which it is projected
  std::vector<Line> projection{};  ///< what is visible, on that line
  std::vector<Line> mesosurface{}; ///< none or one
  std::vector<Pointer> normals{};  ///< short arrows without label
  std::vector<Pointer> arrows{};
};

/// Pixels of 8 bits a channel in sRGB (IEC 61966-2-1), in rows from the top: 1 channel (grey) or 3, then, where it is
/// not opaque, how much of the pixel is covered.
struct Picture {
  int width = 0;
  int height = 0;
  int channels = 1;
  bool opaque = true;
  std::vector<unsigned char> bytes{};
};

struct Panel {
  std::string title; ///< drawn above the panel and written to the CSV; may be empty when there is one panel
  Axis x;
  Axis y; ///< lines: the value; polar: the radius; heat map: the second swept variable
  std::vector<Series> series;
  std::vector<Arrow> arrows;     ///< polar only
  std::optional<Axis> value;     ///< heat map only: the colour bar
  std::optional<Grid> grid;      ///< heat map only
  std::vector<Contour> contours; ///< heat map only
  std::vector<Note> notes{};
  std::optional<Sketch> sketch{}; ///< profile only: its series are the parts of the surface, broken by NaN
  /// Spheres only; `x` goes over the picture, in radii. Its series are the radiance along a diameter, not drawn.
  std::optional<Picture> picture{};
  bool drawn = true;          ///< else it is in the CSV only
  std::optional<Kind> kind{}; ///< where it is not the figure's
};

/// Which panels share the range of their value axis where it is automatic.
enum class Share { none, rows, all };

struct Figure {
  std::string id;
  std::string title;
  std::string description; ///< one or two sentences: the SVG's <desc> and the caption
  Kind kind = Kind::lines;
  int columns = 1; ///< panels stand in rows of so many
  Share share = Share::none;
  std::vector<Panel> panels;
};

/// How a panel of the figure is drawn.
inline Kind kind_in(const Figure& figure, const Panel& panel) { return panel.kind.value_or(figure.kind); }

/// The figure as one standalone SVG document (UTF-8, viewBox, text as text).
/// Panels that are not `drawn` are left out. \throws nothing that depends on the data; an empty figure gives an SVG
/// with the title only.
std::string to_svg(const Figure& figure);

/// The figure's data as tidy CSV: `panel,series,<x column>,<y column>`, a figure of heat maps `panel,<x>,<y>,<value>`
/// (beside other kinds with an empty series); where panels
/// sweep different variables, a column for each, empty in the rows of the others. Where their values have different
/// names, the column is `value`. Where a
/// series is simulated, `<y column>_stderr` follows: the standard error, empty for what is exact; where points have
/// names, `name` follows. In a profile an empty
/// y ends a part of the surface. One header line, LF, numbers in the shortest form that reads back to the same double;
/// text fields quoted when needed (RFC 4180). Markup of labels is stripped ("θ_o" stays "θ_o": only braces go).
std::string to_csv(const Figure& figure);

} // namespace brdfplot::plot
