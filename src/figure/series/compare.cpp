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

/// The lobe's means over the bins.
std::vector<double> binned(Term lobe, const SimulatedTerm& simulated, const std::vector<double>& theta_i,
                           simulation::Store& store, int threads) {
  lobe.simulate = simulated.simulate();
  lobe.simulate->source = bins_source().name();
  std::vector<double> means;
  for (const Measured& mean : SimulatedTerm(lobe, {"theta_i"}).measure(theta_i, store, threads))
    means.push_back(mean.value);
  return means;
}

/// 1 where theta_i is positive on the viewer's side, -1 where it is on the other one, as with phi_i = phi_o + 180deg.
double viewers_side(const Term& lobe) {
  const Configuration::Ready at = SweptConfiguration(lobe, {"theta_i"}).at({1});
  return at.o && at.i && at.o->x * at.i->x + at.o->y * at.i->y < 0 ? -1 : 1;
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
                                simulation::Store& store, int threads) {
  const std::vector<double> f = binned(lobe, simulated, theta_i, store, threads);
  const double side = viewers_side(lobe);
  const Estimates g = simulated.estimates(theta_i, store, threads);
  const Measured apart = jackknife(g, [&](const std::vector<double>& mean) { return distance(f, mean); });
  const Measured shift = jackknife(
      g, [&](const std::vector<double>& mean) { return side * (mean_angle(theta_i, f) - mean_angle(theta_i, mean)); });
  return {
      {"distance\u00a0" + with_error(apart, 0.01, false) + "\u00a0%", "distance", apart.value, apart.standard_error},
      {"mean\u00a0" + with_error(shift, std::numbers::pi / 180, true) + "°", "shift of the mean theta_i", shift.value,
       shift.standard_error}};
}

} // namespace brdfplot::plot
