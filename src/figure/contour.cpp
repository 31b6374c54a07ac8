#include "figure/contour.hpp"

#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace brdfplot::plot {

namespace {

/// An edge of the lattice: from node (column, row) to the right or upwards. Crossings are shared between cells by it.
struct Edge {
  std::size_t column, row;
  bool upwards;
  auto operator<=>(const Edge&) const = default;
};

using CellSegment = std::array<Edge, 2>;

class Lattice {
public:
  Lattice(const PlaneFunction& value, double level, const std::vector<double>& x, const std::vector<double>& y)
      : value_(value), level_(level), x_(x), y_(y) {
    std::vector<double> at_x, at_y;
    for (const double row : y)
      for (const double column : x) {
        at_x.push_back(column);
        at_y.push_back(row);
      }
    above_ = above(at_x, at_y);
  }

  std::vector<CellSegment> segments() const {
    std::vector<CellSegment> out;
    for (std::size_t row = 0; row + 1 < y_.size(); ++row)
      for (std::size_t column = 0; column + 1 < x_.size(); ++column) add_cell(column, row, out);
    return out;
  }

  /// Where the level is crossed on each of the edges.
  Contour::Line crossings(const std::vector<Edge>& edges) const {
    constexpr int halvings = 40;
    Contour::Line p, q, middle;
    for (const Edge& edge : edges) {
      p.x.push_back(x_[edge.column]);
      p.y.push_back(y_[edge.row]);
      q.x.push_back(x_[edge.column + (edge.upwards ? 0 : 1)]);
      q.y.push_back(y_[edge.row + (edge.upwards ? 1 : 0)]);
    }
    middle = p;
    for (int step = 0; step < halvings; ++step) {
      throw_if_interrupted();
      for (std::size_t k = 0; k < edges.size(); ++k) {
        middle.x[k] = 0.5 * (p.x[k] + q.x[k]);
        middle.y[k] = 0.5 * (p.y[k] + q.y[k]);
      }
      const std::vector<bool> high = above(middle.x, middle.y);
      for (std::size_t k = 0; k < edges.size(); ++k) {
        Contour::Line& side = high[k] == above_[edges[k].row * x_.size() + edges[k].column] ? p : q;
        side.x[k] = middle.x[k];
        side.y[k] = middle.y[k];
      }
    }
    return p;
  }

private:
  std::vector<bool> above(const std::vector<double>& x, const std::vector<double>& y) const {
    std::vector<bool> out;
    for (const double value : value_(x, y)) out.push_back(value >= level_);
    return out;
  }

  void add_cell(std::size_t column, std::size_t row, std::vector<CellSegment>& out) const {
    const auto at = [&](std::size_t c, std::size_t r) { return above_[(row + r) * x_.size() + column + c]; };
    const Edge bottom{column, row, false}, top{column, row + 1, false}, left{column, row, true},
        right{column + 1, row, true};
    std::vector<Edge> cut;
    if (at(0, 0) != at(1, 0)) cut.push_back(bottom);
    if (at(1, 0) != at(1, 1)) cut.push_back(right);
    if (at(0, 1) != at(1, 1)) cut.push_back(top);
    if (at(0, 0) != at(0, 1)) cut.push_back(left);
    // Two opposite corners: cut both off, each by itself.
    for (std::size_t k = 0; k + 1 < cut.size(); k += 2) out.push_back({cut[k], cut[k + 1]});
  }

  const PlaneFunction& value_;
  double level_;
  const std::vector<double>&x_, &y_;
  std::vector<bool> above_;
};

/// Takes from `segments` those that lead on from `edge`, in order.
std::vector<Edge> follow(Edge edge, std::multimap<Edge, std::size_t>& ends, const std::vector<CellSegment>& segments,
                         std::vector<bool>& used) {
  std::vector<Edge> chain;
  for (;;) {
    const auto [first, last] = ends.equal_range(edge);
    const auto next = std::find_if(first, last, [&](const auto& entry) { return !used[entry.second]; });
    if (next == last) return chain;
    const CellSegment& segment = segments[next->second];
    used[next->second] = true;
    edge = segment[0] == edge ? segment[1] : segment[0];
    chain.push_back(edge);
  }
}

} // namespace

std::vector<Contour::Line> level_lines(const PlaneFunction& value, double level, const std::vector<double>& x,
                                       const std::vector<double>& y) {
  const Lattice lattice(value, level, x, y);
  const std::vector<CellSegment> segments = lattice.segments();
  std::multimap<Edge, std::size_t> ends;
  for (std::size_t k = 0; k < segments.size(); ++k)
    for (const Edge& edge : segments[k]) ends.emplace(edge, k);
  std::vector<bool> used(segments.size(), false);
  std::vector<Edge> edges; // of all lines, one after the other
  std::vector<std::size_t> lengths;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (used[k]) continue;
    throw_if_interrupted();
    used[k] = true;
    std::vector<Edge> chain = follow(segments[k][0], ends, segments, used);
    std::ranges::reverse(chain);
    chain.push_back(segments[k][0]);
    chain.push_back(segments[k][1]);
    for (const Edge& edge : follow(segments[k][1], ends, segments, used)) chain.push_back(edge);
    edges.insert(edges.end(), chain.begin(), chain.end());
    lengths.push_back(chain.size());
  }
  const Contour::Line points = lattice.crossings(edges);
  std::vector<Contour::Line> lines;
  std::ptrdiff_t first = 0;
  for (const std::size_t length : lengths) {
    const std::ptrdiff_t last = first + static_cast<std::ptrdiff_t>(length);
    lines.push_back(
        {{points.x.begin() + first, points.x.begin() + last}, {points.y.begin() + first, points.y.begin() + last}});
    first = last;
  }
  return lines;
}

} // namespace brdfplot::plot
