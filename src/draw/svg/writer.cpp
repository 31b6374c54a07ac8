#include "draw/svg/writer.hpp"

#include <algorithm>
#include <cmath>

#include "draw/base64.hpp"
#include "draw/number_text.hpp"

namespace brdfplot::plot {

namespace {

long long hundredths(double value) { return std::llround(100 * std::clamp(value, -1e6, 1e6)); }

/// How far `p` lies from the segment between `a` and `b`.
double distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Marks the points that Douglas and Peucker's simplification keeps.
void keep_corners(const std::vector<Point>& points, std::vector<char>& keep) {
  constexpr double tolerance = 0.04; // invisible in print at column width
  std::vector<std::pair<std::size_t, std::size_t>> todo = {{0, points.size() - 1}};
  while (!todo.empty()) {
    const auto [first, last] = todo.back();
    todo.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance(points[i], points[first], points[last]);
      if (d > most) {
        most = d;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    keep[farthest] = 1;
    todo.emplace_back(first, farthest);
    todo.emplace_back(farthest, last);
  }
}

std::string_view anchor_name(Anchor anchor) {
  return anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
}

} // namespace

void PathData::pair(long long x, long long y) {
  append_hundredths(data_, x);
  if (y >= 0) data_ += ' ';
  append_hundredths(data_, y);
}

void PathData::move(Point to) {
  x_ = hundredths(to.x);
  y_ = hundredths(to.y);
  data_ += 'M';
  pair(x_, y_);
  command_ = 'M';
}

void PathData::line(Point to) {
  const auto x = hundredths(to.x);
  const auto y = hundredths(to.y);
  if (command_ != 'l') {
    data_ += 'l';
  } else if (x >= x_) {
    data_ += ' ';
  }
  pair(x - x_, y - y_);
  command_ = 'l';
  x_ = x;
  y_ = y;
}

void PathData::dot(Point at, double radius) {
  move({at.x - radius, at.y});
  arc(radius, true, true, {at.x + radius, at.y});
  arc(radius, true, true, {at.x - radius, at.y});
  close();
}

void PathData::rectangle(const Box& box) {
  move({box.x, box.y});
  data_ += 'H';
  append_hundredths(data_, hundredths(box.right()));
  data_ += 'V';
  append_hundredths(data_, hundredths(box.bottom()));
  data_ += 'H';
  append_hundredths(data_, hundredths(box.x));
  close();
}

void PathData::arc(double radius, bool large, bool sweep, Point to) {
  data_ += 'A';
  pair(hundredths(radius), hundredths(radius));
  data_ += large ? " 0 1" : " 0 0";
  data_ += sweep ? " 1 " : " 0 ";
  x_ = hundredths(to.x);
  y_ = hundredths(to.y);
  pair(x_, y_);
  command_ = 'A';
}

void append_polyline(PathData& path, const std::vector<Point>& points) {
  if (points.empty()) return;
  std::vector<char> keep(points.size(), 0);
  keep.front() = keep.back() = 1;
  keep_corners(points, keep);
  path.move(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (keep[i] != 0) path.line(points[i]);
  }
}

void SvgWriter::attribute(std::string_view name, double value) {
  out_.append(" ").append(name).append("=\"");
  append_fixed(out_, value);
  out_ += '"';
}

void SvgWriter::path(const PathData& data, const Stroke& stroke) {
  if (data.empty()) return;
  out_.append("<path class=\"").append(stroke.classes).append("\"");
  if (stroke.width > 0) attribute("stroke-width", stroke.width);
  if (!stroke.dash.empty()) out_.append(" stroke-dasharray=\"").append(stroke.dash).append("\"");
  out_ += stroke.extra;
  out_.append(" d=\"").append(data.text()).append("\"/>\n");
}

void SvgWriter::line(Point from, Point to, const Stroke& stroke) {
  PathData data;
  data.move(from);
  data.line(to);
  path(data, stroke);
}

void SvgWriter::rect(const Box& box, std::string_view classes) {
  out_.append("<rect class=\"").append(classes).append("\"");
  attribute("x", box.x);
  attribute("y", box.y);
  attribute("width", box.w);
  attribute("height", box.h);
  out_ += "/>\n";
}

void SvgWriter::image(const Box& box, std::string_view type, std::string_view bytes) {
  out_ += "<image";
  attribute("x", box.x);
  attribute("y", box.y);
  attribute("width", box.w);
  attribute("height", box.h);
  out_.append(" href=\"data:").append(type).append(";base64,");
  append_base64(out_, bytes);
  out_ += "\"/>\n";
}

void SvgWriter::text(Point at, std::string_view label, double size, Anchor anchor, std::string_view classes,
                     bool bold) {
  if (label.empty()) return;
  // CairoSVG anchors each part of a text by itself: one with parts begins where it has to.
  const bool parts = parse_markup(label).size() > 1;
  if (parts && anchor != Anchor::start) {
    at.x -= (anchor == Anchor::middle ? 0.5 : 1.0) * text_width(label, size, bold);
    anchor = Anchor::start;
  }
  out_.append("<text class=\"").append(classes).append("\"");
  attribute("x", at.x);
  attribute("y", at.y);
  attribute("font-size", size);
  if (anchor != Anchor::start) out_.append(" text-anchor=\"").append(anchor_name(anchor)).append("\"");
  if (bold) out_ += " font-weight=\"bold\"";
  // Some renderers drop a blank after a subscript otherwise.
  if (label.find_first_of("_^") != std::string_view::npos) out_ += " xml:space=\"preserve\"";
  out_ += '>';
  append_tspans(out_, label, size);
  out_ += "</text>\n";
}

void SvgWriter::lines(Point top, const FittedText& text, Anchor anchor, std::string_view classes) {
  double y = top.y + text.size;
  for (const auto& line : text.lines) {
    this->text({top.x, y}, line, text.size, anchor, classes, text.bold);
    y += text.line_height();
  }
}

void SvgWriter::upward(Point centre, const FittedText& text) {
  if (text.lines.empty()) return;
  out_ += "<g transform=\"translate(";
  append_fixed(out_, centre.x);
  out_ += ' ';
  append_fixed(out_, centre.y);
  out_ += ") rotate(-90)\">\n";
  lines({0, -text.height() / 2}, text, Anchor::middle);
  close_group();
}

void SvgWriter::open_clip(std::string_view id, const PathData& region) {
  out_.append("<clipPath id=\"").append(id).append("\"><path d=\"").append(region.text()).append("\"/></clipPath>\n");
  out_.append("<g clip-path=\"url(#").append(id).append(")\">\n");
}

void SvgWriter::open_group(std::string_view classes, std::string_view extra) {
  out_.append("<g class=\"").append(classes).append("\"").append(extra).append(">\n");
}

std::string key_attribute(const Look& look) {
  return " data-key=\"" + look.colour + "." + std::to_string(look.dash) + "\"";
}

} // namespace brdfplot::plot
