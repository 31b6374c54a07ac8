#include "plot/contour.hpp"

#include "math/interrupt.hpp"

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

using Segment = std::array<Edge, 2>;

class Lattice {
public:
  Lattice(const std::function<double(double, double)>& value, double level, const std::vector<double>& x,
          const std::vector<double>& y)
      : value_(value), level_(level), x_(x), y_(y), above_(x.size() * y.size()) {
    for (std::size_t row = 0; row < y.size(); ++row)
      for (std::size_t column = 0; column < x.size(); ++column)
        above_[row * x.size() + column] = value(x[column], y[row]) >= level;
  }

  std::vector<Segment> segments() const {
    std::vector<Segment> out;
    for (std::size_t row = 0; row + 1 < y_.size(); ++row)
      for (std::size_t column = 0; column + 1 < x_.size(); ++column) add_cell(column, row, out);
    return out;
  }

  std::array<double, 2> crossing(const Edge& edge) const {
    std::array<double, 2> p = {x_[edge.column], y_[edge.row]};
    std::array<double, 2> q = {x_[edge.column + (edge.upwards ? 0 : 1)], y_[edge.row + (edge.upwards ? 1 : 0)]};
    const bool above = above_[edge.row * x_.size() + edge.column];
    for (int k = 0; k < 40; ++k) {
      const std::array<double, 2> middle = {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
      ((value_(middle[0], middle[1]) >= level_) == above ? p : q) = middle;
    }
    return p;
  }

private:
  void add_cell(std::size_t column, std::size_t row, std::vector<Segment>& out) const {
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

  const std::function<double(double, double)>& value_;
  double level_;
  const std::vector<double>&x_, &y_;
  std::vector<bool> above_;
};

/// Takes from `segments` those that lead on from `edge`, in order.
std::vector<Edge> follow(Edge edge, std::multimap<Edge, std::size_t>& ends, const std::vector<Segment>& segments,
                         std::vector<bool>& used) {
  std::vector<Edge> chain;
  for (;;) {
    const auto [first, last] = ends.equal_range(edge);
    const auto next = std::find_if(first, last, [&](const auto& entry) { return !used[entry.second]; });
    if (next == last) return chain;
    const Segment& segment = segments[next->second];
    used[next->second] = true;
    edge = segment[0] == edge ? segment[1] : segment[0];
    chain.push_back(edge);
  }
}

} // namespace

std::vector<Contour::Line> level_lines(const std::function<double(double, double)>& value, double level,
                                       const std::vector<double>& x, const std::vector<double>& y) {
  const Lattice lattice(value, level, x, y);
  const std::vector<Segment> segments = lattice.segments();
  std::multimap<Edge, std::size_t> ends;
  for (std::size_t k = 0; k < segments.size(); ++k)
    for (const Edge& edge : segments[k]) ends.emplace(edge, k);
  std::vector<bool> used(segments.size(), false);
  std::vector<Contour::Line> lines;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (used[k]) continue;
    throw_if_interrupted();
    used[k] = true;
    std::vector<Edge> chain = follow(segments[k][0], ends, segments, used);
    std::ranges::reverse(chain);
    chain.push_back(segments[k][0]);
    chain.push_back(segments[k][1]);
    for (const Edge& edge : follow(segments[k][1], ends, segments, used)) chain.push_back(edge);
    Contour::Line line;
    for (const Edge& edge : chain) {
      const auto p = lattice.crossing(edge);
      line.x.push_back(p[0]);
      line.y.push_back(p[1]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

} // namespace brdfplot::plot
