/// \file
/// How things look: colours that the colour blind can tell apart, dashes beside the colours, colour maps.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace brdfplot::plot {

struct Rgb {
  double r = 0; ///< in [0, 1], sRGB
  double g = 0;
  double b = 0;
};

/// "#rrggbb"
std::string hex(const Rgb& colour);

/// A named colour of the drawings: the CSS variable `--bp-<name>` with its values on light and on dark pages.
struct ThemeColour {
  std::string_view name;
  std::string_view light;
  std::string_view dark;
};

/// The categorical palette (Okabe and Ito's order, then ink), named s0 to s6.
inline constexpr std::array<ThemeColour, 7> palette = {{{"s0", "#0072b2", "#56a9e0"},
                                                        {"s1", "#d55e00", "#ff8a47"},
                                                        {"s2", "#009e73", "#2fcf9f"},
                                                        {"s3", "#cc79a7", "#e79ac4"},
                                                        {"s4", "#e69f00", "#f2b632"},
                                                        {"s5", "#56b4e9", "#9bd6fa"},
                                                        {"s6", "#1a1a1a", "#e8e8e8"}}};

/// What is not data.
inline constexpr std::array<ThemeColour, 6> chrome = {{{"bg", "#ffffff", "#16181c"},
                                                       {"ink", "#1a1a1a", "#e8e8e8"},
                                                       {"muted", "#444444", "#b8bcc4"},
                                                       {"frame", "#555555", "#8b9099"},
                                                       {"grid", "#dddddd", "#33373f"},
                                                       {"nan", "#c8c8c8", "#4a4e57"}}};

/// The sequential ramp for families of curves is quantised to so many steps, each with a class of its own.
inline constexpr int ramp_steps = 20;

/// The step of a place in [0, 1].
int ramp_step(double place);

/// Ramp colours from dark violet to amber: of falling darkness on white; lifted so that all can be read on dark.
std::string ramp_colour(int step, bool dark);

/// The dash pattern as a `stroke-dasharray` value; the first is empty (solid).
std::string_view dash(int index);

/// Heat maps use so many colours.
inline constexpr int map_colours = 64;

/// Viridis: even steps of the index look like even steps, also in grey.
Rgb sequential_colour(int index);

/// Blue over white to red for data of both signs.
Rgb diverging_colour(int index);

/// The looks of one series: names the CSS class for its colour, and the dash index.
struct Look {
  std::string colour; ///< "s2" or "r14", without the prefix of the class
  int dash = 0;
  bool operator==(const Look&) const = default;
};

/// The look of a series of the given style or place in a ramp; `order` alternates the dashes of a ramp.
Look look_of(int style, const std::optional<double>& ramp, int order);

/// A style sheet. Colours that a page may replace are rules with their light value, and once more with the CSS variable
/// inside `@supports`: renderers without variables (resvg, CairoSVG) take no fallback of a declaration, but skip that.
class StyleSheet {
public:
  /// The colour class of a look for strokes (`bp-<name>`) and fills (`bp-f-<name>`).
  void add_colour(const std::string& colour);
  /// The fills of a heat map's colours: `bp-q<i>` of the sequential map, `bp-d<i>` of the diverging one.
  void add_map(bool diverging);
  /// Everything that is not data.
  void add_chrome();

  std::string text() const;

private:
  void add_rule(std::string_view selector, std::string_view property, std::string_view name, std::string_view value);

  std::string plain_, themed_;
};

/// The rules of all colours: one style sheet for all drawings of a page.
std::string every_rule();

/// Appends `--bp-...` variables with the dark values of all the colours, for a rule of a page's style sheet.
void append_dark_variables(std::string& css);

} // namespace brdfplot::plot
