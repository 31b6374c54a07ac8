/// \file
/// The weak white furnace test (Heitz 2014, Eq. 36; exactly 1) by several integrators, over 40 cases: Beckmann and GGX;
/// alpha = 0.01 ... 1; theta_o = 0.1 ... 1.55. What each reaches, what it claims, and what it costs.
#include "analysis/integrals.hpp"
#include "math/quadrature.hpp"

#ifdef BRDFPLOT_BENCH_CUBATURE
#include <cubature.h>
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace brdfplot;
using std::numbers::pi;

constexpr double tolerance = 1e-9;
constexpr std::size_t budget = 1000000;

struct Case {
  Material material;
  Direction o;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto* type : {"beckmann", "ggx"})
    for (const double alpha : {0.01, 0.05, 0.1, 0.5, 1.0})
      for (const double theta : {0.1, 0.8, 1.4, 1.55}) {
        TermDescription description;
        description.name = type;
        description.distribution.type = type;
        description.distribution.values.set("alpha", alpha);
        all.push_back({build(description), from_angles(theta, 0)});
      }
  return all;
}

/// What is integrated over omega_i, sin theta_i included, at one direction.
double integrand(const Case& one, double theta, double phi) {
  const Direction i = from_angles(theta, phi);
  const double g1 = evaluate(one.material, Quantity::g1, one.o, i, std::nullopt);
  return g1 > 0 ? g1 * evaluate(one.material, Quantity::d, one.o, i, std::nullopt) / (4 * one.o.z) * std::sin(theta)
                : 0;
}

/// Adaptive Gauss-Kronrod in phi for every node of an adaptive one in theta.
Estimate nested(const Case& one) {
  std::size_t evaluations = 0;
  double worst = 0;
  const std::array<double, 2> around = {0, 2 * pi}, down = {0, pi};
  const auto outer = [&](const double* theta, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto inner = [&](const double* phi, double* z, std::size_t m) {
        for (std::size_t j = 0; j < m; ++j) z[j] = integrand(one, theta[k], phi[j]);
      };
      const Estimate e = integrate(inner, around, {.absolute = 0.1 * tolerance}, 4000);
      evaluations += e.evaluations;
      worst = std::max(worst, e.error);
      y[k] = e.value;
    }
  };
  Estimate e = integrate(outer, down, {.absolute = tolerance}, 4000);
  return {e.value, e.error + pi * worst, evaluations};
}

#ifdef BRDFPLOT_BENCH_CUBATURE
/// Steven G. Johnson's cubature (Genz and Malik's rule, h-adaptive).
Estimate h_adaptive(const Case& one) {
  struct Counted {
    const Case* one;
    std::size_t evaluations;
  } counted{&one, 0};
  const auto f = [](unsigned, const double* x, void* data, unsigned, double* value) {
    auto& self = *static_cast<Counted*>(data);
    ++self.evaluations;
    *value = integrand(*self.one, x[0], x[1]);
    return 0;
  };
  const std::array<double, 2> low = {0, 0}, high = {pi, 2 * pi};
  Estimate e;
  hcubature(1, f, &counted, 2, low.data(), high.data(), budget, tolerance, 0, ERROR_INDIVIDUAL, &e.value, &e.error);
  e.evaluations = counted.evaluations;
  return e;
}
#endif

struct Method {
  std::string name;
  std::function<Estimate(const Case&)> run;
  bool claims = true; ///< whether it has an estimate
  int repetitions = 1;
};

/// Seconds of one run, the fastest of several measurements where it is short: other processes disturb the rest.
double seconds(const Method& method, const Case& one) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300;
  for (int attempt = 0; attempt < (method.repetitions > 1 ? 30 : 1); ++attempt) {
    const auto start = Clock::now();
    for (int k = 0; k < method.repetitions; ++k) (void)method.run(one);
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count() / method.repetitions);
  }
  return best;
}

void print(const Method& method, const std::vector<Case>& all) {
  std::vector<double> costs, times;
  int below_6 = 0, below_10 = 0, bounded = 0, wrong = 0;
  double worst = 0;
  for (const Case& one : all) {
    const Estimate e = method.run(one);
    const double error = std::fabs(e.value - 1);
    below_6 += error < 1e-6;
    below_10 += error < 1e-10;
    bounded += error <= e.error;
    wrong += e.error <= tolerance && error > 1e-2;
    worst = std::max(worst, error);
    costs.push_back(static_cast<double>(e.evaluations));
    times.push_back(1e6 * seconds(method, one));
  }
  std::ranges::sort(costs);
  std::ranges::sort(times);
  const std::size_t middle = all.size() / 2;
  const auto claim = [&](int count) { return method.claims ? std::to_string(count) : "-"; };
  std::printf("%-44s %8d %8d %9.1e %8s %8s %9.0f %9.0f %10.1f %10.1f\n", method.name.c_str(), below_6, below_10, worst,
              claim(bounded).c_str(), claim(wrong).c_str(), costs[middle], costs.back(), times[middle], times.back());
}

} // namespace

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // rows appear as they are done
  const auto all = cases();
  std::printf("Eq. 36, %zu cases, asked for an absolute error of %g\n\n", all.size(), tolerance);
  std::printf("%-44s %8s %8s %9s %8s %8s %9s %9s %10s %10s\n", "", "error", "error", "worst", "estimate", "claimed,",
              "evalua-", "", "us,", "");
  std::printf("%-44s %8s %8s %9s %8s %8s %9s %9s %10s %10s\n", "method", "< 1e-6", "< 1e-10", "error", "bounds",
              "> 1e-2", "tions", "most", "median", "most");
  const auto line = [](const Case& one) { return compute(Integral::weak_furnace, one.material, one.o, tolerance); };
  const auto plane = [](const Case& one) {
    return compute_in_plane(Integral::weak_furnace, one.material, one.o, tolerance);
  };
  const auto grid = [](const Case& one) { return compute(Integral::weak_furnace_grid, one.material, one.o); };
  print({"one dimension (G1 free of the normal)", line, true, 200}, all);
  print({"plane of slopes", plane, true, 5}, all);
  print({"grid of 0.05 rad (Heitz 2014, Appendix C)", grid, false}, all);
  print({"nested Gauss-Kronrod over the sphere", nested}, all);
#ifdef BRDFPLOT_BENCH_CUBATURE
  print({"h-adaptive cubature over the sphere", h_adaptive}, all);
#else
  std::puts("(no h-adaptive cubature: libcubature is not there)");
#endif
  return 0;
}
