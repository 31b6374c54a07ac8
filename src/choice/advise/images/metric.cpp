#include "choice/advise/images/metric.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

using Matrix = std::array<Rgb, 3>;

constexpr Matrix bt709_to_bt2020 = {{{0.6274038959, 0.3292830384, 0.0433130657},
                                     {0.0690972894, 0.9195403951, 0.0113623156},
                                     {0.0163914389, 0.0880133079, 0.8955952532}}};
/// In 4096ths.
constexpr Matrix bt2020_to_lms = {{{1688, 2146, 262}, {683, 2951, 462}, {99, 309, 3688}}};
constexpr Matrix lms_to_ictcp = {{{2048, 2048, 0}, {6610, -13613, 7003}, {17933, -17390, -543}}};

Rgb times(const Matrix& m, const Rgb& v, double scale) {
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = (m[k][0] * v[0] + m[k][1] * v[1] + m[k][2] * v[2]) * scale;
  return out;
}

/// The signal of SMPTE ST 2084 for cd/m^2.
double perceptual_quantiser(double luminance) {
  constexpr double m1 = 2610.0 / 16384, m2 = 2523.0 / 4096 * 128;
  constexpr double c1 = 3424.0 / 4096, c2 = 2413.0 / 4096 * 32, c3 = 2392.0 / 4096 * 32;
  const double y = std::pow(std::fmax(luminance, 0.0) / 10000, m1);
  return std::pow((c1 + c2 * y) / (1 + c3 * y), m2);
}

Rgb itp(const Rgb& bt709) {
  Rgb lms = times(bt2020_to_lms, times(bt709_to_bt2020, bt709, 1), 1.0 / 4096);
  for (double& v : lms) v = perceptual_quantiser(v);
  const Rgb ictcp = times(lms_to_ictcp, lms, 1.0 / 4096);
  return {ictcp[0], 0.5 * ictcp[1], ictcp[2]};
}

} // namespace

Rgb shown(const Rgb& rgb, double exposure) {
  Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = std::fmin(screen_white * exposure * rgb[c], screen_peak) + screen_flare;
  return out;
}

double delta_e_itp(const Rgb& a, const Rgb& b) {
  const Rgb u = itp(a), v = itp(b);
  return 720 * std::hypot(u[0] - v[0], u[1] - v[1], u[2] - v[2]);
}

double difference(Metric metric, const Rgb& a, const Rgb& b, double exposure) {
  if (metric == Metric::delta_e) return delta_e_itp(shown(a, exposure), shown(b, exposure));
  const double flare = screen_flare / (screen_white * exposure);
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::fabs(a[c] - b[c]) / (a[c] + flare));
  return most;
}

} // namespace brdfplot::choice
