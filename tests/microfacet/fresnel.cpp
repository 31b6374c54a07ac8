#include "microfacet/fresnel.hpp"

#include "models/registry.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
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

using Real = boost::multiprecision::cpp_bin_float_50;

/// A Fresnel term that is good, of one number a key.
Fresnel fresnel(const std::string& type, const std::vector<std::pair<std::string, double>>& values) {
  ModelChoice choice{.type = type, .values = {}};
  for (const auto& [key, value] : values) choice.values.set(key, value);
  return std::get<Fresnel>(make_model<Fresnel>(choice));
}

double reflectance(const Fresnel& of, double c) {
  double f = 0;
  std::visit([&](const auto& one) { one.reflectances(&c, 0, &f, 1); }, of);
  return f;
}

std::string problem_with_f82(double f0, double f82) {
  ModelChoice choice{.type = "f82", .values = {}};
  choice.values.set("f0", f0);
  choice.values.set("f82", f82);
  const auto made = make_model<Fresnel>(choice);
  const auto* error = std::get_if<ParameterError>(&made);
  return error != nullptr ? error->key + ": " + error->what : "";
}

/// As published: Schlick's less a c (1 - c)^6, a from the value at c = 1/7.
Real f82_of(double f0, double f82, const Real& c) {
  const auto schlick = [f0](const Real& x) -> Real { return f0 + (1 - Real(f0)) * pow(Real(1 - x), 5); };
  const Real seventh = Real(1) / 7;
  const Real a = schlick(seventh) * (1 - Real(f82)) / (seventh * pow(Real(1 - seventh), 6));
  return schlick(c) - a * c * pow(Real(1 - c), 6);
}

/// Of Fresnel's equations, in real numbers: p = sqrt(n^2 - sin^2) = q + i y.
Real fresnel_of(double eta, double k, const Real& c) {
  const Real n = eta, s2 = 1 - c * c, t = n * n - Real(k) * k - s2, w = sqrt(Real(t * t + 4 * n * n * Real(k) * k));
  const Real q = t > 0 ? sqrt(Real((w + t) / 2)) : k == 0 ? Real(0) : Real(n * k / sqrt(Real((w - t) / 2)));
  const Real y2 = w - q * q;
  const Real s = ((c - q) * (c - q) + y2) / ((c + q) * (c + q) + y2), a = c * q;
  const Real p = ((a - s2) * (a - s2) + c * c * y2) / ((a + s2) * (a + s2) + c * c * y2);
  return s * (1 + p) / 2;
}

/// 2 int F c dc, cut where F is not smooth.
template <class F>
Real mean_of(const F& f, const Real& cut) {
  boost::math::quadrature::tanh_sinh<Real> rule(12);
  // Over [-1, 1], the rule's own range: other ends lose a digit more than its assertions like.
  const auto part = [&](const Real& from, const Real& to) -> Real {
    const Real half = (to - from) / 2;
    const auto integrand = [&](const Real& x) -> Real {
      const Real c = from + half * (1 + x);
      return 2 * f(c) * c;
    };
    return from < to ? Real(half * rule.integrate(integrand, Real(1e-25))) : Real(0);
  };
  return part(0, cut) + part(cut, 1);
}

