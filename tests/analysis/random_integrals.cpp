// Integrals of random materials, hard ones included, against a rule that shares no code with the library's: no answer
// may be further from the truth than was asked, and few may be refused. BRDFPLOT_RANDOM_INTEGRALS sets how many,
// BRDFPLOT_RANDOM_SEED the first of them; with BRDFPLOT_RANDOM_VERBOSE each is named.
#include "integral_cases.hpp"
#include "math/errors.hpp"
#include "math/number.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

using namespace test;

namespace {

std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* asked = std::getenv(name);
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : usual;
}

void say(const std::string& text) {
  static const bool verbose = std::getenv("BRDFPLOT_RANDOM_VERBOSE") != nullptr;
  if (verbose) std::cout << text << std::endl;
}

/// Calls f() and returns the seconds that it took.
template <class F>
double timed(const F& f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Tally {
  std::size_t answered = 0, refused = 0, wrong = 0, dishonest = 0, undecided = 0;
  double slowest = 0;
};

/// One integral against the truth.
void compare(const IntegralCase& one, Tally& tally) {
  Estimate estimate;
  const double seconds = timed([&] { estimate = compute(one.integral, one.material, one.o, one.tolerance); });
  tally.slowest = std::max(tally.slowest, seconds);
  const double value = estimate.value / one.scale(), error = estimate.error / one.scale();
  const auto report = [&](const std::string& what) {
    say(what + " " + one.text + ": " + format_number(value) + " +- " + format_number(error) + ", " +
        std::to_string(estimate.evaluations) + " evaluations in " + std::to_string(seconds) + " s");
  };
  if (seconds > 2) report("SLOW");
  if (!(error <= one.tolerance)) {
    ++tally.refused;
    return report("REFUSED");
  }
  RayIntegral truth;
  const double of_truth = timed([&] { truth = truth_of(one); });
  if (of_truth > 20) say("TRUTH TOOK " + std::to_string(of_truth) + " s: " + one.text);
  const double off = std::fabs(value - truth.value / one.scale());
  const double doubt = 3 * truth.doubt / one.scale() + 1e-12;
  ++tally.answered;
  if (doubt > 0.3 * one.tolerance) ++tally.undecided;
  INFO(one.text << ": off by " << off << " at an estimate of " << error << ", in doubt by " << doubt);
  CHECK(off <= one.tolerance + doubt);
  CHECK(off <= error + doubt);
  if (off > one.tolerance + doubt) ++tally.wrong;
  if (off > error + doubt) {
    ++tally.dishonest;
    report("WRONG by " + format_number(off) + ", in doubt by " + format_number(doubt));
  }
}

Material with_fresnel(MaterialDescription description, const std::string& type, const std::string& key, double value) {
  description.fresnel = {.type = type, .values = {}};
  description.fresnel.values.set(key, value);
  return build(description);
}

} // namespace

TEST_CASE("albedos with kinks that are part of a model") {
  Tally tally;
  // Imageworks' fit bends at cos theta_i = 1/2.
  for (const double theta : {10.0, 60.0, 80.0})
    compare({"sheen_fit", material("sheen", 0.5, "sheen_fit"), from_angles(theta * degree, 0)}, tally);
  // Total reflection ends at a critical angle.
  for (const double eta : {0.6667, 0.9, 0.4})
    for (const double theta : {0.0, 30.0, 60.0, 80.0})
      for (const auto* shadowing : {"height_correlated", "minimum"})
        compare({"eta < 1", with_fresnel(shadowed(describe("ggx", 0.3), shadowing), "dielectric", "eta", eta),
                 from_angles(theta * degree, 0.3)},
                tally);
  // Walter's fit of a mixture ends at another angle for each component.
  const auto two = mixture({{1, describe("beckmann", 0.1).distribution}, {1, describe("ggx", 0.6).distribution}});
  for (const double theta : {0.0, 30.0, 70.0}) {
    MaterialDescription walter = two;
    walter.masking.type = "smith_rational";
    compare({"a mixture with Walter's fit", build(walter), from_angles(theta * degree, 0.3)}, tally);
  }
  CHECK(tally.refused == 0);
}

