#include "microfacet/fresnel.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>

using namespace brdfplot;

namespace {

/// Fresnel's equations as they stand, in complex arithmetic and long double.
double reference(double c, double eta, double k) {
  using Complex = std::complex<long double>;
  const Complex n(eta, k);
  const long double cosine = c;
  const Complex transmitted = std::sqrt(Complex(1) - (1 - cosine * cosine) / (n * n));
  const Complex s = (cosine - n * transmitted) / (cosine + n * transmitted);
  const Complex p = (n * cosine - transmitted) / (n * cosine + transmitted);
  return static_cast<double>((std::norm(s) + std::norm(p)) / 2);
}

} // namespace

TEST_CASE("conductor reflectance is Fresnel's, down to eta -> 1 and k -> 0") {
  for (const double eta : {0.05, 0.35, 1.0, 1.5, 4.0, 30.0})
    for (const double k : {0.0, 1e-8, 0.3, 2.714, 20.0})
      for (const double c : {1e-9, 0.01, 0.1, 0.5, 0.9, 1.0}) {
        if (eta == 1 && k < 1e-3) continue; // F ~ k^2 there: see below
        INFO("eta = " << eta << ", k = " << k << ", c = " << c);
        CHECK(conductor_reflectance(c, eta, k) == doctest::Approx(reference(c, eta, k)).epsilon(1e-12));
      }
  CHECK(conductor_reflectance(0, 0.35, 2.7) == doctest::Approx(1));
  CHECK(conductor_reflectance(0.5, 1, 0) < 1e-30);
  CHECK(conductor_reflectance(0, 1, 0) == 0);
}

TEST_CASE("dielectric reflectance is Fresnel's, with total internal reflection") {
  for (const double eta : {1.01, 1.33, 1.5, 2.4, 10.0})
    for (const double c : {0.0, 1e-9, 0.01, 0.3, 0.7, 1.0})
      CHECK(dielectric_reflectance(c, eta) == doctest::Approx(reference(c, eta, 0)).epsilon(1e-12));
  CHECK(dielectric_reflectance(1, 1.5) == doctest::Approx(0.04));
  CHECK(dielectric_reflectance(0.5, 1 / 1.5) == 1);
  CHECK(dielectric_reflectance(0.9, 1 / 1.5) < 1);
  CHECK(dielectric_reflectance(0.7, 1.0) == 0);
  CHECK(dielectric_reflectance(0, 1.0) == 0); // no interface, at grazing too
}

TEST_CASE("metals reflect at the normal what is published of them") {
  CHECK(conductor_reflectance(1, 0.350, 2.714) == doctest::Approx(0.848).epsilon(1e-3)); // gold, 550 nm
  CHECK(conductor_reflectance(1, 0.125, 3.340) == doctest::Approx(0.960).epsilon(1e-3)); // silver, 550 nm
  CHECK(conductor_reflectance(1, 3.116, 4.423) == doctest::Approx(0.659).epsilon(1e-3)); // chromium, 550 nm
}

TEST_CASE("Schlick's term runs from f0 to f90") {
  CHECK(schlick_reflectance(1, 0.04, 1, 5) == 0.04);
  CHECK(schlick_reflectance(0, 0.04, 0.9, 5) == 0.9);
  CHECK(schlick_reflectance(0.25, 0.04, 1, 5) == doctest::Approx(0.04 + 0.96 * std::pow(0.75, 5)).epsilon(1e-15));
  CHECK(schlick_reflectance(0.25, 0.04, 1, 3.5) == doctest::Approx(0.04 + 0.96 * std::pow(0.75, 3.5)).epsilon(1e-15));
  // 1 - (1 - c)^n without the rounding of 1 - c.
  CHECK(schlick_reflectance(1e-12, 0.3, 0, 5) == doctest::Approx(0.3 * 5e-12).epsilon(1e-11));
  CHECK(schlick_reflectance(1e-12, 0.3, 0, 0.5) == doctest::Approx(0.3 * 5e-13).epsilon(1e-11));
  double worst = 0;
  for (int k = 0; k <= 1000; ++k)
    worst = std::max(worst,
                     std::fabs(schlick_reflectance(k / 1000.0, 0.04, 1, 5) - dielectric_reflectance(k / 1000.0, 1.5)));
  CHECK(worst == doctest::Approx(0.036).epsilon(0.03));
}
