#include "choice/methods/of_material.hpp"

#include "analysis/fit/fit.hpp"
#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"
#include "brdf/evaluate.hpp"
#include "choice/methods/add.hpp"
#include "math/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace brdfplot::choice {

namespace {

constexpr double horizon = std::numbers::pi / 2;
constexpr double finest = 1e-10;

using SharedMaterial = std::shared_ptr<const Material>;

std::string power_text(double tolerance) { return "1e" + std::to_string(std::lround(std::log10(tolerance))); }

Direction direction_at(double theta) { return {std::sin(theta), 0, std::cos(theta)}; }

/// Directions as columns.
struct DirectionColumns {
  std::vector<double> x, y, z;

  void add(const Direction& d) {
    x.push_back(d.x);
    y.push_back(d.y);
    z.push_back(d.z);
  }
  Columns columns() const { return {x.data(), y.data(), z.data()}; }
};

double lambda_at(const Material& material, double theta) {
  return evaluate(material, Quantity::lambda, direction_at(theta), std::nullopt, std::nullopt);
}

void run_lambda(const Material& material, std::size_t n, const double* theta, double* out) {
  DirectionColumns o;
  for (std::size_t i = 0; i < n; ++i) o.add(direction_at(theta[i]));
  Batch batch;
  batch.n = n;
  batch.o = o.columns();
  evaluate(material, Quantity::lambda, batch, out);
}

/// What the code of a fit computes of a polar angle.
struct FittedMaterial {
  std::shared_ptr<const FitResult> fit;
  double alpha;

  double operator()(double theta) const {
    const FitTarget& target = fit->target;
    const double c = std::cos(theta), s = std::sin(theta);
    const double y = target.parameter ? target.parameter->y(target.parameter->from) : 0;
    const double k = code_scaled(fit->code, target.alpha == FitAlpha::argument ? alpha * s : s);
    const auto terms = code_terms(fit->code, c, k, y);
    return terms.n / std::max(terms.d, 1e-30);
  }
};

void add_material_fits(Problem& p, const MaterialDescription& description, double alpha) {
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    FitOptions options;
    options.tolerance = tolerance;
    options.fixed = true;
    const auto fit = std::make_shared<const FitResult>(fit_lambda(description, options));
    const FittedMaterial fitted{fit, alpha};
    const FitCost cost = cost_of(fit->fit.form);
    p.methods.push_back({.name = "fit_" + power_text(tolerance),
                         .doc = "a rational within " + power_text(tolerance) + " of G1",
                         .source = "brdfplot fit",
                         .kind = Kind::fit,
                         .run = Run<double>([fitted](std::size_t n, const double* const* in, double* out) {
                           for (std::size_t i = 0; i < n; ++i) out[i] = fitted(in[0][i]);
                         }),
                         .operations = Operations{.multiply_adds = static_cast<std::size_t>(cost.operations),
                                                  .divisions = static_cast<std::size_t>(cost.divisions)}});
  }
}

/// Lambda = 2 int_mu^inf r P22(r) (sqrt(r^2 / mu^2 - 1) - acos(mu / r)) dr of an isotropic P22, over r = mu / cos u:
/// 2 mu^2 int_0^(pi/2) P22 (tan u - u) sin u / cos^3 u du.
Estimate lambda_by_quadrature(const Material& material, double theta, double tolerance) {
  const double mu = std::cos(theta) / std::sin(theta);
  const auto integrand = [&](const double* u, double* y, std::size_t n) {
    DirectionColumns m;
    for (std::size_t k = 0; k < n; ++k) m.add(direction_at(std::atan(mu / std::cos(u[k]))));
    Batch batch;
    batch.n = n;
    batch.m = m.columns();
    evaluate(material, Quantity::p22, batch, y);
    for (std::size_t k = 0; k < n; ++k) {
      const double c = std::cos(u[k]), s = std::sin(u[k]);
      y[k] = y[k] > 0 ? 2 * mu * mu * y[k] * (s / c - u[k]) * s / (c * c * c) : 0;
    }
  };
  const std::array<double, 2> ends = {0, horizon};
  return integrate(integrand, ends, {.absolute = 0, .relative = tolerance}, 20000);
}

/// Polar angles at which the estimates of quadratures are looked at, with the exact values.
struct Probes {
  std::vector<double> theta, exact;
};

Probes probes_of(const Problem& p) {
  constexpr int directions = 12;
  Probes probes;
  for (int k = 0; k < directions; ++k) {
    probes.theta.push_back(p.inputs[0].low + (p.inputs[0].high - p.inputs[0].low) * (k + 0.5) / directions);
    probes.exact.push_back(p.exact(std::array{probes.theta.back()}).high);
  }
  return probes;
}

/// A quadrature at a tolerance, which is told of by `estimate` at a polar angle.
void add_quadrature(Problem& p, double tolerance, const Probes& probes,
                    const std::function<Estimate(double theta)>& estimate) {
  Method method{.name = "quadrature_" + power_text(tolerance),
                .doc = "the quadrature of this program at a tolerance of " + power_text(tolerance),
                .source = "adaptive, Gauss-Kronrod",
                .kind = Kind::quadrature,
                .run = Run<double>([estimate](std::size_t n, const double* const* in, double* out) {
                  for (std::size_t i = 0; i < n; ++i) out[i] = estimate(in[0][i]).value;
                })};
  std::size_t honest = 0;
  for (std::size_t k = 0; k < probes.theta.size(); ++k) {
    throw_if_interrupted();
    const Estimate found = estimate(probes.theta[k]);
    method.evaluations = std::max(method.evaluations, static_cast<double>(found.evaluations));
    if (std::fabs(found.value - probes.exact[k]) <= found.error + p.exact_error * std::fabs(probes.exact[k])) ++honest;
  }
  method.note = "the estimate bounds the error in " + std::to_string(honest) + " of " +
                std::to_string(probes.theta.size()) + " directions";
  p.methods.push_back(std::move(method));
}

