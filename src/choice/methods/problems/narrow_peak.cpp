#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"
#include "math/quadrature.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>

namespace brdfplot::choice {

namespace {

constexpr double peak_tolerance = 1e-9;

/// The distribution of GGX's slopes along x: of roughness alpha, about a mean.
struct SlopesAlongX {
  double alpha, mean;
  double operator()(double x) const {
    const double u = (x - mean) / alpha, w = 1 / (1 + u * u);
    return 0.5 / alpha * w * std::sqrt(w);
  }
};

using Rule = Estimate (*)(const SlopesAlongX&);

Estimate by_midpoints(const SlopesAlongX& p) {
  constexpr int n = 64;
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += p((2 * k + 1 - n) / double{n});
  return {2 * sum / n, 0, n};
}

Estimate by_gauss(const SlopesAlongX& p) {
  return {boost::math::quadrature::gauss<double, 30>::integrate(p, -1.0, 1.0), 0, 30};
}

/// Until two rules, one with twice the intervals of the other, agree.
Estimate by_doubling(const SlopesAlongX& p) {
  double last = p(-1) + p(1);
  for (int n = 2; n <= 4096; n *= 2) {
    double between = 0;
    for (int k = 1; k < n; k += 2) between += p(-1 + 2.0 * k / n);
    const double next = last / 2 + 2 * between / n;
    const double error = std::fabs(next - last) / 3;
    if (n >= 16 && error <= peak_tolerance) return {next, error, static_cast<std::size_t>(n)};
    last = next;
  }
  return {last, std::numeric_limits<double>::infinity(), 4096};
}

/// Halving where Gauss's and Kronrod's rules differ.
Estimate by_difference(const SlopesAlongX& p) {
  double error = 0;
  const double value =
      boost::math::quadrature::gauss_kronrod<double, 15>::integrate(p, -1.0, 1.0, 20, peak_tolerance, &error);
  return {value, std::max(error, peak_tolerance), 0};
}

/// In the scaled slope sinh t, in which the peak has width 1 at t = 0, where the integral is cut.
Estimate by_scaled_slope(const SlopesAlongX& p) {
  const double points[] = {std::asinh((-1 - p.mean) / p.alpha), 0, std::asinh((1 - p.mean) / p.alpha)};
  const auto integrand = [](const double* t, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const double c = std::cosh(t[k]);
      y[k] = 0.5 / (c * c);
    }
  };
  return integrate(integrand, points, {peak_tolerance, 0});
}

Exact exact_share(std::span<const double> x) {
  const Real alpha = x[0], mean = x[1];
  const auto side = [&](const Real& end) { return Real(end / sqrt(Real(alpha * alpha + end * end))); };
  return exact_of(Real((side(Real(1 - mean)) + side(Real(1 + mean))) / 2));
}

void add_rule(Problem& p, const std::string& name, const std::string& doc, const std::string& source, Kind kind,
              Rule rule, bool states_error) {
  p.methods.push_back({.name = name,
                       .doc = doc,
                       .source = source,
                       .kind = kind,
                       .run = Run<double>([rule](std::size_t n, const double* const* in, double* out) {
                         for (std::size_t i = 0; i < n; ++i) out[i] = rule({in[0][i], in[1][i]}).value;
                       })});
  if (states_error)
    p.methods.back().stated_error = [rule](std::span<const double> x) { return rule({x[0], x[1]}).error; };
}

} // namespace

Problem narrow_peak() {
  Problem p{.name = "narrow_peak",
            .doc = "Share of GGX's slopes along x that lie in [-1, 1]: a quadrature of a peak",
            .source = "Heitz 2014, Eq. 71, integrated over y",
            .inputs = {{"alpha", "roughness, the width of the peak", 1e-6, 1, Scale::logarithmic},
                       {"mean", "mean slope, where the peak is", -0.9, 0.9}},
            .exact = exact_share,
            .least = 0,
            .most = 1};
  add_rule(p, "midpoints", "64 equal steps", "textbooks", Kind::quadrature, by_midpoints, false);
  add_rule(p, "gauss", "Gauss-Legendre, 30 nodes", "textbooks", Kind::quadrature, by_gauss, false);
  add_rule(p, "doubling", "trapezia, twice as many until nothing changes by 1e-9", "textbooks", Kind::quadrature,
           by_doubling, true);
  add_rule(p, "gauss_kronrod", "halving where Gauss's 7 and Kronrod's 15 nodes differ by 1e-9", "Boost.Math",
           Kind::quadrature, by_difference, true);
  add_rule(p, "kernel", "cut at the peak, in the slope scaled by its width; halving by how fast coefficients fall",
           "the quadrature of this program", Kind::kernel, by_scaled_slope, true);
  return p;
}

} // namespace brdfplot::choice
