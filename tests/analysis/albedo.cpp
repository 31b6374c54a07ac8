// Directional albedos of single scattering, F = 1, to 1e-8 for every form of G2, against a product rule that shares no
// code with the library: neither models, nor charts, nor quadrature.
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace test;

namespace {

using std::numbers::pi;

enum class Shape { beckmann, ggx };
constexpr std::array<const char*, 2> shape_names = {"beckmann", "ggx"};

struct Form {
  const char *shadowing, *lambda;
};
constexpr std::array<Form, 8> forms = {{{"none", ""},
                                        {"separable", ""},
                                        {"minimum", ""},
                                        {"height_correlated", ""},
                                        {"direction_correlated", "ashikhmin"},
                                        {"direction_correlated", "ginneken"},
                                        {"height_direction_correlated", "ashikhmin"},
                                        {"height_direction_correlated", "ginneken"}}};
using Albedos = std::array<double, forms.size()>;

double density(Shape shape, double alpha, double r2) {
  const double t2 = r2 / (alpha * alpha);
  return (shape == Shape::beckmann ? std::exp(-t2) : 1 / ((1 + t2) * (1 + t2))) / (pi * alpha * alpha);
}

double lambda_of(Shape shape, double alpha, double sin_theta, double cos_theta) {
  if (sin_theta == 0) return 0;
  const double a = cos_theta / (alpha * sin_theta);
  if (shape == Shape::ggx) return 0.5 * (std::hypot(1.0, 1 / a) - 1);
  return a > 8 ? 0 : 0.5 * (std::exp(-a * a) / (a * std::sqrt(pi)) - std::erfc(a));
}

/// G2 of all forms.
Albedos joint(double lambda_o, double lambda_i, double azimuth) {
  const double g_o = 1 / (1 + lambda_o), g_i = 1 / (1 + lambda_i);
  const double least = std::min(g_o, g_i), product = g_o * g_i;
  const double low = std::min(lambda_o, lambda_i), high = std::max(lambda_o, lambda_i);
  const double ashikhmin = 1 - std::exp(-7.3 * azimuth * azimuth), ginneken = 4.41 * azimuth / (4.41 * azimuth + 1);
  return {g_o,
          product,
          least,
          1 / (1 + lambda_o + lambda_i),
          ashikhmin * product + (1 - ashikhmin) * least,
          ginneken * product + (1 - ginneken) * least,
          1 / (1 + high + ashikhmin * low),
          1 / (1 + high + ginneken * low)};
}

/// Weighted shapes of their own roughness, on one mesosurface.
struct Lobe {
  Shape shape;
  double alpha, weight = 1;
};
using Lobes = std::vector<Lobe>;

struct GaussLegendre {
  std::vector<double> x, w; ///< on [0, 1]

  explicit GaussLegendre(int n) {
    for (int k = 0; k < n; ++k) {
      double z = std::cos(pi * (k + 0.75) / (n + 0.5)), slope = 0;
      for (int step = 0; step < 50; ++step) { // Newton on the Legendre polynomial
        double p = 1, before = 0;
        for (int j = 0; j < n; ++j) {
          const double next = ((2 * j + 1) * z * p - j * before) / (j + 1);
          before = p;
          p = next;
        }
        slope = n * (z * p - before) / (z * z - 1);
        z -= p / slope;
      }
      x.push_back(0.5 * (1 + z));
      w.push_back(1 / ((1 - z * z) * slope * slope));
    }
  }
};

/// Edges of panels from a to b, that double in size from `smallest` at both ends to the middle.
std::vector<double> graded(double a, double b, double smallest) {
  std::vector<double> edges = {a}, back = {b};
  for (double step = smallest; step < 0.4 * (b - a); step *= 2) {
    edges.push_back(a + step);
    back.push_back(b - step);
  }
  edges.push_back(0.5 * (a + b));
  edges.insert(edges.end(), back.rbegin(), back.rend());
  return edges;
}

/// Sums f(x) w over the panels of all intervals between neighbours in `points`.
template <class F>
void sum_over(const GaussLegendre& rule, const std::vector<double>& points, double smallest, const F& f) {
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const auto edges = graded(points[k], points[k + 1], smallest);
    for (std::size_t e = 0; e + 1 < edges.size(); ++e)
      for (std::size_t n = 0; n < rule.x.size(); ++n)
        f(edges[e] + (edges[e + 1] - edges[e]) * rule.x[n], (edges[e + 1] - edges[e]) * rule.w[n]);
  }
}

