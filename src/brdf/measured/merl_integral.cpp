#include "brdf/measured/merl_integral.hpp"

#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace brdfplot {

namespace {

using std::numbers::pi;

/// Gauss's rule of four points on [-1, 1].
constexpr std::array<double, 4> nodes = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                         0.8611363115940526};
constexpr std::array<double, 4> weights = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                           0.3478548451374538};
/// As far as four points follow w and a polynomial of the second degree in cos phi to 1e-13.
constexpr double longest_piece = 0.2;

/// The circle of half vectors at one theta_h, by their azimuth phi from that of the viewer. The other half of it is its
/// mirror image.
class HalfCircle {
public:
  HalfCircle(const MerlGrid& grid, double theta_o, double theta_h)
      : grid_(grid), cos_o_(std::cos(theta_o)), sin_o_(std::sin(theta_o)), cos_h_(std::cos(theta_h)),
        sin_h_(std::sin(theta_h)), a_(cos_o_ * cos_h_), b_(sin_o_ * sin_h_) {
    // z of the light, 2 (o.h) cos theta_h - cos theta_o, is that of a falling function of phi.
    const double least = 0.5 * cos_o_ / cos_h_;
    end_ = b_ > 0 ? std::acos(std::clamp((least - a_) / b_, -1.0, 1.0)) : a_ > least ? pi : 0;
  }

  /// Azimuths in [0, pi], in order, between which all half vectors lie in one cell.
  std::vector<double> edges() const {
    std::vector<double> all = {0, end_};
    const auto add = [&](double phi) {
      if (phi > 0 && phi < end_) all.push_back(phi);
    };
    for (std::size_t k = 1; k < grid_.theta_d && b_ > 0; ++k) {
      const double c = (std::cos(grid_.theta_d_at(static_cast<double>(k))) - a_) / b_;
      if (std::fabs(c) < 1) add(std::acos(c));
    }
    // The angle psi at h of the triangle of h, normal and viewer: by the four-part formula
    // sin theta_o (cos psi sin phi + sin psi cos theta_h cos phi) = sin psi sin theta_h cos theta_o.
    for (std::size_t k = 1; k < grid_.phi_d && b_ > 0; ++k) {
      const double psi = grid_.phi_d_at(static_cast<double>(k));
      const double p = sin_o_ * std::cos(psi), q = sin_o_ * std::sin(psi) * cos_h_;
      const double c = std::sin(psi) * sin_h_ * cos_o_ / std::hypot(p, q);
      if (!(std::fabs(c) < 1)) continue;
      add(std::atan2(p, q) + std::acos(c));
      add(std::atan2(p, q) - std::acos(c));
    }
    std::ranges::sort(all);
    return all;
  }

  struct Angles {
    double theta_d, psi;
  };
  Angles at(double phi) const {
    // sin theta_d times sine and cosine of psi.
    const double across = sin_o_ * std::sin(phi), along = sin_h_ * cos_o_ - cos_h_ * sin_o_ * std::cos(phi);
    return {std::atan2(std::hypot(across, along), facing(std::cos(phi))), std::atan2(across, along)};
  }
  double facing(double cos_phi) const { return a_ + b_ * cos_phi; } ///< o.h

  double sin_h() const { return sin_h_; }
  double cos_h() const { return cos_h_; }

private:
  const MerlGrid& grid_;
  double cos_o_, sin_o_, cos_h_, sin_h_, a_, b_, end_ = 0;
};

class MerlIntegrand {
public:
  MerlIntegrand(const MerlTable& table, const Direction& o, const std::function<double(const Direction&)>& weight)
      : table_(table), o_(o), theta_o_(std::atan2(std::hypot(o.x, o.y), o.z)), weight_(weight) {
    const double across = std::hypot(o.x, o.y);
    if (across > 0) cos_azimuth_ = o.x / across, sin_azimuth_ = o.y / across;
  }

  double theta_o() const { return theta_o_; }

