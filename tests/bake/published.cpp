// Tables that others publish, against the integrals: Cycles' albedo of GGX (Blender 4,
// intern/cycles/scene/shader.tables, ggx_E and ggx_Eavg), by 2^23 and 2^26 samples, printed with six decimals; alpha =
// (k / 31)^2, cos theta = k / 31.
#include "../materials.hpp"
#include "bake/quantity.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

using namespace brdfplot;

namespace {

MaterialDescription ggx(double alpha) { return test::describe("ggx", alpha); }

double baked(const char* quantity, int column, double cosine) {
  const double alpha = std::pow(column / 31.0, 2);
  if (cosine == 0) return bake::Baked(ggx(alpha), quantity, {{"alpha", alpha, 2}}, 1e-7).at({alpha})[0];
  return bake::Baked(ggx(alpha), quantity, {{"cos_theta_o", 0, 1}}, 1e-8).at({cosine})[0];
}

} // namespace

TEST_CASE("the albedo of GGX is that of Cycles' tables, to their last digit and their noise") {
  constexpr double precision = 1.5e-6;
  using Entries = std::initializer_list<std::pair<int, double>>;
  for (const auto& [k, value] : Entries{{1, 0.999451}, {4, 0.911203}, {8, 0.917411}, {16, 0.952096}, {31, 0.888202}})
    CHECK(std::fabs(baked("furnace", k, 1 / 31.0) - value) < precision);
  for (const auto& [k, value] : Entries{{1, 0.999996}, {8, 0.979280}, {16, 0.833371}, {24, 0.674202}, {31, 0.505951}})
    CHECK(std::fabs(baked("furnace", k, 12 / 31.0) - value) < precision);
  for (const auto& [k, value] : Entries{{1, 0.999999}, {8, 0.995072}, {16, 0.903873}, {24, 0.592102}, {31, 0.306853}})
    CHECK(std::fabs(baked("furnace", k, 1) - value) < precision);
  for (const auto& [k, value] : Entries{{4, 0.998729}, {10, 0.970160}, {18, 0.819774}, {25, 0.597509}, {31, 0.409137}})
    CHECK(std::fabs(baked("mean_furnace", k, 0) - value) < precision);
}
