#include "analysis/fit/minimax/minimax.hpp"

#include "analysis/fit/minimax/maximin.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

/// An earlier fit with its derivatives.
struct Near {
  explicit Near(const LambdaFit& earlier)
      : fit(earlier), slope_n(derivative_x(earlier.n)), slope_m(derivative_x(earlier.m)) {}

  LambdaFit fit;
  Polynomial slope_n;
  Polynomial slope_m;
};

/// The values of the Bernstein polynomials of one degree and of their derivatives.
struct Basis {
  Basis(std::size_t degree, double x) : value(degree + 1), slope(degree + 1) {
    bernstein(degree, x, value.data());
    if (degree == 0) return;
    std::vector<double> lower(degree);
    bernstein(degree - 1, x, lower.data());
    for (std::size_t k = 0; k <= degree; ++k)
      slope[k] = static_cast<double>(degree) * ((k > 0 ? lower[k - 1] : 0) - (k < degree ? lower[k] : 0));
  }

  std::vector<double> value;
  std::vector<double> slope;
};

/// What is asked at one sample, as linear functions of the Bernstein coefficients of n and m.
struct Terms {
  std::vector<double> difference; ///< x m Lambda - (1 - x)^p n
  std::vector<double> sum;        ///< x m + (1 - x)^p n
  std::vector<double> fall;       ///< minus the slope of (1 - x)^p n / x, times positive factors
  std::vector<double> slope;      ///< of G1, times positive factors (see LambdaFit::proved_sound)

  void add_n(const RationalForm& form, const FitSample& sample, const Near* near) {
    const double x = form.x(sample.a);
    const double vanishing = form.vanishing(sample.a);
    const double m = near ? near->fit.m(x, sample.y) : 0;
    const double of_value = near ? form.power * x * m + (1 - x) * (m + x * near->slope_m(x, sample.y)) : 0;
    const Basis bx(form.nx, x);
    const Basis by(form.ny, sample.y);
    for (std::size_t j = 0; j <= form.ny; ++j) {
      for (std::size_t i = 0; i <= form.nx; ++i) {
        const double b = bx.value[i] * by.value[j];
        difference.push_back(-vanishing * b);
        sum.push_back(vanishing * b);
        fall.push_back((1 + (form.power - 1) * x) * b - x * (1 - x) * bx.slope[i] * by.value[j]);
        slope.push_back(of_value * b - (1 - x) * x * m * bx.slope[i] * by.value[j]);
      }
    }
    // The product at the earlier fit, counted twice so far; n(0, 0) = 1 there, and v[0] is n(0, 0).
    if (near) slope[0] -= of_value * near->fit.n(x, sample.y) - (1 - x) * x * m * near->slope_n(x, sample.y);
  }

  void add_m(const RationalForm& form, const FitSample& sample, const Near* near) {
    const double x = form.x(sample.a);
    const double n0 = near ? near->fit.n(x, sample.y) : 0;
    const double of_value = near ? n0 * (form.power * x + 1 - x) - (1 - x) * x * near->slope_n(x, sample.y) : 0;
    const Basis bx(form.mx, x);
    const Basis by(form.my, sample.y);
    for (std::size_t j = 0; j <= form.my; ++j) {
      for (std::size_t i = 0; i <= form.mx; ++i) {
        const double b = bx.value[i] * by.value[j];
        difference.push_back(x * b * sample.lambda);
        sum.push_back(x * b);
        fall.push_back(0);
        slope.push_back(of_value * b + (1 - x) * x * n0 * bx.slope[i] * by.value[j]);
      }
    }
  }
};

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::fabs(value));
  return result;
}

double denominator(const LambdaFit& fit, const FitSample& sample) {
  const double x = fit.form.x(sample.a);
  return x * fit.m(x, sample.y) + fit.form.vanishing(sample.a) * fit.n(x, sample.y);
}

void append(Rows& rows, const FitSample& sample, double tolerance, const RationalForm& form, const Near* near,
            bool increasing) {
  // The slopes may come near 0, but are not to be 0: the weight of their rows says how near.
  constexpr double weight_of_signs = 1e3;
  Terms terms;
  terms.add_n(form, sample, near);
  terms.add_m(form, sample, near);
  const double scale = near ? denominator(near->fit, sample) : std::max(largest(terms.difference), largest(terms.sum));
  for (const double sign : {-1.0, 1.0})
    for (std::size_t i = 0; i < rows.columns; ++i)
      rows.values.push_back((tolerance * terms.sum[i] + sign * terms.difference[i]) / scale);
  for (const double fall : terms.fall) rows.values.push_back(weight_of_signs * fall);
  if (!increasing) return;
  const double size = largest(terms.slope);
  for (const double slope : terms.slope) rows.values.push_back(weight_of_signs * slope / size);
}

/// The solution with the constant coefficient of n scaled to 1; nothing where it is not positive.
std::optional<LambdaFit> as_fit(const RationalForm& form, const std::vector<double>& v) {
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>((form.nx + 1) * (form.ny + 1));
  LambdaFit fit{form, from_bernstein(form.nx, form.ny, {v.begin(), middle}),
                from_bernstein(form.mx, form.my, {middle, v.end()})};
  const double unit = fit.n.c[0];
  if (!(unit > 0)) return std::nullopt;
  for (double& c : fit.n.c) c /= unit;
  for (double& c : fit.m.c) c /= unit;
  return fit;
}