TEST_CASE("albedos whose mass lies at the edge of a range of angles") {
  Tally tally;
  for (const double theta : {89.9, 89.99})
    for (const double alpha : {0.1, 0.15, 0.25}) {
      compare({"sheen in V-cavities", material("sheen", alpha, "v_cavity"), from_angles(theta * degree, 0)}, tally);
      compare({"ward", material("ward", 1), from_angles(theta * degree, 0)}, tally);
    }
  CHECK(tally.refused == 0);
}

TEST_CASE("the weak white furnace of slopes with a slow tail, at grazing angles") {
  Tally tally;
  MaterialDescription description = describe("student_t", 0.389, "student_t_fit");
  description.distribution.values.set("gamma", 2.338);
  for (const double tolerance : {1e-5, 3e-9, 1e-10})
    compare({"student_t", build(description), from_angles(89.69 * degree, 0), Integral::visible_norm, tolerance},
            tally);
  CHECK(tally.refused == 0);
}

TEST_CASE("random integrals agree with an independent rule, or are refused, which is rare") {
  const std::uint64_t first = setting("BRDFPLOT_RANDOM_SEED", 1), count = setting("BRDFPLOT_RANDOM_INTEGRALS", 300);
  Tally tally;
  for (std::uint64_t number = first; number < first + count; ++number)
    if (const auto one = random_case(number)) {
      say(one->text);
      compare(*one, tally);
    }
  MESSAGE(tally.answered << " answered, " << tally.refused << " refused, " << tally.wrong << " wrong, "
                         << tally.dishonest << " beyond their estimate, " << tally.undecided
                         << " undecided; the slowest took " << tally.slowest << " s");
  CHECK(static_cast<double>(tally.refused) <= 0.01 * static_cast<double>(tally.answered + tally.refused) + 1);
  CHECK(static_cast<double>(tally.undecided) <= 0.02 * static_cast<double>(tally.answered) + 1);
}

TEST_CASE("random BRDFs of diffuse facets agree with an independent rule, or are refused, which is rare") {
  constexpr double accuracy = 1e-9;
  const std::uint64_t first = setting("BRDFPLOT_RANDOM_SEED", 1), count = setting("BRDFPLOT_RANDOM_INTEGRALS", 300) / 5;
  std::size_t answered = 0, refused = 0;
  for (std::uint64_t number = first; number < first + count; ++number) {
    auto one = random_case(number);
    Draw draw(number + 77);
    const Direction i = from_angles(draw.between(0, 89.9) * degree, draw.between(0, 6.3));
    if (!one || !(one->material.slopes().project(i).c > 0)) continue;
    one->material.fresnel = NoFresnel{};
    one->material.facet = Facet::diffuse;
    const std::string text =
        one->text + ", diffuse, i = " + format_number(i.x) + ", " + format_number(i.y) + ", " + format_number(i.z);
    try {
      const double value = test::value(one->material, Quantity::brdf, one->o, i);
      const RayIntegral truth = diffuse_truth(one->material, one->o, i, accuracy, value);
      ++answered;
      INFO(text << ": " << value << ", truth " << truth.value << " +- " << truth.doubt);
      const bool right = std::fabs(value - truth.value) <= accuracy * truth.value + 3 * truth.doubt;
      CHECK(right);
      if (!right) say("WRONG " + text + ": " + format_number(value) + ", truth " + format_number(truth.value));
    } catch (const AccuracyError& error) {
      ++refused;
      say("REFUSED " + text + ": " + error.what());
    }
  }
  MESSAGE(answered << " answered, " << refused << " refused");
  CHECK(static_cast<double>(refused) <= 0.01 * static_cast<double>(answered + refused) + 1);
}