/// The albedos at cos theta_o = mu, over the slope r (cos psi, sin psi) of the half vector:
///   int P22 (1 - T r cos psi) G2 r dr dpsi, T = tan theta_o, where the light is above the horizon: r^2 + 2 T r cos psi
/// < 1. i_z = mu at r = -T cos psi, where what compares both directions has a kink; i is the normal at r =
/// tan(theta_o / 2), psi = pi, where azimuths are singular; equal or opposite azimuths are psi = 0 and pi.
Albedos reference(const Lobes& lobes, double mu, int nodes) {
  const GaussLegendre rule(nodes);
  const double sin_o = std::sqrt((1 - mu) * (1 + mu)), tan_o = sin_o / mu;
  double narrowest = infinity;
  for (const Lobe& lobe : lobes) narrowest = std::min(narrowest, lobe.alpha);
  const auto whole_lambda = [&](double sin_theta, double cos_theta) {
    double sum = 0;
    for (const Lobe& lobe : lobes) sum += lobe.weight * lambda_of(lobe.shape, lobe.alpha, sin_theta, cos_theta);
    return sum;
  };
  const double lambda_o = whole_lambda(sin_o, mu);
  Albedos sums{};
  const auto at = [&](double r, double cos_psi, double sin_psi, double weight) {
    const double x = r * cos_psi, y = r * sin_psi;
    const double facing = 1 - tan_o * x; // o.h / (z_h mu)
    const double z2 = 1 / (1 + r * r);
    const double i_x = -2 * mu * facing * z2 * x - sin_o;
    const double i_y = -2 * mu * facing * z2 * y;
    const double i_z = mu * (2 * z2 * facing - 1);
    if (!(i_z > 0 && facing > 0)) return;
    const Albedos g2 = joint(lambda_o, whole_lambda(std::hypot(i_x, i_y), i_z), std::atan2(std::fabs(i_y), i_x));
    double p22 = 0;
    for (const Lobe& lobe : lobes) p22 += lobe.weight * density(lobe.shape, lobe.alpha, r * r);
    weight *= 2 * p22 * facing * r;
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += weight * g2[k];
  };
  sum_over(rule, {0, 0.5 * pi, pi}, 1e-3, [&](double psi, double weight) {
    const double cos_psi = std::cos(psi), sin_psi = std::sin(psi);
    const double along = tan_o * cos_psi;
    const double end = along > 0 ? 1 / (along + std::hypot(1.0, along)) : std::hypot(1.0, along) - along;
    std::vector<double> cuts = {0, end};
    if (along < 0) {
      cuts.push_back(-along);
      cuts.push_back(std::min(sin_o / (1 + mu), end)); // tan(theta_o / 2)
    }
    std::ranges::sort(cuts);
    sum_over(rule, cuts, 0.1 * std::min(narrowest, end),
             [&](double r, double of_r) { at(r, cos_psi, sin_psi, weight * of_r); });
  });
  return sums;
}

struct Worst {
  double difference = 0, disagreement = 0, gain = -1;
};

void compare(const Lobes& lobes, double mu, Worst& worst) {
  const Albedos fine = reference(lobes, mu, 14), coarse = reference(lobes, mu, 11);
  const Direction o{std::sqrt((1 - mu) * (1 + mu)), 0, mu};
  WeightedChoices choices;
  for (const Lobe& lobe : lobes)
    choices.push_back(
        {lobe.weight, describe(shape_names[static_cast<std::size_t>(lobe.shape)], lobe.alpha).distribution});
  TermDescription description = mixture(choices);
  if (lobes.size() == 1) description.distribution = choices.begin()->model;
  for (std::size_t k = 0; k < forms.size(); ++k) {
    const std::string name = description.distribution.type + ", " + forms[k].shadowing + " " + forms[k].lambda;
    INFO(name << ", alpha = " << lobes[0].alpha << ", mu = " << mu);
    CHECK(std::fabs(fine[k] - coarse[k]) < 1e-10);
    const Material m = build(shadowed(description, forms[k].shadowing, forms[k].lambda));
    const Estimate e = compute(Integral::albedo, m, o, 1e-9);
    const double difference = std::fabs(e.value - fine[k]);
    CHECK(difference <= 1e-8);
    CHECK(e.error <= 1e-9);
    CHECK(difference <= e.error + 1e-10);
    CHECK(e.value <= 1 + 1e-9);
    worst.difference = std::max(worst.difference, difference);
    worst.disagreement = std::max(worst.disagreement, std::fabs(fine[k] - coarse[k]));
    worst.gain = std::max(worst.gain, e.value - 1);
  }
}

void compare_grid(const std::vector<double>& alphas, const std::vector<double>& mus) {
  Worst worst;
  for (const Shape shape : {Shape::beckmann, Shape::ggx})
    for (const double alpha : alphas)
      for (const double mu : mus) compare({{shape, alpha}}, mu, worst);
  MESSAGE("largest difference " << worst.difference << ", of the reference to itself " << worst.disagreement
                                << ", albedo - 1 " << worst.gain);
}

} // namespace

TEST_CASE("the reference for albedos is right where the answer is known") {
  const Albedos ggx = reference({{Shape::ggx, 1}}, 1, 14);
  CHECK(std::fabs(ggx[3] - (1 - std::log(2.0))) < 1e-12);
  // Masking alone, of a smooth surface: the weak white furnace, for no light goes below the horizon.
  CHECK(std::fabs(reference({{Shape::beckmann, 0.02}}, 0.9, 14)[0] - 1) < 1e-12);
}

TEST_CASE("albedos to 1e-8 for every G2, at the corners of roughness and angle and between") {
  compare_grid(sample_of<double>({0.3, 0.02, 1}, 3), sample_of<double>({0.02, 0.15, 0.6, 1}, 3));
}

TEST_CASE("albedos to 1e-8 of mixtures of very different widths") {
  Worst worst;
  for (const double mu : sample_of<double>({0.4, 0.05, 1.0}, 3)) {
    compare({{Shape::ggx, 0.01, 0.5}, {Shape::beckmann, 1, 0.5}}, mu, worst);
    compare({{Shape::beckmann, 0.003, 0.2}, {Shape::ggx, 0.6, 0.7}, {Shape::ggx, 0.05, 0.1}}, mu, worst);
  }
  MESSAGE("largest difference " << worst.difference << ", of the reference to itself " << worst.disagreement);
}

// Half a minute; run with --no-skip.
TEST_CASE("albedos to 1e-8 for every G2, on a fine grid" * doctest::skip()) {
  compare_grid({0.02, 0.03, 0.05, 0.08, 0.12, 0.2, 0.3, 0.45, 0.6, 0.8, 1},
               {0.02, 0.03, 0.05, 0.1, 0.15, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95, 1});
}