/// So many samples of so many lines, spread over all.
std::vector<std::size_t> some_samples(const FitSamples& samples, std::size_t per_line, std::size_t most_lines) {
  const std::size_t lines = samples.samples.size() / samples.per_line;
  const auto spread = [](std::size_t k, std::size_t count, std::size_t size) {
    return count > 1 ? k * (size - 1) / (count - 1) : size / 2;
  };
  std::vector<std::size_t> chosen;
  const std::size_t count = std::min(per_line, samples.per_line);
  const std::size_t some_lines = std::min(most_lines, lines);
  for (std::size_t j = 0; j < some_lines; ++j)
    for (std::size_t i = 0; i < count; ++i)
      chosen.push_back(spread(j, some_lines, lines) * samples.per_line + spread(i, count, samples.per_line));
  return chosen;
}

/// The size of the error; infinite where n or m is not positive.
double fault(const LambdaFit& fit, const FitSample& s) {
  const double error = std::fabs(fit.relative_error(s.a, s.y, s.lambda));
  const double x = fit.form.x(s.a);
  return fit.n(x, s.y) > 0 && fit.m(x, s.y) > 0 && error < HUGE_VAL ? error : HUGE_VAL;
}

/// Where the fault exceeds `bound` and those of the neighbours on all sides; the worst 60.
std::vector<std::size_t> violations(const LambdaFit& fit, const FitSamples& samples, double bound) {
  const std::size_t size = samples.samples.size();
  const std::size_t line = samples.per_line;
  std::vector<double> faults(size);
  for (std::size_t k = 0; k < size; ++k) faults[k] = fault(fit, samples.samples[k]);
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < size; ++k) {
    if (faults[k] <= bound) continue;
    const std::size_t place = k % line;
    const bool peak = (place == 0 || faults[k] >= faults[k - 1]) && (place + 1 == line || faults[k] >= faults[k + 1]) &&
                      (k < line || faults[k] >= faults[k - line]) &&
                      (k + line >= size || faults[k] >= faults[k + line]);
    if (peak) found.push_back(k);
  }
  std::ranges::stable_sort(found, [&](std::size_t k, std::size_t l) { return faults[k] > faults[l]; });
  constexpr std::size_t most = 60;
  if (found.size() <= most) return found;
  std::vector<std::size_t> spread; // plateaus of infinite faults are not taken from one end
  for (std::size_t k = 0; k < most; ++k) spread.push_back(found[k * found.size() / most]);
  return spread;
}

/// Appends samples at which G1 does not increase with a, spread over all those.
void append_falling(std::vector<std::size_t>& samples_found, const LambdaFit& fit, const FitSamples& samples) {
  const Polynomial slope = fit.scaled_slope();
  std::vector<std::size_t> falling;
  for (std::size_t k = 0; k < samples.samples.size(); ++k)
    if (!(slope(fit.form.x(samples.samples[k].a), samples.samples[k].y) > 0)) falling.push_back(k);
  constexpr std::size_t most = 40;
  const std::size_t count = std::min(most, falling.size());
  for (std::size_t k = 0; k < count; ++k) samples_found.push_back(falling[k * falling.size() / count]);
}

} // namespace

FitError largest_error(const LambdaFit& fit, const FitSamples& samples) {
  FitError worst{-1, {}};
  for (const FitSample& s : samples.samples) {
    const double error = std::fabs(fit.relative_error(s.a, s.y, s.lambda));
    if (!(error <= worst.error)) worst = {error, s};
  }
  return worst;
}

std::optional<LambdaFit> fit_within(double tolerance, const RationalForm& form, const FitSamples& samples,
                                    const LambdaFit* near, const std::vector<std::size_t>* rising) {
  const std::optional<Near> start = near ? std::optional<Near>(*near) : std::nullopt;
  Rows rows{form.coefficients()};
  const auto take = [&](std::size_t k) {
    append(rows, samples.samples[k], tolerance, form, start ? &*start : nullptr, rising != nullptr);
  };
  for (const std::size_t k : some_samples(samples, 2 * (form.nx + form.mx) + 14, form.ny + form.my + 4)) take(k);
  if (rising) std::ranges::for_each(*rising, take);
  for (int round = 0; round < 12; ++round) {
    const Maximin solution = maximin(rows);
    if (!(solution.value > 0)) return std::nullopt;
    auto fit = as_fit(form, solution.v);
    if (!fit) return std::nullopt;
    const auto worst = violations(*fit, samples, tolerance);
    if (worst.empty()) return fit;
    for (const std::size_t k : worst) take(k);
  }
  return std::nullopt;
}

std::optional<LambdaFit> minimax_fit(double tolerance, const RationalForm& form, const FitSamples& samples) {
  std::optional<LambdaFit> best = fit_within(tolerance, form, samples);
  for (int step = 0; best && step < 12; ++step) {
    const double error = largest_error(*best, samples).error;
    const auto next = fit_within(0.99 * error, form, samples, &*best);
    if (!next) break;
    best = next;
  }
  return best;
}

std::optional<LambdaFit> sound_fit(double tolerance, const RationalForm& form, const FitSamples& samples) {
  std::optional<LambdaFit> fit = minimax_fit(tolerance, form, samples);
  if (!fit || fit->proved_sound()) return fit;
  // Of the tolerance as little is given away as makes it sound.
  const double least = largest_error(*fit, samples).error;
  std::vector<std::size_t> rising;
  for (const double factor : {1.02, 1.1, 1.3, 2.0, 4.0}) {
    for (int step = 0; step < 8; ++step) {
      const auto next = fit_within(std::min(factor * least, tolerance), form, samples, &*fit, &rising);
      if (!next) break;
      fit = next;
      if (fit->proved_sound()) return fit;
      append_falling(rising, *fit, samples);
    }
    if (factor * least >= tolerance) break;
  }
  return std::nullopt;
}

} // namespace brdfplot
