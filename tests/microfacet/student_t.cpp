// Student's t: its Lambda against the incomplete beta function in multiprecision.
#include "microfacet/distributions/student_t.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace brdfplot;

namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<70>>;

/// a Lambda(a) by its definition, with 70 digits, of which cancellation leaves 30 where the result is above 1e-40.
Real exact(double excess, double a) {
  const Real half = Real(1) / 2, e = excess, g = e + half, a2 = Real(a) * a;
  const Real scale = sqrt(g / boost::math::constants::pi<Real>()) / (boost::math::tgamma_delta_ratio(g, half) * 2 * e);
  return scale * pow(g / (g + a2), e) - a * half * boost::math::ibetac(half, g, a2 / (g + a2));
}

} // namespace

TEST_CASE("Student's Lambda is exact over its whole domain") {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> uniform;
  const auto between = [&](double low, double high) { return low + (high - low) * uniform(generator); };
  double worst = 0;
  int compared = 0;
  for (int k = 0; k < 2000; ++k) {
    const double excess = std::pow(10, between(-4, k % 3 == 0 ? 12 : 5));
    // Both forms, on both sides of where one takes over; and where the continued fraction ends after few steps.
    const double a = k % 4 == 1 ? between(0.9, 1.4) : k % 4 == 3 ? between(1, 20) : std::pow(10, between(-3, 2));
    const Real expected = exact(excess, a);
    if (expected < 1e-40) continue;
    const double error = std::fabs(static_cast<double>(StudentTShape::of_excess(excess).a_lambda(a) / expected - 1));
    const double bound = 1e-13 + 0x1p-52 * excess * std::log1p(a * a / (excess + 0.5));
    worst = std::max(worst, error / bound);
    ++compared;
    INFO("excess " << excess << ", a " << a);
    CHECK(error <= bound);
  }
  CHECK(compared > 1000);
  CHECK(worst > 1e-3); // it compares something
}
