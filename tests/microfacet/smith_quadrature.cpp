// Lambda of Phong and GTR, and the shape-invariant ones against their own slopes. The tables were computed with mpmath
// at 40 digits from Lambda(mu) = 2 int_mu^inf r P22(r) (sqrt(r^2 / mu^2 - 1) - arccos(mu / r)) dr.
#include "microfacet/smith_quadrature.hpp"
#include "../materials.hpp"
#include "base/errors.hpp"
#include "microfacet/a_lambda_table.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

Material phong(double exponent) {
  TermDescription description;
  description.name = "phong";
  description.distribution.type = "phong";
  description.distribution.values.set("exponent", exponent);
  return build(description);
}

} // namespace

TEST_CASE("a density that is no number is no Lambda") {
  for (const double a : {0.0, 0.1, 3.0})
    CHECK_THROWS_AS(a_lambda_by_quadrature([](double t2) { return t2 > 1 ? std::nan("") : -t2; }, a), AccuracyError);
}

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

TEST_CASE("a Lambda(a) of GTR in closed form agrees with 40-digit values and with the quadrature") {
  struct Row {
    double alpha, a, one, three, four;
  };
  const Row rows[] = {
      {0.01, 0.001, 10.748288480849420169, 0.2495503699753462186, 0.18701922434585067952},
      {0.01, 1.0, 10.298966818744303504, 0.030365437693789582784, 0.008239632743762585131},
      {0.01, 50.0, 4.0973304294810671135, 1.4995001649430204341e-6, 3.9977510794992265871e-10},
      {0.01, 10000.0, 0.027140351497189970925, 4.9995625249968756456e-9, 7.4994374468834380658e-13},
      {0.3, 0.001, 0.96851428128173050494, 0.29078475802738216471, 0.207900178839913173},
      {0.3, 1.0, 0.60118315679248731352, 0.059522567682015814344, 0.017578128894933091212},
      {0.3, 50.0, 0.020982611389921927624, 0.00082602278537956488814, 0.00011074650401214874668},
      {0.3, 10000.0, 0.00010497652980314827074, 4.1284404088302744788e-6, 5.5322831603451418562e-7},
      {0.999999, 0.001, 0.4995005000000208408, 0.4994999999999374928, 0.49949975000002081921},
      {0.999999, 1.0, 0.20710695796341960299, 0.20710660440976383433, 0.20710642763306853282},
      {0.999999, 50.0, 0.0049995050989811385491, 0.004999495100972207454, 0.0049994901019727399173},
      {0.999999, 10000.0, 0.000025000024937529042731, 0.000024999974937487624594, 0.000024999949937491915575},
      {3.0, 0.001, 0.30291353066139939974, 0.69950015000001249996, 0.87312648076924244504},
      {3.0, 1.0, 0.090378377602528708648, 0.34852813742385702928, 0.48684133198562127032},
      {3.0, 50.0, 0.0020226414768823638597, 0.0089987003398950349878, 0.013349127185416872889},
      {3.0, 10000.0, 0.000010113769170695736109, 0.000044999999837500001062, 0.000066758241442994508032},
  };
  for (const Row& row : rows) {
    INFO("alpha = " << row.alpha << ", a = " << row.a);
    CHECK(relative(gtr_a_lambda_closed(row.alpha, 1, row.a), row.one) < 1e-14);
    CHECK(relative(gtr_a_lambda_closed(row.alpha, 3, row.a), row.three) < 1e-14);
    CHECK(relative(gtr_a_lambda_closed(row.alpha, 4, row.a), row.four) < 1e-14);
  }
  for (const double alpha : {1e-3, 0.05, 0.3, 0.8, 0.999999, 1.0, 1.7, 30.0})
    for (const int gamma : {1, 2, 3, 4})
      for (const double a : {0.0, 1e-9, 0.01, 0.7, 3.0, 40.0, 1e6}) {
        INFO("alpha = " << alpha << ", gamma = " << gamma << ", a = " << a);
        const double alpha2 = alpha * alpha;
        const double log_k = gtr_log_normalization(alpha, gamma);
        const auto density = [&](double t2) {
          return log_k - std::log(std::numbers::pi) + (gamma - 2) * std::log1p(alpha2 * t2) -
                 gamma * std::log(alpha2 * (t2 + 1)) + std::log(alpha2);
        };
        CHECK(relative(gtr_a_lambda_closed(alpha, gamma, a), a_lambda_by_quadrature(density, a)) < 1e-11);
      }
  CHECK(gtr_a_lambda_closed(0.3, 1, infinity) == 0);
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
