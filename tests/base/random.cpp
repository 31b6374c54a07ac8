#include "base/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

using namespace brdfplot;

TEST_CASE("Philox is the published function") {
  // Known answers of its authors' library, Random123 (kat_vectors, philox4x32 10).
  using Four = std::array<std::uint32_t, 4>;
  CHECK(philox({0, 0, 0, 0}, {0, 0}) == Four{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  constexpr std::uint32_t ones = 0xffffffff;
  CHECK(philox({ones, ones, ones, ones}, {ones, ones}) == Four{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
        Four{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("random numbers are uniform, and independent between streams") {
  // Moments within five standard errors: of a uniform number 1/12, of the product of two centred ones 1/144.
  constexpr int n = 200000;
  double mean = 0, square = 0, product = 0;
  Random previous(1, 0);
  for (int stream = 1; stream <= n; ++stream) {
    Random random(1, static_cast<std::uint64_t>(stream));
    const double u = random.uniform() - 0.5, v = previous.uniform() - 0.5;
    mean += u;
    square += u * u;
    product += u * v;
    previous = Random(1, static_cast<std::uint64_t>(stream));
  }
  CHECK(std::fabs(mean / n) < 5 * std::sqrt(1 / 12.0 / n));
  CHECK(std::fabs(square / n - 1 / 12.0) < 5 * std::sqrt(1 / 180.0 / n));
  CHECK(std::fabs(product / n) < 5 * std::sqrt(1 / 144.0 / n));
}

TEST_CASE("a stream of random numbers is the same every time, and another one for another seed") {
  Random a(7, 3), b(7, 3), other_seed(8, 3), other_stream(7, 4);
  for (int k = 0; k < 10; ++k) {
    const double u = a.uniform();
    CHECK(u > 0);
    CHECK(u < 1);
    CHECK(u == b.uniform());
    CHECK(u != other_seed.uniform());
    CHECK(u != other_stream.uniform());
  }
}
