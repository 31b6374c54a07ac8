#include "figure/series/compare.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>

namespace brdfplot::plot {

namespace {

using simulation::Estimates;
using simulation::Measured;

/// The lobe's means over the bins: middle points of a grid along the plane of incidence and across it.
std::vector<double> binned(const Term& lobe, const SimulatedTerm& simulated, const std::vector<double>& theta_i,
                           double tolerance) {
  constexpr int along = 8, across = 8;
  constexpr std::size_t all = std::size_t{along} * across;
  const TermFunction function(lobe, {"theta_i", "phi_i"}, tolerance);
  const double phi_o = function.fixed().angle("phi_o").value_or(0);
  const double width = theta_i[1] - theta_i[0];
  const double sin_half_width = std::sin(simulated.simulate().half_width);
  SweptColumns at(2);
  for (const double theta : theta_i)
    for (int k = 0; k < along; ++k)
      for (int l = 0; l < across; ++l) {
        const double a = theta + width * ((k + 0.5) / along - 0.5);
        const double b = std::asin(sin_half_width * (2 * (l + 0.5) / across - 1));
        const Direction i{std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a)};
        at[0].push_back(std::atan2(std::hypot(i.x, i.y), i.z));
        at[1].push_back(phi_o + std::atan2(i.y, i.x));
      }
  const std::vector<double> values = function(at);
  std::vector<double> out(theta_i.size(), 0);
  for (std::size_t k = 0; k < values.size(); ++k) out[k / all] += values[k] / all;
  return out;
}

/// A statistic of the mean of all estimates, with its standard error by the jackknife.
Measured jackknife(const Estimates& estimates, const std::function<double(const std::vector<double>&)>& statistic) {
  const std::size_t n = estimates.points, count = estimates.count();
  const auto mean_without = [&](std::size_t left_out) {
    std::vector<double> mean(n, 0);
    const auto weight = static_cast<double>(left_out < count ? count - 1 : count);
    for (std::size_t e = 0; e < count; ++e)
      for (std::size_t k = 0; k < n; ++k)
        if (e != left_out) mean[k] += estimates.values[e * n + k] / weight;
    return mean;
  };
  std::vector<double> without;
  for (std::size_t e = 0; e < count; ++e) without.push_back(statistic(mean_without(e)));
  const double spread = simulation::mean_of(without).standard_error;
  return {statistic(mean_without(count)), spread * static_cast<double>(count - 1)};
}

double distance(const std::vector<double>& f, const std::vector<double>& g) {
  double apart = 0, all = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    apart += std::fabs(f[k] - g[k]);
    all += g[k];
  }
  return apart / all;
}

double mean_angle(const std::vector<double>& theta, const std::vector<double>& f) {
  double sum = 0, all = 0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    sum += theta[k] * f[k];
    all += f[k];
  }
  return sum / all;
}

/// "1.2 ± 0.3", its blanks such that no line is broken there, with as many decimals as the error needs.
std::string with_error(const Measured& measured, double unit, bool sign) {
  const double value = measured.value / unit, error = measured.standard_error / unit;
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(std::max(error, 1e-3)))), 0, 2);
  const auto fixed = [decimals](double x) {
    std::array<char, 48> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::fixed, decimals);
    return std::string(buffer.data(), end.ptr);
  };
  const std::string head = value < 0 ? "−" : sign ? "+" : "";
  return head + fixed(std::fabs(value)) + "\u00a0±\u00a0" + fixed(error);
}

} // namespace

std::vector<Note> compare_lobes(const Term& lobe, const SimulatedTerm& simulated, const std::vector<double>& theta_i,
                                double tolerance, simulation::Store& store, int threads) {
  const std::vector<double> f = binned(lobe, simulated, theta_i, tolerance);
  const Estimates g = simulated.estimates(theta_i, store, threads);
  const Measured apart = jackknife(g, [&](const std::vector<double>& mean) { return distance(f, mean); });
  const Measured shift =
      jackknife(g, [&](const std::vector<double>& mean) { return mean_angle(theta_i, f) - mean_angle(theta_i, mean); });
  return {
      {"distance\u00a0" + with_error(apart, 0.01, false) + "\u00a0%", "distance", apart.value, apart.standard_error},
      {"mean\u00a0" + with_error(shift, std::numbers::pi / 180, true) + "°", "shift of the mean theta_i", shift.value,
       shift.standard_error}};
}

} // namespace brdfplot::plot
