#include "materials.hpp"

#include "base/errors.hpp"
#include "choice/advise/shader/sampling_cost.hpp"
#include "figure/series/term.hpp"

#include <doctest/doctest.h>

using namespace test;
using plot::Setting;
using plot::TermFunction;

namespace {

double value(const std::string& quantity, std::vector<Setting> at) {
  return TermFunction({quantity, describe("ggx", 0.5), std::move(at)}, {}, 1e-6)({}).front();
}

std::string error_of(const std::string& quantity, std::vector<Setting> at) {
  try {
    (void)value(quantity, std::move(at));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST_CASE("what is said of samples is a quantity of figures, at a strategy") {
  const Setting viewer{"theta_o", 0.7}, light{"theta_i", 0.2};
  const Material m = material("ggx", 0.5);
  for (const std::string strategy : {"cosine", "half_vector", "visible_normals", "heitz_2018", "default"}) {
    const Setting by{"strategy", strategy};
    const Sampler sampler(m, strategy);
    const Direction o = from_angles(0.7, 0), i = from_angles(0.2, 0);
    double density = 0;
    sampler.densities(1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, &density);
    CHECK(value("pdf", {viewer, light, by}) == density);
    CHECK(value("weight_variance", {viewer, by}) == weight_variance(m, sampler, o, 1e-6));
    CHECK(value("largest_weight", {viewer, by}) == largest_weight(m, sampler, o));
    const double cost = choice::cost(choice::sampling_operations(describe("ggx", 0.5), strategy));
    CHECK(value("sampling_cost", {viewer, by}) == cost);
    CHECK(value("variance_times_cost", {viewer, by}) == cost * weight_variance(m, sampler, o, 1e-6));
  }
  // Both draw by one density.
  CHECK(value("weight_variance", {viewer, {"strategy", "heitz_2018"}}) == value("weight_variance", {viewer}));
}

TEST_CASE("a strategy that is none, or that a term has not, is an error; so is a direction that is missing") {
  const Setting viewer{"theta_o", 0.7};
  CHECK(error_of("weight_variance", {viewer, {"strategy", "halfvector"}}).find("did you mean \"half_vector\"?") !=
        std::string::npos);
  CHECK(error_of("weight_variance", {viewer, {"strategy", "eon"}}).find("has no strategy \"eon\"") !=
        std::string::npos);
  CHECK(error_of("pdf", {viewer}).find("needs theta_i") != std::string::npos);
  CHECK(error_of("largest_weight", {}).find("needs theta_o") != std::string::npos);
  CHECK(error_of("m.pdf", {viewer}).find("accepted: \"pdf\"") != std::string::npos);
}

TEST_CASE("what no one counted is an error that says what is counted") {
  const TermDescription sheen = describe("sheen", 0.5);
  CHECK_THROWS_WITH_AS((void)TermFunction({"variance_times_cost", sheen, {{"theta_o", 0.7}}}, {}, 1e-6)({}),
                       doctest::Contains("one mirror of ggx or beckmann"), InputError);
}
