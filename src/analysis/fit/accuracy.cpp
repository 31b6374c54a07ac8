#include "analysis/fit/accuracy.hpp"

#include "analysis/fit/rounding.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

namespace brdfplot {

namespace {

/// What the text of the number is worth in double.
double written(double value, bool single) { return *parse_number(shortest_digits(value, single)); }

/// What a parabola through three samples leaves out of a maximum, and samples a maximum's neighbours.
constexpr double beyond_parabola = 2, beyond_samples = 1.0001;

/// The error of Lambda is given from 0.01 on, and grows as Lambda falls: it is taken from the sample beyond that.
constexpr double least_lambda = 0.009;

double scale_of_s(const FitTarget& target) { return target.alpha == FitAlpha::constant ? target.alpha_value : 1; }

CodePolynomial as_code(const Polynomial& p, bool in_u, bool single) {
  CodePolynomial code{in_u ? mirrored_x(p) : p, in_u};
  for (double& c : code.of.c) c = written(c, single);
  return code;
}

/// A direction at which the code is asked for G1(a, y): cosine, alpha (1 where it is free, since all depends on c / s)
/// and the parameter.
struct Arguments {
  double c = 0;
  double alpha = 1;
  double parameter = 0;
};

Arguments arguments_at(const FitTarget& target, const FitSample& at) {
  Arguments out;
  if (target.parameter) out.parameter = target.parameter->value(at.y);
  if (target.alpha == FitAlpha::constant) out.alpha = target.alpha_value;
  if (target.alpha == FitAlpha::parameter) out.alpha = out.parameter;
  if (target.alpha == FitAlpha::root_of_y) out.alpha = std::sqrt(target.parameter->y(out.parameter));
  const double cot = at.a * out.alpha;
  out.c = cot / std::hypot(1.0, cot);
  return out;
}

/// A bound of the relative error of s where it comes from vectors: the largest over azimuths of the material's own.
template <class Machine>
double error_of_projection(const SlopeMap& map) {
  using Real = Rounded<Machine>;
  const Real one(1.0);
  const Real r = Real::exact(map.correlation), along = Real::exact(map.alpha_x), across = Real::exact(map.alpha_y);
  double worst = 0;
  constexpr int steps = 1440;
  for (int k = 0; k < steps; ++k) {
    const double phi = std::numbers::pi * k / steps;
    const Real x = Real::exact(std::cos(phi)), y = Real::exact(std::sin(phi));
    const Real u = along * x + r * across * y;
    const Real v = sqrt((one - r) * (one + r)) * across * y;
    const Real s = sqrt(u * u + v * v);
    worst = std::max(worst, s.error / s.value);
  }
  return worst;
}

/// A bound of the relative error of s.
template <class Machine>
double error_of_roughness(const FitTarget& target, const Arguments& at, double of_projection) {
  using Real = Rounded<Machine>;
  const Real y = target.parameter ? code_y(*target.parameter, Real::exact(at.parameter)) : Real(0.0);
  const Real s = code_roughness(target, Real::exact(at.c), Real::exact(at.alpha), y);
  return std::max(s.value > 0 ? s.error / s.value : 0, of_projection);
}

/// |d ln G1 / d ln s| of the code, by a difference.
double sensitivity(const FitCode& code, double c, double s, double y) {
  constexpr double step = 0x1p-10;
  const auto g1 = [&](double roughness) {
    const auto terms = code_terms(code, c, code_scaled(code, roughness), y);
    return terms.d / (terms.d + terms.n);
  };
  return std::fabs(g1(s * (1 + step)) / g1(s) - 1) / step * 1.01;
}

/// Relative bounds of what rounding does to G1 and to Lambda at one sample.
struct Rounding {
  double g1 = 0;
  double lambda = 0;
  bool in_range = true;
};

template <class Machine>
Rounding rounding_at(const FitTarget& target, const FitCode& code, const FitSample& sample, double of_projection) {
  using Real = Rounded<Machine>;
  const Arguments at = arguments_at(target, sample);
  // c and s to a common factor, which changes nothing but by rounding; of sin(theta) alone where alpha is a constant.
  const double s = 1 / std::hypot(1.0, sample.a), a = sample.a * scale_of_s(target), c = a * s;
  const Real y = target.parameter ? code_y(*target.parameter, Real::exact(at.parameter)) : Real(0.0);
  // The error of k is one of s: as such it weighs less than in every place where k stands.
  const Real k = code_scaled(code, Real::exact(s));
  const FitTerms<Real> terms = code_terms(code, Real::exact(c), Real::exact(k.value), y);
  const double n = terms.n.value, d = terms.d.value;
  const double of_s =
      (error_of_roughness<Machine>(target, at, of_projection) + k.error / k.value) * sensitivity(code, c, s, y.value);
  const double of_ends = terms.n.error + terms.d.error;
  const double least = std::max(d + n - of_ends, 0.0);
  // G1 = 1 / (1 + n / d): an error of d weighs as n / (d + n) does.
  const double of_terms = (n * terms.d.error + d * terms.n.error) / (d * least);
  Rounding out;
  out.g1 = of_s + of_terms + Machine::unit + Machine::quotient;
  out.lambda = (of_s + of_terms) * (d + n) / n + Machine::quotient;
  out.in_range = terms.n_factor.value > terms.n_factor.error && terms.m_factor.value > terms.m_factor.error;
  return out;
}

/// By how much |e| is larger between a sample and its neighbours than at it, by the parabola through the three; 0 where
/// it is no maximum. All of one distance by number, as places of sample() all but are.
double rise(double before, double at, double after) {
  const double sign = at < 0 ? -1 : 1, low = sign * before, high = sign * after, top = sign * at;
  if (!(top >= low && top >= high && 2 * top > low + high)) return 0;
  return (high - low) * (high - low) / (8 * (2 * top - low - high));
}

/// The error of a fit at each sample, as large as it may be between that one and the next ones.
std::vector<double> errors_about(const LambdaFit& fit, const FitSamples& samples) {
  const std::size_t n = samples.samples.size(), line = samples.per_line;
  std::vector<double> at(n), about(n);
  for (std::size_t k = 0; k < n; ++k) {
    const FitSample& s = samples.samples[k];
    at[k] = fit.relative_error(s.a, s.y, s.lambda);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t place = k % line;
    double more = 0;
    if (place > 0 && place + 1 < line) more += rise(at[k - 1], at[k], at[k + 1]);
    if (k >= line && k + line < n) more += rise(at[k - line], at[k], at[k + line]);
    about[k] = beyond_samples * (std::fabs(at[k]) + beyond_parabola * more);
  }
  return about;
}

template <class Machine>
FitAccuracy accuracy(const FitTarget& target, const FitCode& code, const FitSamples& samples) {
  FitAccuracy out;
  const LambdaFit fit = without_rounding(code, target);
  const std::vector<double> errors = errors_about(fit, samples);
  const double of_projection = target.by_cosine() ? 0 : error_of_projection<Machine>(target.slopes);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const FitSample& s = samples.samples[k];
    const Rounding rounding = rounding_at<Machine>(target, code, s, of_projection);
    const double of_fit = errors[k];
    const double error = of_fit + rounding.g1 * (1 + of_fit);
    if (!(error <= out.relative.error)) out.relative = {error, s};
    out.absolute = std::max(out.absolute, error / (1 + s.lambda));
    out.rounding = std::max(out.rounding, rounding.g1);
    out.in_range = out.in_range && rounding.in_range;
    if (!(s.lambda >= least_lambda)) continue;
    const double of_lambda = std::fabs(fit.lambda(s.a, s.y) / s.lambda - 1);
    out.lambda = std::max(out.lambda, of_lambda + rounding.lambda * (1 + of_lambda));
  }
  return out;
}

} // namespace

