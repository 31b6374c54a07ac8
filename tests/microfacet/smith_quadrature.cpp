// Lambda of Phong and GTR, and the shape-invariant ones against their own slopes. The tables were computed with mpmath
// at 40 digits from Lambda(mu) = 2 int_mu^inf r P22(r) (sqrt(r^2 / mu^2 - 1) - arccos(mu / r)) dr.
#include "microfacet/smith_quadrature.hpp"
#include "../materials.hpp"
#include "microfacet/a_lambda_table.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

Material phong(double exponent) {
  MaterialDescription description;
  description.name = "phong";
  description.distribution.type = "phong";
  description.distribution.values.set("exponent", exponent);
  return build(description);
}

} // namespace

TEST_CASE("Lambda of Phong agrees with 40-digit values") {
  struct Row {
    double exponent, theta, lambda;
  };
  const Row rows[] = {
      {1, 0.3, 0.0029718205506226313958},     {1, 1, 0.17742838939286765837},      {1, 1.5, 4.0111565491383794551},
      {1, 1.57, 399.2228559827971636},        {10, 0.3, 5.1136480570501231672e-9}, {10, 1, 0.0056599373287290101185},
      {10, 1.5, 1.2828683288634683957},       {10, 1.57, 154.01857068681010005},   {100, 0.3, 4.461209234281660695e-58},
      {100, 1, 5.2364628834466454687e-11},    {100, 1.5, 0.19783143162433290621},  {100, 1.57, 49.474313194746021424},
      {10000, 1.5, 1.357093727942194005e-14}, {10000, 1.57, 4.5255318684247627046}};
  for (const Row& row : rows) {
    INFO("n = " << row.exponent << ", theta = " << row.theta);
    // cot(1.57) loses three digits to the rounding of theta, which Lambda ~ 1 / mu inherits.
    CHECK(relative(lambda(phong(row.exponent), from_angles(row.theta, 0.4)), row.lambda) < 2e-12);
  }
  CHECK(lambda(phong(10000), from_angles(0.3, 0)) == 0); // 3e-5302
}

TEST_CASE("Lambda of GTR agrees with 40-digit values") {
  struct Row {
    double gamma, alpha, theta, lambda;
  };
  const Row rows[] = {{0.5, 0.05, 0.7, 0.083391848858870623959},    {0.5, 0.05, 1.5, 4.2346522082433601192},
                      {0.5, 0.4, 0.7, 0.11055755746985848036},      {0.5, 0.4, 1.5, 5.306816259227911575},
                      {0.5, 1, 0.7, 0.15372962986679693494},        {0.5, 1, 1.5, 6.568416451484951541},
                      {0.5, 1.5, 0.7, 0.18591375221794358414},      {0.5, 1.5, 1.5, 7.3548611879492190722},
                      {1, 0.05, 0.7, 0.027374959749103262687},      {1, 0.05, 1.5, 1.8351515623468104035},
                      {1, 0.4, 0.7, 0.074468505197805381216},       {1, 0.4, 1.5, 4.1458087066974285667},
                      {1, 1, 0.7, 0.15372962986679693494},          {1, 1, 1.5, 6.568416451484951541},
                      {1, 1.5, 0.7, 0.22213334884554212434},        {1, 1.5, 1.5, 8.2091571332545232312},
                      {1.5, 0.05, 0.7, 0.0044769350211326394234},   {1.5, 0.05, 1.5, 0.48730230248616716816},
                      {1.5, 0.4, 0.7, 0.046854274599315466297},     {1.5, 0.4, 1.5, 3.1528039363858870107},
                      {1.5, 1, 0.7, 0.15372962986679693494},        {1.5, 1, 1.5, 6.568416451484951541},
                      {1.5, 1.5, 0.7, 0.26216733998277035601},      {1.5, 1.5, 1.5, 9.1235250622667689197},
                      {2.7, 0.05, 0.7, 0.000012017535820073518065}, {2.7, 0.05, 1.5, 0.019813846597106876947},
                      {2.7, 0.4, 0.7, 0.011977800603203409947},     {2.7, 0.4, 1.5, 1.5916887956436648659},
                      {2.7, 1, 0.7, 0.15372962986679693494},        {2.7, 1, 1.5, 6.568416451484951541},
                      {2.7, 1.5, 0.7, 0.37135600804924552333},      {2.7, 1.5, 1.5, 11.499693741085728944},
                      {10, 0.05, 0.7, 1.7922289288954030395e-23},   {10, 0.05, 1.5, 4.8481979227435591802e-7},
                      {10, 0.4, 0.7, 1.9375732031030845669e-7},     {10, 0.4, 1.5, 0.2459308979497169407},
                      {10, 1, 0.7, 0.15372962986679693494},         {10, 1, 1.5, 6.568416451484951541},
                      {10, 1.5, 0.7, 1.0938677948411841264},        {10, 1.5, 1.5, 25.18799400881196107}};
  for (const Row& row : rows) {
    INFO("gamma = " << row.gamma << ", alpha = " << row.alpha << ", theta = " << row.theta);
    CHECK(relative(lambda(gtr(row.alpha, row.gamma), from_angles(row.theta, 0)), row.lambda) < 2e-12);
  }
}

