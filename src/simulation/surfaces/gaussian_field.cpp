#include "simulation/surfaces/gaussian_field.hpp"

#include "base/memory.hpp"
#include "base/random.hpp"
#include "base/threads/interrupt.hpp"
#include "simulation/streams.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <mutex>
#include <numbers>
#include <span>
#include <string>

namespace brdfplot::simulation {

namespace {

double determinant(const Covariance& c) { return c.xx * c.yy - c.xy * c.xy; }

/// P c P^T for the lower triangular P = chol(to) chol(from)^-1 of matrices scaled to determinant 1: what takes the
/// shape of `from` to that of `to`.
Covariance reshaped(const Covariance& c, const Covariance& from, const Covariance& to) {
  const auto root = [](const Covariance& m) {
    const double scale = std::sqrt(std::sqrt(determinant(m)));
    const double a = std::sqrt(m.xx) / scale;
    return Covariance{a, m.xy / (std::sqrt(m.xx) * scale), 1 / a};
  };
  const Covariance f = root(from), t = root(to);
  const double pxx = t.xx / f.xx, pyy = t.yy / f.yy, pyx = (t.xy - pyy * f.xy) / f.xx;
  const double xx = pxx * pxx * c.xx;
  const double xy = pxx * (pyx * c.xx + pyy * c.xy);
  const double yy = pyx * pyx * c.xx + 2 * pyx * pyy * c.xy + pyy * pyy * c.yy;
  return {xx, xy, yy};
}

/// The waves of a periodic field as FFTW orders them: ny rows of nx / 2 + 1. Left out are the constant and the waves
/// at Nyquist's limit, which have no direction.
class Waves {
public:
  explicit Waves(const FieldRequest& request) : request_(request), columns_(request.nx / 2 + 1) {
    powers_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(request.ny));
    for (int column = 0; column < columns_; ++column) {
      cosine_.push_back(std::cos(kx(column)));
      sine_.push_back(std::sin(kx(column)));
    }
  }

  int columns() const { return columns_; }
  bool used(int row, int column) const {
    return (row != 0 || column != 0) && 2 * column != request_.nx && 2 * row != request_.ny;
  }
  double& power(int row, int column) {
    return powers_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(column)];
  }
  double kx(int column) const { return 2 * std::numbers::pi * column / request_.nx; }
  double ky(int row) const {
    return 2 * std::numbers::pi * (2 * row < request_.ny ? row : row - request_.ny) / request_.ny;
  }

  /// Sets the powers of the autocorrelation exp(-x^T m x) or exp(-sqrt(x^T m x)), normalised to sum 1 over all waves;
  /// returns the covariance of the facets' slopes.
  Covariance set(const Covariance& m) {
    const double d = determinant(m);
    const Covariance inverse{m.yy / d, -m.xy / d, m.xx / d};
    double sum = 0;
    Covariance slopes;
    for (int row = 0; row < request_.ny; ++row) {
      throw_if_interrupted();
      const double y = ky(row), one_y = 1 - std::cos(y), sin_y = std::sin(y);
      for (int column = 0; column < columns_; ++column) {
        if (!used(row, column)) continue;
        const double x = kx(column);
        const double k2 = inverse.xx * x * x + 2 * inverse.xy * x * y + inverse.yy * y * y;
        const double s = power(row, column) = spectrum(k2);
        const double both = column > 0 ? 2 * s : s; // the wave and its mirror image
        const double one_x = 1 - cosine_[static_cast<std::size_t>(column)];
        sum += both;
        slopes.xx += both * 2 * one_x;
        slopes.yy += both * 2 * one_y;
        // Re (e^ix - 1)(e^-iy - 1)
        slopes.xy += both * (one_x * one_y + sine_[static_cast<std::size_t>(column)] * sin_y);
      }
    }
    for (double& s : powers_) s /= sum;
    return {slopes.xx / sum, slopes.xy / sum, slopes.yy / sum};
  }

private:
  double spectrum(double k2) const {
    return request_.autocorrelation == Autocorrelation::gaussian ? std::exp(-k2 / 4)
                                                                 : 1 / ((1 + k2) * std::sqrt(1 + k2));
  }

  const FieldRequest& request_;
  int columns_;
  std::vector<double> powers_, cosine_, sine_;
};

/// The mean square height with which the facets have the slopes asked; leaves the powers in `waves`.
double solve_for_slopes(Waves& waves, const FieldRequest& request) {
  const Covariance& asked = request.slopes;
  const double half_trace = (asked.xx + asked.yy) / 2;
  const double steepest = half_trace + std::hypot((asked.xx - asked.yy) / 2, asked.xy);
  const double scale = 1 / (steepest * request.correlation_length * request.correlation_length);
  Covariance m{scale * asked.xx, scale * asked.xy, scale * asked.yy};
  constexpr int most_steps = 60;
  for (int step = 0;; ++step) {
    const Covariance slopes = waves.set(m);
    const double height2 = std::sqrt(determinant(asked) / determinant(slopes));
    const double miss =
        std::max({std::fabs(height2 * slopes.xx / asked.xx - 1), std::fabs(height2 * slopes.yy / asked.yy - 1),
                  std::fabs(height2 * slopes.xy - asked.xy) / std::sqrt(asked.xx * asked.yy)});
    if (miss < 1e-10 || step == most_steps) return height2;
    m = reshaped(m, slopes, asked);
  }
}

using Complex = std::complex<double>;

/// Heights of the waves' amplitudes; destroys them.
std::vector<double> transform(int nx, int ny, std::span<Complex> amplitudes) {
  std::vector<double> heights(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  static std::mutex planner; // FFTW's is not safe for threads
  fftw_plan plan = nullptr;
  auto* in = reinterpret_cast<fftw_complex*>(amplitudes.data()); // as FFTW's manual allows
  {
    const std::lock_guard lock(planner);
    // A plan that is measured would depend on the machine's load, and the last bit of the heights with it.
    plan = fftw_plan_dft_c2r_2d(ny, nx, in, heights.data(), FFTW_ESTIMATE);
  }
  fftw_execute(plan);
  const std::lock_guard lock(planner);
  fftw_destroy_plan(plan);
  return heights;
}

} // namespace

Field gaussian_field(const FieldRequest& request, std::uint64_t seed, std::uint64_t realisation) {
  // Powers, amplitudes and heights at once.
  require_memory(20.0 * request.nx * request.ny,
                 "a surface of " + std::to_string(request.nx) + " by " + std::to_string(request.ny) + " heights");
  Waves waves(request);
  const double rms = std::sqrt(solve_for_slopes(waves, request));
  const auto columns = static_cast<std::size_t>(waves.columns());
  std::vector<Complex> amplitudes(columns * static_cast<std::size_t>(request.ny));
  for (int row = 0; row < request.ny; ++row) {
    throw_if_interrupted();
    Random random(seed, stream(Purpose::surface, realisation, static_cast<std::uint64_t>(row)));
    for (int column = 0; column < waves.columns(); ++column) {
      const double phase = 2 * std::numbers::pi * random.uniform();
      // In the first column the second half of the rows are the mirror images of the first.
      if (!waves.used(row, column) || (column == 0 && 2 * row > request.ny)) continue;
      const Complex amplitude = std::polar(rms * std::sqrt(waves.power(row, column)), phase);
      amplitudes[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)] = amplitude;
      if (column == 0) amplitudes[static_cast<std::size_t>(request.ny - row) * columns] = std::conj(amplitude);
    }
  }
  return {transform(request.nx, request.ny, amplitudes), rms};
}

} // namespace brdfplot::simulation