Input polar_angle() { return {"theta_o", "polar angle of the viewer", 0.05, horizon - 0.02}; }

Problem lambda_problem(const MaterialDescription& description, const SharedMaterial& material) {
  Problem p{.name = "lambda",
            .doc = "Smith's Lambda of " + description.name + " at azimuth 0",
            .source = "what the program has at its finest",
            .inputs = {polar_angle()},
            .exact =
                [material](std::span<const double> x) {
                  return Exact{lambda_at(*material, x[0]), 0};
                },
            .methods = {},
            .least = 0,
            .monotone = {1},
            .seen = [](double lambda) { return 1 / (1 + lambda); },
            .seen_as = "G1",
            .exact_error = 1e-12,
            .samples = 256};
  p.methods.push_back({.name = "program",
                       .doc = "what errors are measured against",
                       .source = "brdfplot eval -q lambda",
                       .kind = Kind::kernel,
                       .run = Run<double>([material](std::size_t n, const double* const* in, double* out) {
                         run_lambda(*material, n, in[0], out);
                       }),
                       .operations = {}});
  try {
    add_material_fits(p, description, material->surface().slopes().alpha_x);
  } catch (const MaterialError&) { // what cannot be fitted has no fits
  }
  if (!material->terms.at(0).is_isotropic()) return p;
  const Probes probes = probes_of(p);
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9})
    add_quadrature(p, tolerance, probes,
                   [material, tolerance](double theta) { return lambda_by_quadrature(*material, theta, tolerance); });
  return p;
}

Problem brdf_problem(const MaterialDescription& description, const SharedMaterial& material) {
  const Run<double> run = [material](std::size_t n, const double* const* in, double* out) {
    DirectionColumns o, i;
    for (std::size_t k = 0; k < n; ++k) {
      o.add(direction_at(in[0][k]));
      const double s = std::sin(in[1][k]);
      i.add({s * std::cos(in[2][k]), s * std::sin(in[2][k]), std::cos(in[1][k])});
    }
    Batch batch;
    batch.n = n;
    batch.o = o.columns(), batch.i = i.columns();
    std::vector<double> channels(n * static_cast<std::size_t>(material->channels()));
    evaluate(*material, Quantity::brdf, batch, channels.data());
    std::copy_n(channels.begin(), n, out);
  };
  Problem p{.name = "brdf",
            .doc = "BRDF of " + description.name + ", first channel",
            .source = "what the program has on its first instruction set",
            .inputs = {{"theta_o", "polar angle of the viewer", 0, horizon - 0.01},
                       {"theta_i", "polar angle of the light", 0, horizon - 0.01},
                       {"phi_i", "azimuth of the light", 0, std::numbers::pi}},
            .exact =
                [run](std::span<const double> x) {
                  const kernels::IsaHere here(kernels::Isa::baseline);
                  const std::array<const double*, 3> in = {x.data(), x.data() + 1, x.data() + 2};
                  double value = 0;
                  run(1, in.data(), &value);
                  return Exact{value, 0};
                },
            .methods = {},
            .least = 0,
            .seen = {},
            .exact_error = 1e-14,
            .samples = 2048};
  add_kernel<double>(p, {"program", "brdfplot eval", "the material", Kind::kernel, 0}, std::nullopt, run);
  return p;
}

Problem integral_problem(const MaterialDescription& description, const SharedMaterial& material, Integral integral,
                         const std::string& name) {
  const auto estimate = [material, integral](double theta, double tolerance) {
    return compute(integral, *material, direction_at(theta), tolerance);
  };
  Problem p{.name = name,
            .doc = (integral == Integral::albedo ? "Albedo of " : "Furnace test of ") + description.name,
            .source = "the quadrature of this program at its finest, a tolerance of 1e-10",
            .inputs = {polar_angle()},
            .exact =
                [estimate](std::span<const double> x) {
                  return Exact{estimate(x[0], finest).value, 0};
                },
            .methods = {},
            .least = 0,
            .seen = {},
            .cost_unit = "evaluations of the integrand",
            .exact_error = finest,
            .samples = 32};
  const Probes probes = probes_of(p);
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-7, 1e-9})
    add_quadrature(p, tolerance, probes, [estimate, tolerance](double theta) { return estimate(theta, tolerance); });
  return p;
}

/// Whether the material has such an integral.
bool has(const Material& material, Integral integral) {
  const auto& all = integrals();
  const auto info = std::ranges::find(all, integral, &IntegralInfo::integral);
  try {
    require(material, *info);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

} // namespace

std::vector<Problem> problems_of(const MaterialDescription& description) {
  const auto material = std::make_shared<const Material>(build(description));
  std::vector<Problem> problems;
  const bool one_surface = material->terms.size() == 1 && material->terms[0].surface() != nullptr;
  if (one_surface && material->surface().has_lambda()) problems.push_back(lambda_problem(description, material));
  problems.push_back(brdf_problem(description, material));
  for (const auto& [integral, name] : {std::pair{Integral::albedo, "albedo"}, std::pair{Integral::furnace, "furnace"}})
    if (has(*material, integral)) problems.push_back(integral_problem(description, material, integral, name));
  return problems;
}

} // namespace brdfplot::choice