TEST_CASE("Lambda of GTR agrees with the closed forms of Dimov 2015") {
  for (const double alpha : {0.05, 0.3, 0.8, 0.95}) {
    for (const double theta : {0.2, 0.9, 1.4, 1.55}) {
      INFO("alpha = " << alpha << ", theta = " << theta);
      const double mu = 1 / std::tan(theta);
      const double alpha2 = alpha * alpha;
      const double a = std::hypot(mu, alpha);
      const double b = std::hypot(mu, 1.0);
      const Direction o = from_angles(theta, 0);
      const double one = (a - b + mu * (std::log(mu + b) - std::log(mu + a))) / (mu * std::log(alpha2));
      CHECK(relative(lambda(gtr(alpha, 1), o), one) < 1e-9 * (1 + 1 / one)); // the closed form cancels
      CHECK(relative(lambda(gtr(alpha, 2), o), lambda(material("ggx", alpha), o)) < 1e-12);
      const double three = 4 * mu * a * (alpha2 + 1) / (2 * mu * (alpha2 + 1) * (mu + a) + alpha2 * (3 * alpha2 + 1));
      CHECK(g1(gtr(alpha, 3), o) == doctest::Approx(three).epsilon(1e-12));
    }
  }
}

TEST_CASE("Lambda of Beckmann and GGX is that of their own slopes") {
  for (const double theta : {0.05, 0.5, 1.0, 1.4, 1.56}) {
    const double mu = 1 / std::tan(theta);
    const Direction o = from_angles(theta, 1.1);
    for (const double alpha : {0.1, 0.5, 2.0}) {
      INFO("alpha = " << alpha << ", theta = " << theta);
      const double a2 = alpha * alpha;
      const auto beckmann = [&](double r2) { return -r2 / a2 - std::log(std::numbers::pi * a2); };
      const auto ggx = [&](double r2) { return -std::log(std::numbers::pi * a2) - 2 * std::log1p(r2 / a2); };
      const double exact = lambda(material("beckmann", alpha), o);
      if (exact > 1e-280) CHECK(relative(a_lambda_by_quadrature(beckmann, mu) / mu, exact) < 1e-11);
      CHECK(relative(a_lambda_by_quadrature(ggx, mu) / mu, lambda(material("ggx", alpha), o)) < 1e-11);
    }
  }
}

TEST_CASE("a Lambda(a) by quadrature is finite at both ends, and the table is as good") {
  const LogDensity beckmann = [](double t2) { return -t2 - std::log(std::numbers::pi); };
  const LogDensity ggx = [](double t2) { return -std::log(std::numbers::pi) - 2 * std::log1p(t2); };
  // A density with a hole and a kink: t^2 exp(-t^2) cut at t^2 = 3, normalised.
  const double norm = std::log(std::numbers::pi * (1 - 4 * std::exp(-3.0)));
  const LogDensity cut = [norm](double t2) { return t2 < 3 && t2 > 0 ? std::log(t2) - t2 - norm : -infinity; };
  CHECK(relative(a_lambda_by_quadrature(beckmann, 0), 0.5 / std::sqrt(std::numbers::pi)) < 1e-13);
  CHECK(relative(a_lambda_by_quadrature(ggx, 0), 0.5) < 1e-13);
  CHECK(a_lambda_by_quadrature(ggx, infinity) == 0);
  CHECK(a_lambda_by_quadrature(cut, 2) == 0);
  CHECK(a_lambda_by_quadrature(cut, 1.7) > 0);
  const ALambdaTable beckmann_table(beckmann), ggx_table(ggx), cut_table(cut);
  for (double a = 0; a < 300; a = 1.013 * a + 1e-3) {
    INFO("a = " << a);
    CHECK(relative(ggx_table(a), GgxShape::a_lambda(a)) < 1e-11);
    if (a < 26) CHECK(relative(beckmann_table(a), BeckmannShape::a_lambda(a)) < 1e-11);
    CHECK(relative(cut_table(a), a_lambda_by_quadrature(cut, a)) < 1e-10);
  }
  CHECK(relative(ggx_table(1e60), GgxShape::a_lambda(1e60)) < 1e-10);
  CHECK(ggx_table(infinity) == 0);
}
