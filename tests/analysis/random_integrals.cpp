// Integrals of random materials, hard ones included, against a rule that shares no code with the library's: no answer
// may be further from the truth than was asked, and few may be refused. BRDFPLOT_RANDOM_INTEGRALS sets how many,
// BRDFPLOT_RANDOM_SEED the first of them; with BRDFPLOT_RANDOM_VERBOSE each is named.
#include "../sample.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/parallel.hpp"
#include "integral_cases.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <mutex>

using namespace test;

namespace {

// A sampled run takes two that are quick.
std::uint64_t first_number() { return random_inputs("BRDFPLOT_RANDOM_SEED", 1, 4); }
std::uint64_t count_of_numbers() { return random_inputs("BRDFPLOT_RANDOM_INTEGRALS", 300, 2); }

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

constexpr double fine = 0.03; ///< of the tolerance: what may be asked of the independent rule where it matters

/// What came of some cases.
struct Tally {
  std::size_t answered = 0, refused = 0, wrong = 0, undecided = 0;
  double slowest = 0;
  std::string faults;

  void add(const Tally& other) {
    answered += other.answered;
    refused += other.refused;
    wrong += other.wrong;
    undecided += other.undecided;
    slowest = std::max(slowest, other.slowest);
    faults += other.faults;
  }
};

/// One integral against the truth: wrong is what is further from it than the estimate says.
Tally compare(const IntegralCase& one, double of_tolerance = 1) {
  Tally tally;
  Estimate estimate;
  tally.slowest = timed([&] { estimate = compute(one.integral, one.material, one.o, one.tolerance); });
  const double value = estimate.value / one.scale(), error = estimate.error / one.scale();
  const std::string text = one.text + ": " + format_number(value) + " +- " + format_number(error) + ", " +
                           std::to_string(estimate.evaluations) + " evaluations in " + std::to_string(tally.slowest) +
                           " s";
  if (tally.slowest > 2) say("SLOW " + text);
  if (!(error <= one.tolerance)) {
    tally.refused = 1;
    say("REFUSED " + text);
    return tally;
  }
  // To compare these would take a sanitized run half an hour.
  if (sampled() && of_tolerance < 1) {
    tally.answered = 1;
    return tally;
  }
  double off = 0, doubt = 0;
  const auto hold_against = [&](double fineness) {
    RayIntegral truth;
    const double seconds = timed([&] { truth = truth_of(one, fineness); });
    off = std::fabs(value - truth.value / one.scale());
    doubt = 3 * truth.doubt / one.scale() + 1e-12;
    if (seconds > 2)
      say("SLOW TRUTH " + one.text + ": " + std::to_string(truth.evaluations) + " evaluations in " +
          std::to_string(seconds) + " s");
  };
  hold_against(of_tolerance);
  // Where the two do not agree the truth is taken anew, with panels so fine that it is hardly ever in doubt.
  if (off > error + doubt || doubt > 0.3 * one.tolerance) hold_against(std::min(of_tolerance, fine));
  tally.answered = 1;
  if (doubt > 0.3 * one.tolerance) tally.undecided = 1;
  if (off <= error + doubt) return tally;
  tally.wrong = 1;
  tally.faults = text + (off > one.tolerance + doubt ? ", BEYOND THE TOLERANCE" : "") + ", off by " +
                 format_number(off) + ", in doubt by " + format_number(doubt) + "\n";
  say("WRONG " + tally.faults);
  return tally;
}

/// The sum of what `of_case(number)` gives, over so many numbers, on all threads.
Tally tally_of(std::uint64_t first, std::uint64_t count, const std::function<Tally(std::uint64_t)>& of_case) {
  Tally sum;
  std::mutex mutex;
  parallel_for(count, hardware_threads(), [&](std::size_t k) {
    const Tally one = of_case(first + k);
    const std::lock_guard lock(mutex);
    sum.add(one);
  });
  MESSAGE(sum.answered << " answered, " << sum.refused << " refused, " << sum.wrong << " wrong, " << sum.undecided
                       << " undecided; the slowest took " << sum.slowest << " s");
  return sum;
}

/// None is wrong, and no more than a share of them refused.
void require_right(const Tally& tally, double share = 0.01) {
  INFO(tally.faults);
  CHECK(tally.wrong == 0);
  CHECK(static_cast<double>(tally.refused) <= share * static_cast<double>(tally.answered + tally.refused) + 1);
  CHECK(static_cast<double>(tally.undecided) <= 0.02 * static_cast<double>(tally.answered) + 1);
}

void require_all_right(const Tally& tally) {
  require_right(tally);
  CHECK(tally.refused == 0);
}

Material with_fresnel(TermDescription description, const std::string& type, const std::string& key, double value) {
  description.fresnel = {.type = type, .values = {}};
  description.fresnel.values.set(key, value);
  return build(description);
}

/// rho of diffuse facets on the surface of a case, in another random direction of the light.
Tally compare_diffuse(std::optional<IntegralCase> one, std::uint64_t number) {
  Tally tally;
  Draw draw(number + 77);
  const Direction i = from_angles(draw.between(0, 89.9) * degree, draw.between(0, 6.3));
  if (!one || !(one->material.surface().slopes().project(i).c > 0)) return tally;
  one->material.terms[0].term = FacetDiffuse{one->material.surface(), {}};
  const std::string text =
      one->text + ", diffuse, i = " + format_number(i.x) + ", " + format_number(i.y) + ", " + format_number(i.z);
  try {
    constexpr double accuracy = 1e-9;
    const double value = test::value(one->material, Quantity::brdf, one->o, i);
    RayIntegral truth = diffuse_truth(one->material, one->o, i, accuracy, value, 1);
    const auto agrees = [&] { return std::fabs(value - truth.value) <= accuracy * truth.value + 3 * truth.doubt; };
    if (!agrees()) truth = diffuse_truth(one->material, one->o, i, fine * accuracy, value, 6);
    tally.answered = 1;
    if (!agrees()) {
      tally.wrong = 1;
      tally.faults = text + ": " + format_number(value) + ", truth " + format_number(truth.value) + "\n";
      say("WRONG " + tally.faults);
    }
  } catch (const AccuracyError& error) {
    tally.refused = 1;
    say("REFUSED " + text + ": " + error.what());
  }
  return tally;
}

} // namespace

