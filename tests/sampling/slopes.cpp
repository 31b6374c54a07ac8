#include "materials.hpp"

#include "base/random.hpp"
#include "sampling/facets.hpp"
#include "sampling/radial_slopes.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <doctest/doctest.h>

using namespace test;

namespace {

std::vector<Component> components_of(const TermDescription& description) {
  return components(*build(description).terms.front().facets());
}

/// f at a norm r in the frame.
double density_at(const Component& component, double r) {
  const Vec2 slope = component.frame.slope(r, 0);
  return component.frame.determinant() *
         std::visit([&](const auto& d) { return d.p22(slope[0], slope[1]); }, component.distribution);
}

/// 2 pi int_0^r f r dr of a component, r in its frame, by quadrature of its own density.
double ground_within(const Component& component, double r) {
  const auto integrand = [&](double x) {
    return 2 * std::numbers::pi * density_at(component, std::exp(x)) * std::exp(2 * x);
  };
  double sum = 0;
  for (int k = 1; k <= 160; ++k)
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, std::log(r) - k / 4.0,
                                                                         std::log(r) - (k - 1) / 4.0, 2, 1e-13);
  return sum;
}

} // namespace

TEST_CASE("a share u of the ground has slopes within the norm that is said, for every distribution") {
  for (const TermDescription& description : every_distribution())
    for (const Component& component : components_of(description)) {
      const RadialSlopes slopes(component);
      double last = 0;
      for (const double u : {1e-6, 0.01, 0.3, 0.5, 0.9, 0.999}) {
        CAPTURE(description.name);
        CAPTURE(u);
        const double r = slopes.within(u);
        CHECK(r > last);
        last = r;
        CHECK(std::fabs(ground_within(component, r) - u) < 2e-10);
      }
      CHECK(std::isfinite(slopes.within(0)));
      CHECK(std::isfinite(slopes.within(1 - 0x1p-53)));
    }
}

TEST_CASE("a share u of what is seen has slopes within the norm that is said, to 1e-7, at any angle") {
  for (const TermDescription& description :
       {test::distribution("student_t", {{"alpha", 1}, {"gamma", 2}}),
        test::distribution("student_t", {{"alpha", 1}, {"gamma", 1.7}}),
        test::distribution("exponential_power", {{"alpha", 1}, {"p", 0.4}}),
        test::distribution("exponential_power", {{"alpha", 1}, {"p", 10}}),
        test::distribution("ward", {{"alpha", 0.3}}), test::distribution("gtr", {{"alpha", 0.01}, {"gamma", 1.5}})}) {
    const Component component = components_of(description)[0];
    const RadialSlopes slopes(component);
    for (const double theta : {0.0, 0.3, 1.0, 1.4, 89.9 * degree, 0.5 * std::numbers::pi}) {
      const double c = std::cos(theta), s = std::sin(theta);
      const auto seen = [&](double x) {
        const double r = std::exp(x), k = s * r;
        const double facing =
            k > c ? 2 * (c * std::acos(-c / k) + std::sqrt((k - c) * (k + c))) : 2 * std::numbers::pi * c;
        return density_at(component, r) * r * r * facing;
      };
      for (const double u : {1e-3, 0.1, 0.5, 0.9, 0.99}) {
        const UnitSlope slope = RadialSlopes::Viewer(slopes, c, s)(u, 0.5);
        const double end = std::log(std::hypot(slope.facing, slope.across));
        const double kink = s > 0 ? std::min(end, std::log(c / s)) : end;
        double sum = 0;
        for (int k = 1; k <= 320; ++k)
          sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(seen, kink - k / 8.0,
                                                                               kink - (k - 1) / 8.0, 2, 1e-13);
        // From the kink on in the root of the distance.
        const double root = std::sqrt(end - kink);
        for (int k = 0; root > 0 && k < 64; ++k)
          sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
              [&](double q) { return seen(kink + q * q) * 2 * q; }, root * k / 64, root * (k + 1) / 64, 2, 1e-13);
        CAPTURE(description.name);
        CAPTURE(theta);
        CAPTURE(u);
        CHECK(std::fabs(sum / visible_area(component, {c, s}) - u) < 1e-7);
      }
    }
  }
}

TEST_CASE("visible slopes of a Gaussian by inversion have their share below them, at any angle") {
  for (const double a : {infinity, 30.0, 2.0, 0.5, 1e-3, 0.0}) {
    const double c = a < infinity ? a / std::hypot(1.0, a) : 1, s = a < infinity ? 1 / std::hypot(1.0, a) : 0;
    const auto beyond = [&](double x) {
      return 0.5 * (c * std::sqrt(std::numbers::pi) * std::erfc(x) + s * std::exp(-x * x));
    };
    const double whole = a < infinity ? beyond(-std::min(a, 9.0)) : c * std::sqrt(std::numbers::pi);
    for (const double u : {0.0, 1e-9, 0.01, 0.3, 0.5, 0.9, 0.999, 1 - 1e-12, 1 - 0x1p-53}) {
      CAPTURE(a);
      CAPTURE(u);
      const double x = visible_gaussian(c, s, u);
      CHECK(std::isfinite(x));
      CHECK(x >= -a);
      CHECK(std::fabs(beyond(x) / whole - (1 - u)) < 1e-14);
      CHECK(std::fabs(beyond(x) / whole / (1 - u) - 1) < 1e-8);
    }
  }
  CHECK(gaussian(0.5) == 0);
  CHECK(gaussian(0.975) == doctest::Approx(1.959963984540054 / std::numbers::sqrt2));
  CHECK(std::isfinite(gaussian(0)));
}

TEST_CASE("visible normals by table and by closed form have the same distribution") {
  // Student's t with gamma = 2 is GGX: the same norms are within a share of the visible facets.
  const Facets by_table(*build(test::distribution("student_t", {{"alpha", 0.3}, {"gamma", 2}})).terms[0].facets());
  for (const double theta : {0.0, 0.5, 1.2, 1.5, 89.9 * degree, 0.5 * std::numbers::pi}) {
    CAPTURE(theta);
    const Direction o = from_angles(theta, 0.4);
    const Facets::Viewer viewer(by_table, o);
    constexpr int n = 20000;
    std::array<double, 20> counts{};
    for (int k = 0; k < n; ++k) {
      const double u1 = (k + 0.5) / n, u2 = std::fmod(0.5 + 0.6180339887498949 * k, 1.0);
      const Direction m = viewer.normal({u1, u2, 0.5});
      CHECK(dot(o, m) >= -1e-14);
      // In the space of unit roughness the normal mirrors w into the cap, whose heights from -w.z to 1 are uniform.
      const Direction w = normalized({0.3 * o.x, 0.3 * o.y, o.z});
      const Direction flat = normalized({m.x / 0.3, m.y / 0.3, m.z});
      const double z = 2 * dot(w, flat) * flat.z - w.z;
      const auto bin = static_cast<std::size_t>(std::min(19.0, 20 * (z + w.z) / (1 + w.z)));
      counts[bin] += 1;
    }
    for (const double count : counts) CHECK(count == doctest::Approx(n / 20.0).epsilon(0.03));
  }
}