  /// The integral over the circle of theta_h, in three channels.
  const std::array<double, 3>& operator()(double theta_h) {
    const auto [place, is_new] = known_.try_emplace(theta_h);
    if (is_new) place->second = over_circle(theta_h);
    return place->second;
  }
  std::size_t circles() const { return known_.size(); }

private:
  std::array<double, 3> over_circle(double theta_h) const {
    throw_if_interrupted();
    const MerlGrid& grid = table_.grid();
    const std::size_t row =
        grid.cell_of({.theta_h = theta_h, .phi_h = 0, .theta_d = 0, .phi_d = 0}) / grid.phi_d / grid.theta_d;
    const HalfCircle circle(grid, theta_o_, theta_h);
    const std::vector<double> edges = circle.edges();
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
      if (!(edges[k + 1] > edges[k])) continue;
      const auto middle = circle.at(0.5 * (edges[k] + edges[k + 1]));
      const std::size_t d = grid.index_of_theta_d(middle.theta_d);
      // The light is across h from the viewer: at -psi from the viewer's side of the plane, at psi on the other.
      const std::array<std::size_t, 2> cells = {grid.index(row, d, grid.index_of_phi_d(-middle.psi)),
                                                grid.index(row, d, grid.index_of_phi_d(middle.psi))};
      const std::array<double, 2> light = over_piece(circle, edges[k], edges[k + 1]);
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t side = 0; side < 2; ++side) sum[c] += table_.value(c, cells[side]) * light[side];
    }
    return sum;
  }

  /// int 4 (o.h) c_i w sin theta_h dphi over the piece and over its mirror image: d omega_i = 4 (o.h) d omega_h.
  std::array<double, 2> over_piece(const HalfCircle& circle, double from, double to) const {
    std::array<double, 2> sum{};
    const int count = static_cast<int>(std::ceil((to - from) / longest_piece));
    const double half = 0.5 * (to - from) / count;
    for (int part = 0; part < count; ++part) {
      const double middle = from + (2 * part + 1) * half;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        const double phi = middle + half * nodes[n];
        const double c = std::cos(phi), s = std::sin(phi);
        const double facing = circle.facing(c);
        for (std::size_t side = 0; side < 2; ++side) {
          const Direction i = reflected(o_, direction(circle, c, side == 0 ? s : -s));
          if (i.z > 0) sum[side] += half * weights[n] * 4 * facing * i.z * circle.sin_h() * weight_(i);
        }
      }
    }
    return sum;
  }

  /// The half vector at an azimuth from the viewer's.
  Direction direction(const HalfCircle& circle, double c, double s) const {
    return {circle.sin_h() * (c * cos_azimuth_ - s * sin_azimuth_),
            circle.sin_h() * (s * cos_azimuth_ + c * sin_azimuth_), circle.cos_h()};
  }

  const MerlTable& table_;
  Direction o_;
  double theta_o_, cos_azimuth_ = 1, sin_azimuth_ = 0;
  const std::function<double(const Direction&)>& weight_;
  std::map<double, std::array<double, 3>> known_;
};

/// Where the integral over theta_h is not smooth, as far as that is known: the edges of the cells, and where circles of
/// theta_h begin to reach below the horizon and cease to reach above it.
std::vector<double> cuts(const MerlGrid& grid, double theta_o) {
  const double last = 0.5 * (theta_o + 0.5 * pi);
  std::vector<double> all = {0.5 * (0.5 * pi - theta_o), last};
  for (std::size_t k = 0; k < grid.theta_h; ++k) all.push_back(grid.theta_h_at(static_cast<double>(k)));
  std::erase_if(all, [&](double angle) { return angle > last; });
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

} // namespace

ColourEstimate integrate_merl(const MerlTable& table, const Direction& omega_o, double tolerance,
                              const ChannelRange& channels,
                              const std::function<double(const Direction& omega_i)>& weight) {
  constexpr std::size_t most_circles = 30000;
  MerlIntegrand integrand(table, omega_o, weight);
  const std::vector<double> points = cuts(table.grid(), integrand.theta_o());
  ColourEstimate out;
  for (std::size_t c = 0; c < channels.count; ++c) {
    const BatchFunction f = [&](const double* x, double* y, std::size_t n) {
      for (std::size_t k = 0; k < n; ++k) y[k] = integrand(x[k])[channels.first + c];
    };
    const Estimate one = integrate(f, points, {.absolute = tolerance}, most_circles);
    out.value[c] = one.value;
    out.error[c] = one.error;
  }
  out.evaluations = integrand.circles();
  return out;
}

} // namespace brdfplot
