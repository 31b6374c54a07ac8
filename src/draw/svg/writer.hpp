/// \file
/// The drawing operations that the panels of every kind use: SVG elements appended to one string.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/style.hpp"
#include "draw/text.hpp"

namespace brdfplot::plot {

/// A rectangle in user units; y grows downward.
struct Box {
  double x = 0;
  double y = 0;
  double w = 0;
  double h = 0;

  [[nodiscard]] double right() const { return x + w; }
  [[nodiscard]] double bottom() const { return y + h; }
  /// Whether two boxes come closer than `gap`.
  [[nodiscard]] bool touches(const Box& other, double gap) const {
    return x - gap < other.right() && other.x - gap < right() && y - gap < other.bottom() && other.y - gap < bottom();
  }
};

struct Point {
  double x = 0;
  double y = 0;
};

/// Path data in relative coordinates of whole hundredths: short, and without drift, because what is rounded is the
/// absolute position.
class PathData {
public:
  void move(Point to);
  void line(Point to);
  void close() { data_ += 'z'; }
  /// A dot, for a point without neighbours.
  void dot(Point at, double radius);
  void rectangle(const Box& box);
  /// A circular arc, clockwise when `sweep`.
  void arc(double radius, bool large, bool sweep, Point to);

  [[nodiscard]] bool empty() const { return data_.empty(); }
  [[nodiscard]] const std::string& text() const { return data_; }

private:
  void pair(long long x, long long y);

  std::string data_;
  long long x_ = 0;
  long long y_ = 0;
  char command_ = 0;
};

/// Appends a polyline; points that a line through their neighbours passes by are left out.
void append_polyline(PathData& path, const std::vector<Point>& points);

enum class Anchor { start, middle, end };

/// What joins a legend's entry and what is drawn of its series, for a page that hides them: ` data-key="s0.1"`.
std::string key_attribute(const Look& look);

/// The attributes of a path beside its data.
struct Stroke {
  std::string classes;
  double width = 1;
  std::string_view dash;
  std::string extra{}; ///< more attributes, verbatim
};

class SvgWriter {
public:
  explicit SvgWriter(std::string& out) : out_(out) {}

  void raw(std::string_view text) { out_ += text; }
  void path(const PathData& data, const Stroke& stroke);
  void line(Point from, Point to, const Stroke& stroke);
  void rect(const Box& box, std::string_view classes);
  /// A picture, stretched to the box, as a data URI.
  void image(const Box& box, std::string_view type, std::string_view bytes);
  /// One line of text with its baseline at `at`.
  void text(Point at, std::string_view label, double size, Anchor anchor, std::string_view classes = "bp-ink",
            bool bold = false);
  /// What lies under a label fades there. A box: not all renderers paint the outline of a text before the text.
  void veil(const Box& box) { rect(box, "bp-bg bp-veil"); }
  /// Lines of text below each other; `top` is the upper edge of the first.
  void lines(Point top, const FittedText& text, Anchor anchor, std::string_view classes = "bp-ink");
  /// Lines of text turned to be read upward; `centre` is the middle of the block.
  void upward(Point centre, const FittedText& text);
  /// Defines a clipping region and opens a group that uses it.
  void open_clip(std::string_view id, const PathData& region);
  void close_group() { out_ += "</g>\n"; }
  /// `extra`: more attributes, verbatim.
  void open_group(std::string_view classes, std::string_view extra = {});

private:
  void attribute(std::string_view name, double value);

  std::string& out_;
};

} // namespace brdfplot::plot
