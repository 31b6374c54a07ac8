#include "brdf/albedo_table.hpp"

#include "math/gauss_kronrod.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

/// sum of c_k T_k(x) by Clenshaw's recurrence.
template <std::size_t N>
double chebyshev_sum(const std::array<double, N>& c, double x) {
  double one = 0, two = 0;
  for (std::size_t k = N - 1; k > 0; --k) {
    const double next = 2 * x * one - two + c[k];
    two = one;
    one = next;
  }
  return x * one - two + c[0];
}

/// The coefficients of the polynomial through values at the Chebyshev nodes cos(pi (k + 1/2) / N).
template <std::size_t N>
std::array<double, N> chebyshev_coefficients(const std::array<double, N>& values) {
  std::array<double, N> c{};
  for (std::size_t j = 0; j < N; ++j) {
    for (std::size_t k = 0; k < N; ++k)
      c[j] += values[k] * std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(k) + 0.5) / N);
    c[j] *= (j == 0 ? 1.0 : 2.0) / N;
  }
  return c;
}

} // namespace

AlbedoTable::AlbedoTable(std::size_t channels, const Albedo& albedo, double tolerance) : channels_(channels) {
  // Masking and shadowing change within an angle of the order of the roughness from grazing: the first cuts are there.
  add(0, 0.5, albedo, tolerance);
  add(0.5, 1, albedo, tolerance);
  for (std::size_t c = 0; c < channels_; ++c)
    for (const Piece& piece : pieces_) {
      const auto& rule = GaussKronrod<21>::rule();
      const double centre = 0.5 * (piece.from + piece.to), half = 0.5 * (piece.to - piece.from);
      for (std::size_t k = 0; k < rule.x.size(); ++k) {
        // mu = t^2: 2 mu dmu = 4 t^3 dt.
        const double t = centre + half * rule.x[k];
        mean_loss_[c] += rule.kronrod[k] * half * 4 * t * t * t * loss(c, t * t);
      }
    }
}

void AlbedoTable::add(double from, double to, const Albedo& albedo, double tolerance) {
  constexpr double narrowest = 0x1p-12;
  std::array<std::array<double, nodes>, 3> values{};
  double worst = 0;
  for (std::size_t k = 0; k < nodes; ++k) {
    const double x = std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / nodes);
    const double t = 0.5 * (from + to) + 0.5 * (to - from) * x;
    const ColourEstimate here = albedo(t * t);
    for (std::size_t c = 0; c < channels_; ++c) {
      values[c][k] = here.value[c];
      worst = std::max(worst, here.error[c]);
      if (here.value[c] <= largest_) continue;
      largest_ = here.value[c];
      mu_of_largest_ = t * t;
    }
  }
  Piece piece{from, to, {}};
  double missed = 0;
  for (std::size_t c = 0; c < channels_; ++c) {
    piece.of_channel[c] = chebyshev_coefficients(values[c]);
    // What the polynomial leaves out goes on as its last coefficients fall.
    for (std::size_t k = nodes - 3; k < nodes; ++k) missed = std::max(missed, 4 * std::fabs(piece.of_channel[c][k]));
  }
  if (missed > tolerance && to - from > narrowest) {
    add(from, 0.5 * (from + to), albedo, tolerance);
    add(0.5 * (from + to), to, albedo, tolerance);
    return;
  }
  // Interpolation adds up the errors of the nodes, by no more than the Lebesgue constant of 16 Chebyshev nodes.
  constexpr double lebesgue = 2.8;
  error_ = std::max(error_, missed + lebesgue * worst);
  pieces_.push_back(piece);
}

const AlbedoTable::Piece& AlbedoTable::piece_at(double t) const {
  const auto above = std::ranges::upper_bound(pieces_, t, {}, &Piece::from);
  return above == pieces_.begin() ? *above : *(above - 1);
}

double AlbedoTable::albedo(std::size_t channel, double mu) const {
  const double t = std::sqrt(std::clamp(mu, 0.0, 1.0));
  const Piece& piece = piece_at(t);
  const double x = (2 * t - piece.from - piece.to) / (piece.to - piece.from);
  return chebyshev_sum(piece.of_channel[channel], x);
}

double AlbedoTable::loss(std::size_t channel, double mu) const { return std::max(0.0, 1 - albedo(channel, mu)); }

} // namespace brdfplot
