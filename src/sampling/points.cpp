#include "sampling/points.hpp"

#include "base/errors.hpp"
#include "base/random.hpp"
#include "models/parameters.hpp"

#include <boost/random/sobol.hpp>

#include <algorithm>

namespace brdfplot {

namespace {

using Digits = std::array<std::uint64_t, 3>;

/// As Random::uniform().
SamplePoint point_of(const Digits& bits) {
  SamplePoint point{};
  for (std::size_t d = 0; d < point.size(); ++d) point[d] = (static_cast<double>(bits[d] >> 12) + 0.5) * 0x1p-52;
  return point;
}

/// Digits of point k: two blocks of the counter.
Digits random_digits(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); };
  const auto a = philox({low(2 * k), high(2 * k), low(stream), high(stream)}, {low(seed), high(seed)});
  const auto b = philox({low(2 * k + 1), high(2 * k + 1), low(stream), high(stream)}, {low(seed), high(seed)});
  return {a[0] | std::uint64_t{a[1]} << 32, a[2] | std::uint64_t{a[3]} << 32, b[0] | std::uint64_t{b[1]} << 32};
}

} // namespace

PointKind point_kind(const std::string& name, const std::string& where) {
  if (name == "random") return PointKind::random;
  if (name == "sobol") return PointKind::sobol;
  throw InputError(where, unknown_name("kind of points", name, {"random", "sobol"}));
}

std::vector<SamplePoint> points(PointKind kind, std::uint64_t seed, std::uint64_t stream, std::uint64_t first,
                                std::size_t n) {
  std::vector<SamplePoint> all(n);
  if (kind == PointKind::random) {
    for (std::size_t k = 0; k < n; ++k) all[k] = point_of(random_digits(seed, stream, first + k));
    return all;
  }
  Random random(seed, stream);
  Digits shift{};
  for (std::uint64_t& digits : shift) digits = random.bits();
  boost::random::sobol engine(shift.size());
  // Boost leaves out the point 0, without which no 2^m points are spread as evenly as Sobol's are.
  if (first > 0) engine.seed(first - 1);
  for (std::size_t k = 0; k < n; ++k) {
    Digits digits = shift;
    if (first + k > 0)
      for (std::uint64_t& one : digits) one ^= engine();
    all[k] = point_of(digits);
  }
  return all;
}

} // namespace brdfplot
