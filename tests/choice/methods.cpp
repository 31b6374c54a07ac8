#include "choice/methods/problems.hpp"

#include <doctest/doctest.h>

using namespace brdfplot;
using choice::Counted;

namespace {

choice::Operations operations_of(Counted (*formula)(Counted, Counted)) {
  return choice::counted([&] { return formula(Counted(0.5), Counted(2.0)); });
}

} // namespace

TEST_CASE("choice: a product that is added is one operation") {
  const auto fused = operations_of([](Counted x, Counted y) { return x * y + 1.0; });
  CHECK(fused.multiply_adds == 1);
  const auto polynomial = operations_of([](Counted x, Counted y) { return (x * y + 2.0) * y + 3.0; });
  CHECK(polynomial.multiply_adds == 2);
  const auto apart = operations_of([](Counted x, Counted y) { return (x + 1.0) * y; });
  CHECK(apart.multiply_adds == 2);
  const auto root = operations_of([](Counted x, Counted y) { return sqrt(x) / y; });
  CHECK(root == choice::Operations{.divisions = 1, .square_roots = 1});
  CHECK(choice::cost(root) == 8);
}

TEST_CASE("choice: every problem's methods compute finite numbers in the middle of its domain") {
  for (const auto& problem : choice::problems()) {
    CAPTURE(problem.name);
    std::vector<double> row;
    for (const auto& input : problem.inputs)
      row.push_back(input.scale == choice::Scale::linear ? (input.low + input.high) / 2
                                                         : std::sqrt(input.low * input.high));
    const double exact = problem.exact(row).high;
    CHECK(std::isfinite(exact));
    CHECK(!problem.methods.empty());
    for (const auto& method : problem.methods) {
      CAPTURE(method.name);
      double value = 0;
      if (const auto* run = std::get_if<choice::Run<double>>(&method.run)) {
        std::vector<const double*> inputs;
        for (const double& x : row) inputs.push_back(&x);
        (*run)(1, inputs.data(), &value);
      } else {
        const std::vector<float> rounded(row.begin(), row.end());
        std::vector<const float*> inputs;
        for (const float& x : rounded) inputs.push_back(&x);
        float single = 0;
        std::get<choice::Run<float>>(method.run)(1, inputs.data(), &single);
        value = static_cast<double>(single);
      }
      CHECK(std::isfinite(value));
    }
  }
}

TEST_CASE("choice: problems by their names") {
  const auto names = choice::problem_names();
  const auto all = choice::problems();
  REQUIRE(names.size() == all.size());
  for (std::size_t k = 0; k < names.size(); ++k) CHECK(names[k] == all[k].name);
  CHECK(choice::make_problem("d_ggx")->name == "d_ggx");
  CHECK_FALSE(choice::make_problem("d_gxg"));
}
