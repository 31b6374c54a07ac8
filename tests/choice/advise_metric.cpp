#include "choice/advise/images/errors.hpp"
#include "choice/advise/images/metric.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace brdfplot;
using namespace brdfplot::choice;

TEST_CASE("Delta E_ITP of known pairs") {
  // Computed in 30 digits from ITU-R BT.2100-2 (PQ, IC_TC_P) and BT.2124-0, with the primaries of BT.709 and BT.2020.
  struct Pair {
    Rgb a, b;
    double delta_e;
  };
  const Pair pairs[] = {{{203, 203, 203}, {203, 203, 203}, 0},
                        {{203, 203, 203}, {206, 206, 206}, 1.10439714834},
                        {{1, 1, 1}, {2, 2, 2}, 27.548101695},
                        {{100, 20, 10}, {100, 22, 10}, 5.47677051499},
                        {{1000, 1000, 1000}, {1, 1, 1}, 433.354582186}};
  for (const Pair& pair : pairs) {
    CHECK(delta_e_itp(pair.a, pair.b) == doctest::Approx(pair.delta_e).epsilon(1e-6));
    CHECK(delta_e_itp(pair.b, pair.a) == doctest::Approx(pair.delta_e).epsilon(1e-6));
  }
}

TEST_CASE("a screen clips at its peak and reflects its room") {
  CHECK(shown({0, 1, 100}, 1) == Rgb{1, 204, 1001});
  CHECK(difference(Metric::delta_e, {6, 6, 6}, {60, 60, 60}, 1) == 0);
  CHECK(difference(Metric::relative, {1, 1, 1}, {1, 1, 1.1}, 203) == doctest::Approx(0.1 / (1 + 1.0 / (203 * 203))));
}

TEST_CASE("percentiles are of the lit area") {
  // Ten places, two of which are dark; errors are those of relative radiance without flare to speak of.
  const double exposure = 1e6;
  Places places{std::vector<sphere::Place>(10, {0, 0}), std::vector<double>(10, 0.1)};
  Picture reference(30, 1.0), other(30, 1.0);
  for (std::size_t c = 0; c < 3; ++c) {
    reference[c * 10] = reference[c * 10 + 1] = 0;
    other[c * 10] = 5; // in the dark: does not count
    other[c * 10 + 9] = 1.5;
    other[c * 10 + 8] = 1.25;
  }
  const PictureErrors errors = compare(reference, other, places, Metric::relative, exposure);
  CHECK(errors.worst == doctest::Approx(0.5));
  CHECK(errors.p95 == doctest::Approx(0.5)); // an eighth of the lit area is off by that
  CHECK(errors.decisive() == errors.p95);
  CHECK(errors.energy == doctest::Approx(0.75 / 8));
  places.share[9] = 0.01; // 1.4 % of it: the worst 1 % and not the percentile
  const PictureErrors small = compare(reference, other, places, Metric::relative, exposure);
  CHECK(small.worst == doctest::Approx(0.5));
  CHECK(small.p95 == doctest::Approx(0.25));
}