TEST_CASE("albedos with kinks that are part of a model") {
  Tally tally;
  const auto add = [&](const std::string& text, const Material& m, double theta) {
    tally.add(compare({text, m, from_angles(theta * degree, 0.3)}, fine));
  };
  // Imageworks' fit bends at cos theta_i = 1/2.
  for (const double theta : {10.0, 60.0, 80.0}) add("sheen_fit", material("sheen", 0.5, "sheen_fit"), theta);
  // Total reflection ends at a critical angle.
  for (const double eta : {0.6667, 0.9, 0.4})
    for (const double theta : {0.0, 30.0, 60.0, 80.0})
      for (const auto* shadowing : {"height_correlated", "minimum"})
        add("eta < 1", with_fresnel(shadowed(describe("ggx", 0.3), shadowing), "dielectric", "eta", eta), theta);
  // Walter's fit of a mixture ends at another angle for each component.
  auto walter = mixture({{1, describe("beckmann", 0.1).distribution}, {1, describe("ggx", 0.6).distribution}});
  walter.masking.type = "smith_rational";
  for (const double theta : {0.0, 30.0, 70.0}) add("a mixture with Walter's fit", build(walter), theta);
  require_all_right(tally);
}

TEST_CASE("albedos of rays that cross a kink in a narrow range of angles alone") {
  Tally tally;
  for (const std::uint64_t number : {1975U, 4070U}) tally.add(compare(*random_case(number), fine));
  require_all_right(tally);
}

TEST_CASE("diffuse facets where one direction's masking becomes the smaller one close to the mean slope of a part") {
  require_all_right(compare_diffuse(random_tilted_case(1126), 1126));
}

TEST_CASE("diffuse facets of formulas that jump beside a cut, or bend where only grazing facets are") {
  if (sampled()) return; // the truth takes minutes there
  Tally tally;
  for (const std::uint64_t number : {128U, 244U}) tally.add(compare_diffuse(random_formula_case(number), number));
  require_all_right(tally);
}

TEST_CASE("integrals of few rectangles, on some of whose lines coefficients fall slowly") {
  Tally tally;
  for (const std::uint64_t number : {1786U, 3750U, 5362U, 6497U}) tally.add(compare(*random_case(number), fine));
  require_all_right(tally);
}

TEST_CASE("albedos whose mass lies at the edge of a range of angles") {
  Tally tally;
  for (const double theta : {89.9, 89.99})
    for (const double alpha : {0.1, 0.15, 0.25, 1.0})
      for (const auto& m : {material("sheen", alpha, "v_cavity"), material("ward", alpha)})
        tally.add(compare({m.name, m, from_angles(theta * degree, 0)}, fine));
  require_all_right(tally);
}

TEST_CASE("the area that is seen of slopes with a slow tail, at grazing angles") {
  Tally tally;
  TermDescription description = describe("student_t", 0.389, "student_t_fit");
  description.distribution.values.set("gamma", 2.338);
  for (const double tolerance : {1e-5, 3e-9, 1e-10})
    tally.add(compare(
        {"student_t", build(description), from_angles(89.69 * degree, 0), Integral::visible_norm, tolerance}, fine));
  require_all_right(tally);
}

TEST_CASE("random integrals agree with an independent rule, or are refused, which is rare") {
  require_right(tally_of(first_number(), count_of_numbers(), [](std::uint64_t number) {
    const auto one = random_case(number);
    if (!one) return Tally{};
    say(one->text);
    return compare(*one);
  }));
}

TEST_CASE("random integrals of parts on several mesosurfaces agree with an independent rule, or are refused") {
  require_right(tally_of(first_number(), std::max<std::uint64_t>(count_of_numbers() / 30, 1), [](std::uint64_t number) {
    const auto one = random_tilted_case(number);
    if (!one) return Tally{};
    say(one->text);
    return compare(*one);
  }));
}

TEST_CASE("random integrals of shapes and maskings that are formulas agree with an independent rule, or are refused") {
  const std::uint64_t count = std::max<std::uint64_t>(count_of_numbers() / 10, 1);
  // They may jump where nobody knows, and integrals over two dimensions give up there.
  constexpr double refused = 0.15;
  const Tally lights = tally_of(first_number(), count, [](std::uint64_t number) {
    const auto one = random_formula_case(number);
    if (!one) return Tally{};
    say(one->text);
    return compare(*one);
  });
  require_right(lights, refused);
  require_right(tally_of(first_number(), 2 * count,
                         [](std::uint64_t number) { return compare_diffuse(random_formula_case(number), number); }));
}

TEST_CASE("random BRDFs of diffuse facets agree with an independent rule, or are refused, which is rare") {
  const std::uint64_t count = std::max<std::uint64_t>(count_of_numbers() / 10, 1);
  require_right(tally_of(first_number(), count,
                         [](std::uint64_t number) { return compare_diffuse(random_case(number), number); }));
  require_right(tally_of(first_number(), std::max<std::uint64_t>(count / 2, 1),
                         [](std::uint64_t number) { return compare_diffuse(random_tilted_case(number), number); }));
}
