#include "brdf/measured/merl_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

using std::numbers::pi;

/// The cell of a coordinate in [0, count], whose end belongs to the last one.
std::size_t cell(double coordinate, std::size_t count) {
  return std::min(static_cast<std::size_t>(std::max(coordinate, 0.0)), count - 1);
}

} // namespace

std::size_t MerlGrid::index_of_theta_d(double angle) const {
  return cell(angle / (0.5 * pi) * static_cast<double>(theta_d), theta_d);
}

std::size_t MerlGrid::index_of_phi_d(double angle) const {
  double half_turn = angle < 0 ? angle + pi : angle;
  if (half_turn >= pi) half_turn = 0; // the other direction of the plane of incidence
  return cell(half_turn / pi * static_cast<double>(phi_d), phi_d);
}

std::size_t MerlGrid::cell_of(const HalfDifference& at) const {
  const std::size_t h = cell(std::sqrt(std::max(at.theta_h, 0.0) / (0.5 * pi)) * static_cast<double>(theta_h), theta_h);
  return index(h, index_of_theta_d(at.theta_d), index_of_phi_d(at.phi_d));
}

double MerlGrid::theta_h_at(double h) const {
  const double root = h / static_cast<double>(theta_h);
  return root * root * 0.5 * pi;
}

double MerlGrid::theta_d_at(double d) const { return d / static_cast<double>(theta_d) * 0.5 * pi; }

double MerlGrid::phi_d_at(double p) const { return p / static_cast<double>(phi_d) * pi; }

MerlCell::MerlCell(const MerlGrid& grid, std::size_t index)
    : h(index / grid.phi_d / grid.theta_d), d(index / grid.phi_d % grid.theta_d), p(index % grid.phi_d), grid_(grid) {}

HalfDifference MerlCell::at(double t) const {
  const auto low = [t](std::size_t k) { return static_cast<double>(k) + 0.5 * t; };
  // |cos phi_d| grows away from pi/2, which may be within the cell.
  const double left = static_cast<double>(p), middle = 0.5 * static_cast<double>(grid_.phi_d);
  const double nearest = std::clamp(middle, left, left + 1), centre = left + 0.5;
  const double farthest = centre < middle ? left : left + 1;
  const double phi = t <= 1 ? nearest + t * (centre - nearest) : centre + (t - 1) * (farthest - centre);
  return {grid_.theta_h_at(low(h)), 0, grid_.theta_d_at(low(d)), grid_.phi_d_at(phi)};
}

double MerlCell::cosine(double t) const {
  const HalfDifference here = at(t);
  return std::cos(here.theta_h) * std::cos(here.theta_d) -
         std::sin(here.theta_h) * std::sin(here.theta_d) * std::fabs(std::cos(here.phi_d));
}

HalfDifference MerlCell::sample() const {
  if (cosine(1) > horizon) return at(1);
  double above = 0, below = 1;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (above + below);
    (cosine(middle) > horizon ? above : below) = middle;
  }
  return at(0.5 * above);
}

} // namespace brdfplot
