#include "choice/advise/images/places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::choice {

namespace {

using std::numbers::pi;

/// The largest cell (rad of the normal), and how a cell may grow with its distance from a mirroring normal.
constexpr double coarsest = 0.11, growth = 0.35;
/// Of the least roughness: the smallest cells; and the smallest of all.
constexpr double finest_of_alpha = 0.5, finest_of_all = 0.002;

/// A part of the sphere's picture: angles of the normal from the viewer, and azimuths.
struct Cell {
  double theta0, theta1, phi0, phi1;

  double height() const { return theta1 - theta0; }
  double width() const { return std::sin(0.5 * (theta0 + theta1)) * (phi1 - phi0); }
  /// r dr dphi of r = sin theta.
  double area() const { return 0.5 * (phi1 - phi0) * std::sin(theta1 - theta0) * std::sin(theta1 + theta0); }
  /// The normal whose circle halves the area.
  double middle() const {
    return std::asin(std::sqrt(0.5 * (std::pow(std::sin(theta0), 2) + std::pow(std::sin(theta1), 2))));
  }
};

/// A normal that mirrors the middle of a light to the viewer, and about what angle its disc is mirrored.
struct Mirror {
  Direction normal;
  double radius;
};

class Subdivision {
public:
  Subdivision(const std::vector<AdviceLight>& lights, const Fineness& f)
      : coarsest_(coarsest / f.scale), growth_(growth / f.scale),
        finest_(std::max(finest_of_alpha * f.least_alpha, finest_of_all) / f.scale),
        near_(f.largest_alpha > 2 * f.least_alpha ? std::min(f.largest_alpha, 0.5) : 0) {
    for (const AdviceLight& light : lights)
      mirrors_.push_back({from_angles(light.theta / 2, light.phi), light.radius / 2});
  }

  void add(const Cell& cell, Places& out) const {
    const double theta = cell.middle(), phi = 0.5 * (cell.phi0 + cell.phi1);
    const double most = largest_at(from_angles(theta, phi));
    const bool tall = cell.height() > most, wide = cell.width() > most;
    if (!tall && !wide) {
      out.at.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi)});
      out.share.push_back(cell.area());
    } else if (cell.height() >= cell.width() || !wide) {
      add({cell.theta0, 0.5 * (cell.theta0 + cell.theta1), cell.phi0, cell.phi1}, out);
      add({0.5 * (cell.theta0 + cell.theta1), cell.theta1, cell.phi0, cell.phi1}, out);
    } else {
      add({cell.theta0, cell.theta1, cell.phi0, phi}, out);
      add({cell.theta0, cell.theta1, phi, cell.phi1}, out);
    }
  }

private:
  double largest_at(const Direction& normal) const {
    double most = coarsest_;
    for (const Mirror& mirror : mirrors_) {
      const double away = std::acos(std::clamp(dot(normal, mirror.normal), -1.0, 1.0)) - mirror.radius - near_;
      most = std::min(most, std::max(finest_, growth_ * away));
    }
    return most;
  }

  double coarsest_, growth_, finest_, near_;
  std::vector<Mirror> mirrors_;
};

} // namespace

Places places_on_sphere(const ViewRange& view, const std::vector<AdviceLight>& lights, const Fineness& fineness) {
  const Subdivision subdivision(lights, fineness);
  Places out;
  double sum = 0;
  for (std::size_t bin = 0; bin + 1 < view.edges.size(); ++bin) {
    const std::size_t first = out.at.size();
    constexpr int sectors = 8;
    for (int k = 0; k < sectors; ++k)
      subdivision.add({view.edges[bin], view.edges[bin + 1], 2 * pi * k / sectors, 2 * pi * (k + 1) / sectors}, out);
    double area = 0;
    for (std::size_t k = first; k < out.share.size(); ++k) area += out.share[k];
    const double factor = view.shares.empty() ? 1 : view.shares[bin] / area;
    for (std::size_t k = first; k < out.share.size(); ++k) sum += out.share[k] *= factor;
  }
  for (double& share : out.share) share /= sum;
  return out;
}

} // namespace brdfplot::choice