FitAccuracy accuracy_of(const FitTarget& target, const FitCode& code, const FitSamples& samples, bool single) {
  return single ? accuracy<SingleArithmetic>(target, in_floats(code), samples)
                : accuracy<DoubleArithmetic>(target, code, samples);
}

std::string shortest_digits(double value, bool single) {
  if (!single) return format_number(value);
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(value)).ptr;
  return {text, end};
}

FitCode in_floats(FitCode code) {
  const auto round = [](double& value) { value = SingleArithmetic::nearest(value); };
  round(code.scale);
  std::ranges::for_each(code.n.of.c, round);
  std::ranges::for_each(code.m.of.c, round);
  return code;
}

FitCode as_code(const LambdaFit& fit, const FitTarget& target, bool n_in_u, bool m_in_u, bool single) {
  return {fit.form.cut, fit.form.power, written(fit.form.scale * scale_of_s(target), single),
          as_code(fit.n, n_in_u, single), as_code(fit.m, m_in_u, single)};
}

LambdaFit without_rounding(const FitCode& code, const FitTarget& target) {
  const auto in_x = [](const CodePolynomial& p) { return p.in_u ? mirrored_x(p.of) : p.of; };
  const Polynomial n = in_x(code.n), m = in_x(code.m);
  return {{code.cut, code.scale / scale_of_s(target), code.power, n.dx, n.dy, m.dx, m.dy}, n, m};
}

} // namespace brdfplot
