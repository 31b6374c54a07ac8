#include "sampling/radial_slopes.hpp"

#include "brdf/blocks/kernel_choice.hpp"
#include "microfacet/distributions/ggx.hpp"
#include "microfacet/visible_normals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

using Piece = PiecewiseDensity::Piece;

/// ln r from where on, and up to where, densities are looked at, and how closely. The frame's slopes are about 1.
constexpr double lowest = -40, highest = 230, step = 0.25;
constexpr int most_halvings = 10;

/// f of the component, at a norm of its frame.
std::function<double(double)> density_of(const Component& component) {
  return std::visit(
      [&](const auto& d) -> std::function<double(double)> {
        const double k = component.frame.alpha_x / d.slopes.alpha_x;
        if constexpr (requires { d.shape; }) {
          return [shape = d.shape, k](double r) { return k * k * shape.density(k * r * (k * r)); };
        } else if constexpr (requires { d.profile; }) {
          const double slope = component.frame.alpha_x;
          return
              [profile = d.profile, slope](double r) { return slope * slope * profile.p22(slope * r * (slope * r)); };
        } else {
          return {}; // a mixture is no component
        }
      },
      component.distribution);
}

std::function<double(double)> closed_within(const Component& component) {
  return std::visit(
      [&](const auto& d) -> std::function<double(double)> {
        if constexpr (requires { d.shape.slope_within(0.5); }) {
          const double k = component.frame.alpha_x / d.slopes.alpha_x;
          return [shape = d.shape, k](double u) { return shape.slope_within(u) / k; };
        } else if constexpr (requires { d.profile.slope_within(0.5); }) {
          return [profile = d.profile, slope = component.frame.alpha_x](double u) {
            return profile.slope_within(u) / slope;
          };
        } else {
          return {};
        }
      },
      component.distribution);
}

std::function<UnitSlope(double, double, double, double)> closed_visible_slope(const Component& component) {
  return std::visit(
      []<class D>(const D&) -> std::function<UnitSlope(double, double, double, double)> {
        if constexpr (requires { requires InvertsVisibleSlopes<typename D::UnitShape>; })
          return &D::UnitShape::visible_slope;
        else
          return {};
      },
      component.distribution);
}

template <class Function>
Piece piece_of(double from, double to, bool root, const Function& f) {
  Piece piece{from, to, root};
  for (std::size_t k = 0; k < PiecewiseDensity::nodes; ++k) piece.values[k] = f(piece.node(k));
  return piece;
}

/// Adds [from, to], in parts until their integrals agree with that of the whole.
template <class Function>
void add_pieces(const Function& f, const Piece& whole, double accepted, int halvings, std::vector<Piece>& all) {
  const double middle = 0.5 * (whole.from + whole.to);
  const Piece left = piece_of(whole.from, middle, false, f), right = piece_of(middle, whole.to, false, f);
  if (halvings == 0 || std::fabs(left.integral() + right.integral() - whole.integral()) <= accepted) {
    all.push_back(whole);
    return;
  }
  add_pieces(f, left, accepted, halvings - 1, all);
  add_pieces(f, right, accepted, halvings - 1, all);
}

/// Of f r^2 over ln r, closely enough for it and, with `seen`, for f r^3 too. Cut at `radii`.
std::vector<Piece> pieces_of(const std::function<double(double)>& density, const std::vector<double>& radii,
                             bool seen) {
  const auto ground = [&](double x) { return density(std::exp(x)) * std::exp(x) * std::exp(x); };
  const auto weighted = [&](double x) { return ground(x) * (seen ? 1 + std::exp(x) : 1); };
  std::vector<double> places, coarse;
  for (double x = lowest; x <= highest; x += step) places.push_back(x);
  for (const double r : radii) places.push_back(std::log(r));
  std::ranges::sort(places);
  for (const double x : places) coarse.push_back(weighted(x));
  double sum = 0;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) sum += (places[k + 1] - places[k]) * coarse[k];
  const double negligible = 1e-19 * sum;
  const auto counts = [&](double value) { return value > negligible; };
  const auto first = std::ranges::find_if(coarse, counts) - coarse.begin();
  const auto last = std::find_if(coarse.rbegin(), coarse.rend(), counts).base() - coarse.begin();
  std::vector<Piece> of_weighted, of_ground;
  for (auto k = std::max<std::ptrdiff_t>(first - 1, 0); k < last; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (at + 1 == places.size() || !(places[at] < places[at + 1])) continue;
    add_pieces(weighted, piece_of(places[at], places[at + 1], false, weighted), 1e-14 * sum, most_halvings,
               of_weighted);
  }
  for (const Piece& piece : of_weighted) of_ground.push_back(piece_of(piece.from, piece.to, false, ground));
  return of_ground;
}