double relative_to(double is, const Real& exact) {
  return std::fabs(static_cast<double>(Real((Real(is) - exact) / exact)));
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

TEST_CASE("f82 is as published, with 50 digits, at both ends of its parameters") {
  for (const double f0 : {0.0, 0.04, 0.5, 0.9, 1 - 1e-9, 1.0})
    for (const double share : {0.0, 0.3, 1.0}) {
      const double least = F82Fresnel::least_f82(f0), f82 = least + share * (1 - least);
      const Fresnel of = fresnel("f82", {{"f0", f0}, {"f82", f82}});
      INFO("f0 = " << f0 << ", f82 = " << f82);
      for (const double c : {0.0, 1e-12, 0.01, 1.0 / 7, 0.2, 0.5, 0.9, 1 - 1e-12, 1.0}) {
        CHECK(std::fabs(static_cast<double>(Real(reflectance(of, c) - f82_of(f0, f82, c)))) < 1e-15);
        CHECK(reflectance(of, c) >= 0);
      }
      CHECK(reflectance(of, 1) == f0);
      CHECK(reflectance(of, 0) == 1);
      CHECK(reflectance(of, 1.0 / 7) == doctest::Approx(f82 * schlick_reflectance(1.0 / 7, f0, 1, 5)).epsilon(1e-14));
      if (f82 == 1) CHECK(std::fabs(reflectance(of, 0.3) - schlick_reflectance(0.3, f0, 1, 5)) < 3e-16);
    }
}

TEST_CASE("f82 is refused from where its reflectance would be negative") {
  for (const double f0 : {0.0, 1e-6, 0.04, 0.5, 0.95, 0.9999}) {
    const double least = F82Fresnel::least_f82(f0);
    Real lowest = 1;
    for (int k = 0; k <= 20000; ++k) {
      const Real f = f82_of(f0, least, Real(k) / 20000);
      if (f < lowest) lowest = f;
    }
    INFO("f0 = " << f0 << ", least f82 = " << least);
    CHECK(std::fabs(static_cast<double>(lowest)) < 1e-8);
    CHECK(problem_with_f82(f0, least).empty());
    if (least > 0) CHECK(!problem_with_f82(f0, 0.99 * least).empty());
  }
  CHECK(F82Fresnel::least_f82(0) == doctest::Approx(1 - 4 * (46656.0 / 823543) / (7776.0 / 16807)));
  CHECK(F82Fresnel::least_f82(1) == 0);
  CHECK(problem_with_f82(0, 0.25).find("f82: found 0.25 with f0 = 0, where the reflectance falls below 0; accepted: a "
                                       "number in [0.51") == 0);
}

TEST_CASE("mean reflectances: closed forms, with 50 digits") {
  CHECK(mean_fresnel(NoFresnel{}, 0) == 1);
  for (const double f0 : {0.0, 0.04, 0.9, 1.0}) {
    for (const double f90 : {0.0, 0.5, 1.0})
      for (const double exponent : {1e-3, 0.5, 5.0, 7.3, 1e3}) {
        const Real n = exponent, exact = f0 + (Real(f90) - f0) * 2 / ((n + 1) * (n + 2));
        const double mean = mean_fresnel(fresnel("schlick", {{"f0", f0}, {"f90", f90}, {"exponent", exponent}}), 0);
        INFO("f0 = " << f0 << ", f90 = " << f90 << ", exponent = " << exponent);
        CHECK((exact == 0 ? std::fabs(mean) : relative_to(mean, exact)) < 1e-15);
      }
    for (const double share : {0.0, 0.5, 1.0}) {
      const double least = F82Fresnel::least_f82(f0), f82 = least + share * (1 - least);
      const Real exact = mean_of([&](const Real& c) { return f82_of(f0, f82, c); }, 0);
      CHECK(relative_to(mean_fresnel(fresnel("f82", {{"f0", f0}, {"f82", f82}}), 0), exact) < 2e-15);
    }
  }
  // RTR4, Eq. 9.60.
  CHECK(mean_fresnel(fresnel("schlick", {{"f0", 0.04}}), 0) == doctest::Approx(20.0 / 21 * 0.04 + 1.0 / 21));
}

TEST_CASE("mean reflectances: by quadrature, against tanh-sinh with 50 digits, over the whole domain") {
  for (const double eta : {1e-6, 0.05, 0.5, 1 / 1.5, 0.99, 1 + 1e-6, 1.01, 1.5, 3.0, 1e3, 1e6}) {
    const Real cut = eta < 1 ? Real(sqrt(Real((1 - Real(eta)) * (1 + Real(eta))))) : Real(sqrt(Real(eta) * eta - 1));
    const Real exact = mean_of([&](const Real& c) { return fresnel_of(eta, 0, c); }, cut < 1 ? cut : Real(0));
    INFO("eta = " << eta);
    CHECK(relative_to(mean_fresnel(fresnel("dielectric", {{"eta", eta}}), 0), exact) < 1e-12);
  }
  for (const double eta : {0.05, 0.2, 1.0, 3.0, 1e3})
    for (const double k : {0.0, 1e-6, 0.01, 0.5, 3.0, 1e3}) {
      if (eta == 1 && k < 1e-3) continue; // the reflectance is of the order of k^2
      const Real square = 1 - (Real(eta) - k) * (Real(eta) + k);
      const Real cut = square > 0 && square < 1 ? Real(sqrt(square)) : Real(0);
      const Real exact = mean_of([&](const Real& c) { return fresnel_of(eta, k, c); }, cut);
      INFO("eta = " << eta << ", k = " << k);
      CHECK(relative_to(mean_fresnel(fresnel("conductor", {{"eta", eta}, {"k", k}}), 0), exact) < 1e-12);
    }
  // Kulla and Conty 2017: (eta - 1) / (4.08567 + 1.00071 eta), off by 0.0065.
  CHECK(mean_fresnel(fresnel("dielectric", {{"eta", 1.5}}), 0) ==
        doctest::Approx(0.5 / (4.08567 + 1.00071 * 1.5)).epsilon(0.07));
  // Stern 1964: 1 - F(1 / eta) = eta^2 (1 - F(eta)).
  CHECK(1 - mean_fresnel(fresnel("dielectric", {{"eta", 1 / 1.5}}), 0) ==
        doctest::Approx((1 - mean_fresnel(fresnel("dielectric", {{"eta", 1.5}}), 0)) / 2.25).epsilon(1e-12));
  // No interface.
  CHECK(mean_fresnel(fresnel("dielectric", {{"eta", 1.0}}), 0) == 0);
}
