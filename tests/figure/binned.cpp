#include "figure/series/simulated.hpp"
#include "materials.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace test;
using namespace brdfplot::plot;

namespace {

Term lobe(double alpha, int samples, double half_width) {
  Term term{"brdf_cos", describe("beckmann", alpha), {{"theta_o", 1.3}, {"phi_o", 0.4}, {"phi_i", 0.4}}, Simulate{}};
  term.simulate->source = "bins";
  term.simulate->samples = samples;
  term.simulate->half_width = half_width;
  return term;
}

std::vector<simulation::Measured> means(const Term& term) {
  std::vector<double> x;
  for (int k = 0; k < term.simulate->samples; ++k)
    x.push_back(std::numbers::pi * ((k + 0.5) / term.simulate->samples - 0.5));
  simulation::Store store;
  return SimulatedTerm(term, {"theta_i"}).measure(x, store, 1);
}

} // namespace

TEST_CASE("bins: a narrow bin has the value at its middle, and no error") {
  const Term term = lobe(0.5, 2001, 0.01 * degree);
  const auto narrow = means(term);
  Term exact = term;
  exact.simulate.reset();
  const TermFunction function(exact, {"theta_i"}, 1e-9);
  for (const std::size_t k : {100U, 700U, 1000U, 1500U}) {
    const double theta = std::numbers::pi * ((static_cast<double>(k) + 0.5) / 2001 - 0.5);
    CHECK(narrow[k].value == doctest::Approx(function({{theta}})[0]).epsilon(1e-5));
    CHECK(narrow[k].standard_error == 0);
  }
}

TEST_CASE("bins: few wide ones have the mean of many narrow ones, and a lower peak") {
  const auto wide = means(lobe(0.1, 30, 2 * degree)), narrow = means(lobe(0.1, 300, 2 * degree));
  double peak = 0, narrow_peak = 0;
  for (std::size_t k = 0; k < wide.size(); ++k) {
    double sum = 0;
    for (std::size_t l = 0; l < 10; ++l) {
      sum += narrow[10 * k + l].value / 10;
      narrow_peak = std::max(narrow_peak, narrow[10 * k + l].value);
    }
    CHECK(wide[k].value == doctest::Approx(sum).epsilon(1e-3));
    peak = std::max(peak, wide[k].value);
  }
  CHECK(peak < 0.99 * narrow_peak);
}

TEST_CASE("bins: needs both directions") {
  Term term = lobe(0.5, 10, 0.1);
  term.at = {};
  CHECK_THROWS_WITH(SimulatedTerm(term, {"theta_i"}).check({0.1}), "this mean needs theta_o");
  term.quantity = "albedo";
  CHECK_THROWS_AS(SimulatedTerm(term, {"theta_i"}), InputError);
}
