/// \file
/// Labels as text: the little markup for sub- and superscripts, escaping, and how wide a label will be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brdfplot::plot {

/// A piece of a label that stands on one height.
struct Run {
  enum class Level { base, sub, super };
  std::string text;
  Level level = Level::base;
  bool operator==(const Run&) const = default;
};

/// Splits a label into runs. `_x`, `_{xyz}`, `^x` and `^{xyz}` lower or raise; `\_` and `\^` are literal.
///
/// An underscore is also literal at the start of a word and where it joins the parts of an identifier (`file_name`,
/// `heitz2014_x`), because captions name files and keys; braces always make a subscript.
std::vector<Run> parse_markup(std::string_view label);

/// The label as plain text that keeps `_` and `^`: only the braces of the markup and escaping backslashes go.
std::string strip_markup(std::string_view label);

/// The label that shows a text as it is: its `_` and `^` escaped.
std::string literal_label(std::string_view text);

/// Appends plain text escaped for XML and HTML, in element content or in a quoted attribute. Bytes that are not UTF-8
/// and characters that XML forbids become U+FFFD, so that the result is well-formed whatever the text is.
void append_escaped(std::string& out, std::string_view text);

/// Appends the label for the inside of an SVG `<text>` of the given font size: shifted `<tspan>`s for the scripts.
void append_tspans(std::string& out, std::string_view label, double size);

/// Appends the label for HTML, with `<sub>` and `<sup>`.
void append_html(std::string& out, std::string_view label);

/// An estimate of the drawn width, in the units of the font size. It errs on the wide side (DejaVu Sans), so that what
/// fits by this measure fits in other fonts too.
double text_width(std::string_view label, double size, bool bold = false);

/// A label broken into lines and the font size at which they fit.
struct FittedText {
  std::vector<std::string> lines;
  double size = 0;
  bool bold = false;

  [[nodiscard]] double line_height() const { return 1.25 * size; }
  [[nodiscard]] double height() const { return line_height() * static_cast<double>(lines.size()); }
  [[nodiscard]] double width() const;
};

/// Breaks a label at blanks to lines of at most `width`; when that makes more than `max_lines`, shrinks the font as far
/// as `smallest_font`, and then uses as many lines as it takes.
FittedText fit_text(std::string_view label, double size, double width, std::size_t max_lines, bool bold = false);

/// Below this, in user units, a label cannot be read in a figure of column width.
inline constexpr double smallest_font = 11;

} // namespace brdfplot::plot