/// Where c psi + k sin psi is a share v of what it is at the end: psi_0, where its derivative is 0, or pi.
double azimuth(double c, double k, double v) {
  const double end = k > c ? std::acos(-c / k) : std::numbers::pi;
  const double wanted = v * (c * end + k * std::sin(end));
  double low = 0, high = end, psi = v * end;
  for (int n = 0; n < 80 && high - low > 1e-15; ++n) {
    const double excess = c * psi + k * std::sin(psi) - wanted;
    (excess < 0 ? low : high) = psi;
    const double next = psi - excess / (c + k * std::cos(psi));
    const double before = psi;
    psi = next >= low && next <= high ? next : 0.5 * (low + high);
    if (std::fabs(psi - before) < 1e-15 * (1 + psi)) break;
  }
  return psi;
}

} // namespace

double visible_area(const Component& component, const Projection& in_frame) {
  double s = in_frame.s, area = 0;
  visible_areas(component, &in_frame.c, &s, &area, 1);
  return area;
}

void visible_areas(const Component& component, const double* c, double* s, double* areas, std::size_t n) {
  std::visit(
      [&](const auto& d) {
        if constexpr (requires { d.masked_areas(c, s, areas, n); }) {
          const double scale = d.slopes.alpha_x / component.frame.alpha_x;
          for (std::size_t k = 0; k < n; ++k) s[k] *= scale;
          d.masked_areas(c, s, areas, n);
          for (std::size_t k = 0; k < n; ++k) areas[k] += c[k];
        } else {
          std::fill_n(areas, n, 0.0); // a mixture is no component
        }
      },
      component.distribution);
}

RadialSlopes::RadialSlopes(const Component& component)
    : density_(density_of(component)), within_(closed_within(component)),
      visible_slope_(closed_visible_slope(component)), kernel_(density_kernel(component.distribution)) {
  const bool infinite = std::visit(
      [](const auto& d) {
        return requires { d.profile.infinite_mean_slope; };
      },
      component.distribution);
  if (infinite) visible_ = false;
  const bool tabulates = !within_ || (!visible_slope_ && visible_);
  if (!tabulates) return;
  pieces_ = pieces_of(density_, component.radii, visible_);
  for (const Piece& piece : pieces_) ground_.add(piece);
  if (!visible_ || visible_slope_) return;
  // Seen from the horizon slopes count by their size, and what is seen is known without the table.
  double seen = 0;
  for (Piece piece : pieces_) {
    for (std::size_t k = 0; k < PiecewiseDensity::nodes; ++k) piece.values[k] *= 2 * std::exp(piece.node(k));
    seen += piece.integral();
  }
  const double exact = visible_area(component, {0, 1});
  visible_ = std::fabs(seen - exact) <= 1e-8 * exact;
}

double RadialSlopes::within(double u) const { return within_ ? within_(u) : std::exp(ground_.inverse(u)); }

RadialSlopes::Viewer::Viewer(const RadialSlopes& slopes, double c, double s, bool on_disc)
    : c_(c), s_(s), closed_(on_disc ? &GgxShape::visible_slope_2018 : slopes.visible_slope_) {
  if (closed_) return;
  const double horizon = s > 0 ? std::log(c / s) : infinity;
  const auto seen = [=](double x) {
    const double k = s * std::exp(x);
    return k > c ? c * std::acos(-c / k) + std::sqrt((k - c) * (k + c)) : std::numbers::pi * c;
  };
  // The norm where facets start to turn away lies within a piece; it and the next are taken anew, cut there.
  for (std::size_t p = 0; p < slopes.pieces_.size(); ++p) {
    Piece piece = slopes.pieces_[p];
    const auto density = [&](double x) { return slopes.density_(std::exp(x)) * std::exp(x) * std::exp(x) * seen(x); };
    if (horizon > piece.from && horizon < piece.to) {
      const std::size_t next = std::min(p + 1, slopes.pieces_.size() - 1);
      norms_.add(piece_of(piece.from, horizon, false, density));
      norms_.add(piece_of(horizon, slopes.pieces_[next].to, true, density));
      p = next;
      continue;
    }
    for (std::size_t k = 0; k < PiecewiseDensity::nodes; ++k) piece.values[k] *= seen(piece.node(k));
    norms_.add(piece);
  }
}

UnitSlope RadialSlopes::Viewer::operator()(double u1, double u2) const {
  if (closed_) return closed_(c_, s_, u1, u2);
  const double r = std::exp(norms_.inverse(u1));
  const double psi = std::copysign(azimuth(c_, s_ * r, std::fabs(2 * u2 - 1)), u2 - 0.5);
  return {r * std::cos(psi), r * std::sin(psi)};
}

} // namespace brdfplot
