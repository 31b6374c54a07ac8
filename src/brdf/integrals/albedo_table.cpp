#include "brdf/integrals/albedo_table.hpp"

#include "math/chebyshev.hpp"
#include "math/gauss_kronrod.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace brdfplot {

namespace {

Direction direction_at(double mu, double cos_2_phi) {
  const double s = std::sqrt((1 - mu) * (1 + mu));
  return {s * std::sqrt(0.5 * (1 + cos_2_phi)), s * std::sqrt(0.5 * (1 - cos_2_phi)), mu};
}

double cos_2_phi(const Direction& omega) {
  const double x2 = omega.x * omega.x, y2 = omega.y * omega.y;
  return x2 + y2 > 0 ? (x2 - y2) / (x2 + y2) : 0;
}

} // namespace

AlbedoTable::AlbedoTable(std::size_t channels, bool isotropic, const Albedo& albedo, double tolerance,
                         const std::vector<double>& cuts)
    : channels_(channels), isotropic_(isotropic) {
  // Masking and shadowing change within an angle of the order of the roughness from grazing: the first cuts are there.
  const std::size_t azimuths = isotropic ? 1 : 6;
  std::vector<double> ends = {0, 0.5, 1};
  for (const double mu : cuts) ends.push_back(std::sqrt(mu));
  std::ranges::sort(ends);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    if (ends[k] < ends[k + 1]) add(ends[k], ends[k + 1], azimuths, albedo, tolerance);
  constexpr std::size_t turn = 32; // azimuths of the mean, where E is above 1 by its error no polynomial
  const std::size_t count = isotropic ? 1 : turn;
  for (const Piece& piece : pieces_) {
    const auto& rule = GaussKronrod<21>::rule();
    const double centre = 0.5 * (piece.from + piece.to), half = 0.5 * (piece.to - piece.from);
    for (std::size_t k = 0; k < rule.x.size(); ++k)
      for (std::size_t j = 0; j < count; ++j) {
        // mu = t^2: 2 mu dmu = 4 t^3 dt. The nodes of cos 2 phi are evenly spaced in phi.
        const double t = centre + half * rule.x[k];
        const double weight = rule.kronrod[k] * half * 4 * t * t * t / static_cast<double>(count);
        const Direction omega = direction_at(t * t, chebyshev_node(j, count));
        for (std::size_t c = 0; c < channels_; ++c) mean_loss_[c] += weight * loss(c, omega);
      }
  }
}

AlbedoTable::Piece AlbedoTable::sampled(double from, double to, std::size_t azimuths, const Albedo& albedo,
                                        double& worst) {
  Piece piece{from, to, {}};
  for (auto& coefficients : piece.of_channel) coefficients.resize(azimuths);
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t j = 0; j < azimuths; ++j) {
      const double t = 0.5 * (from + to) + 0.5 * (to - from) * chebyshev_node(k, nodes);
      const Direction omega = direction_at(t * t, chebyshev_node(j, azimuths));
      const ColourEstimate here = albedo(omega);
      for (std::size_t c = 0; c < channels_; ++c) {
        piece.of_channel[c][j][k] = here.value[c];
        worst = std::max(worst, here.error[c]);
        if (here.value[c] <= largest_) continue;
        largest_ = here.value[c];
        where_largest_ = omega;
      }
    }
  for (std::size_t c = 0; c < channels_; ++c) {
    for (auto& row : piece.of_channel[c]) to_chebyshev_coefficients(row.data(), nodes, 1);
    for (std::size_t k = 0; k < nodes; ++k) to_chebyshev_coefficients(&piece.of_channel[c][0][k], azimuths, nodes);
  }
  return piece;
}

namespace {

/// What a polynomial leaves out goes on as its last three coefficients fall: of rows in cos 2 phi, in sqrt(cos theta)
/// and in cos 2 phi.
struct Beyond {
  double t = 0, phi = 0;
};

template <class Rows>
Beyond beyond(const Rows& rows) {
  Beyond out;
  for (std::size_t j = 0; j < rows.size(); ++j)
    for (std::size_t k = 0; k < rows[j].size(); ++k) {
      if (k + 3 >= rows[j].size()) out.t += std::fabs(rows[j][k]);
      if (rows.size() > 1 && j + 3 >= rows.size()) out.phi += std::fabs(rows[j][k]);
    }
  return {4 * out.t, 4 * out.phi};
}

} // namespace

void AlbedoTable::add(double from, double to, std::size_t azimuths, const Albedo& albedo, double tolerance) {
  // Towards a root at the normal coefficients fall like 1 / k^2, and what is left out is as much more.
  const bool at_normal = isotropic_ && to == 1; // NOLINT(clang-diagnostic-float-equal)
  const double narrowest = at_normal ? 0x1p-40 : 0x1p-12;
  constexpr std::size_t most_azimuths = 64;
  const auto missed = [&](const Piece& piece) {
    Beyond worst;
    for (std::size_t c = 0; c < channels_; ++c) {
      const Beyond one = beyond(piece.of_channel[c]);
      worst = {std::max(worst.t, at_normal ? 4 * one.t : one.t), std::max(worst.phi, one.phi)};
    }
    return worst;
  };
  const auto halve = [&](std::size_t count) {
    add(from, 0.5 * (from + to), count, albedo, tolerance);
    add(0.5 * (from + to), to, count, albedo, tolerance);
  };
  const bool can_be_halved = to - from > narrowest;
  double error = 0;
  // Two azimuths tell most pieces that are too long.
  if (azimuths > 2 && can_be_halved && missed(sampled(from, to, 2, albedo, error)).t > tolerance)
    return halve(azimuths);
  Piece piece = sampled(from, to, azimuths, albedo, error);
  Beyond left = missed(piece);
  while (left.phi > tolerance && azimuths < most_azimuths) {
    azimuths *= 2;
    piece = sampled(from, to, azimuths, albedo, error);
    left = missed(piece);
  }
  if (left.t > tolerance && can_be_halved) return halve(azimuths);
  // Interpolation adds up the errors of the nodes, by no more than the Lebesgue constants of 16 and of 64 Chebyshev
  // nodes.
  const double lebesgue = azimuths > 1 ? 2.8 * 3.7 : 2.8;
  error_ = std::max(error_, left.t + left.phi + lebesgue * error);
  pieces_.push_back(std::move(piece));
}

const AlbedoTable::Piece& AlbedoTable::piece_at(double t) const {
  const auto above = std::ranges::upper_bound(pieces_, t, {}, &Piece::from);
  return above == pieces_.begin() ? *above : *(above - 1);
}

double AlbedoTable::albedo(std::size_t channel, const Direction& omega) const {
  const double t = std::sqrt(std::clamp(omega.z, 0.0, 1.0));
  const Piece& piece = piece_at(t);
  const double x = (2 * t - piece.from - piece.to) / (piece.to - piece.from);
  const auto& rows = piece.of_channel[channel];
  const auto row = [&](std::size_t j) { return chebyshev_sum(nodes, x, [&](std::size_t k) { return rows[j][k]; }); };
  return rows.size() == 1 ? row(0) : chebyshev_sum(rows.size(), cos_2_phi(omega), row);
}

double AlbedoTable::loss(std::size_t channel, const Direction& omega) const {
  return std::max(0.0, 1 - albedo(channel, omega));
}

} // namespace brdfplot
