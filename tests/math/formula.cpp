#include "math/formula.hpp"
#include "base/errors.hpp"
#include "base/threads/parallel.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace brdfplot;

namespace {

double value(const std::string& text) { return Formula(text, {})({}); }

} // namespace

TEST_CASE("formulas mean what a reader of mathematics expects") {
  CHECK(value("2 + 3 * 4 ^ 2") == 50);
  CHECK(value("-2 ^ 2") == -4);
  CHECK(value("2 ^ 3 ^ 2") == 512);
  CHECK(value("pi") == std::numbers::pi);
  CHECK(value("log(exp(2))") == doctest::Approx(2));
  CHECK(value("ln(exp(2))") == doctest::Approx(2));
  CHECK(value("erf(0.5) + erfc(0.5)") == doctest::Approx(1));
  CHECK(value("pow(2, 10)") == 1024);
  CHECK(value("gamma(5)") == doctest::Approx(24));
  CHECK(value("hypot(3, 4)") == 5);
  CHECK(value("expm1(1e-20)") == 1e-20);
  CHECK(value("log1p(1e-20)") == 1e-20);
  CHECK(value("1 < 2 ? 3 : 4") == 3);
  CHECK(value("1/0") == HUGE_VAL);
  const std::vector<double> x = {3, 0.25};
  CHECK(Formula("x / sqrt(y)", {"x", "y"})(x) == 6);
}

TEST_CASE("a formula that is none is refused, with the name that it does not know") {
  const auto problem = [](const std::string& text) { return Formula::problem(text, {"t", "t2"}); };
  CHECK_FALSE(problem("exp(-t2) * t").has_value());
  CHECK(problem("exp(-t3)").value().unknown == "t3");
  CHECK(problem("exq(t)").value().unknown == "exq");
  for (const char* text : {"", "exp(", "1 +", "t, t2", "exp()", "t t2", "_pi", "2 $ 3", "\"t\"", "\n"}) {
    INFO(text);
    REQUIRE(problem(text).has_value());
    CHECK_FALSE(problem(text)->what.empty());
    CHECK(problem(text)->what.find('\n') == std::string::npos);
    CHECK_THROWS_AS(Formula(text, {"t", "t2"}), InputError);
  }
  CHECK(problem("t = 3")->what == "assignment at position 2; == compares");
  for (const char* text : {"t == 3", "t <= t2", "t >= t2", "t != 2"}) CHECK_FALSE(problem(text).has_value());
  CHECK(problem("(t")->what.find("at position") != std::string::npos);
  const auto names = names_in_formulas();
  for (const char* name : {"pi", "exp", "erf", "sqrt"}) CHECK(std::ranges::find(names, name) != names.end());
  CHECK(std::ranges::find(names, "_pi") == names.end());
}

TEST_CASE("many threads evaluate many formulas at once") {
  const std::vector<std::string> variables = {"x"};
  std::vector<Formula> formulas;
  for (int k = 0; k < 20; ++k) formulas.emplace_back("x + " + std::to_string(k), variables);
  std::vector<double> sums(64);
  parallel_for(sums.size(), 8, [&](std::size_t task) {
    for (int repeat = 0; repeat < 200; ++repeat)
      for (const Formula& formula : formulas) {
        const double x = static_cast<double>(task);
        sums[task] += formula(std::span(&x, 1)) - x;
      }
  });
  for (const double sum : sums) CHECK(sum == 200 * 190);
}
