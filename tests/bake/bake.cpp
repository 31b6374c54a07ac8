// Tables against the integrals themselves: at nodes, and between them within the stated bound.
#include "bake/bake.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "base/threads/parallel.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace brdfplot;

namespace {

MaterialDescription ggx(double alpha, const std::string& fresnel = "none", double f0 = 0) {
  TermDescription term;
  term.type = "mirror";
  term.name = "mirror";
  term.distribution.type = "ggx";
  term.distribution.values.set("alpha", alpha);
  term.fresnel.type = fresnel;
  if (fresnel != "none") term.fresnel.values.set("f0", f0);
  return term;
}

std::vector<bake::Axis> axes(std::initializer_list<const char*> texts) {
  std::vector<bake::Axis> out;
  for (const char* text : texts) out.push_back(bake::parse_axis(text, "--over"));
  return out;
}

Direction viewer(double cosine) { return {std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine}; }

} // namespace

TEST_CASE("axes are read as they are written") {
  const bake::Axis axis = bake::parse_axis("alpha=0.25:1:9:2", "--over");
  CHECK(axis.nodes == 9);
  CHECK(axis.at(0) == 0.25);
  CHECK(axis.at(0.5) == 0.25 + 0.75 / 4);
  CHECK(axis.at(1) == 1);
  CHECK(std::pow((axis.at(0.3) - axis.from) / (axis.to - axis.from), 1.0 / axis.power) ==
        doctest::Approx(0.3).epsilon(1e-14));
  CHECK(bake::parse_axis("theta_o=0:90deg", "--over").to == doctest::Approx(1.5707963267948966).epsilon(1e-16));
  for (const char* wrong : {"alpha", "=0:1", "alpha=0", "alpha=1:0", "alpha=0:1:1", "alpha=0:1:2.5", "alpha=0:1:9:0",
                            "alpha=0:1:9:9", "alpha=0:1:9:1:1", "alpha=0:nan", "alpha=0:1deg"})
    CHECK_THROWS_AS(bake::parse_axis(wrong, "--over"), InputError);
}

TEST_CASE("a table holds the integrals at its nodes, and between them what its bound says") {
  const auto baked = bake::bake(ggx(0.5), "furnace", axes({"cos_theta_o=0:1", "alpha=0.05:1"}), {.error = 0.01});
  CHECK(baked.bound <= 0.01);
  const bake::Table& table = baked.table;
  REQUIRE(table.values.size() == table.nodes());
  const auto truth = [](double cosine, double alpha) {
    return compute_or_throw(Integral::furnace, build(ggx(alpha)), viewer(cosine), 1e-7);
  };
  const std::size_t row = table.axes[0].nodes, k = row / 2;
  const double cosine = table.axes[0].at(static_cast<double>(k) / static_cast<double>(row - 1));
  CHECK(table.values[row + k] ==
        doctest::Approx(truth(cosine, table.axes[1].at(1.0 / static_cast<double>(table.axes[1].nodes - 1))))
            .epsilon(2e-6));
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<std::vector<double>> points(test::random_inputs("BRDFPLOT_BAKE_POINTS", 1000, 50));
  for (std::vector<double>& at : points) at = {share(random), share(random)};
  std::vector<double> off(points.size());
  parallel_for(points.size(), hardware_threads(), [&](std::size_t n) {
    const double exact = truth(std::max(table.axes[0].at(points[n][0]), 1e-6), table.axes[1].at(points[n][1]));
    off[n] = std::fabs(table.interpolated(points[n])[0] - exact);
  });
  const double largest = *std::ranges::max_element(off);
  CHECK(largest <= baked.bound);
  CHECK(largest > baked.bound / 10); // a bound that says nothing would pass too
}

TEST_CASE("scale and bias give the albedo of every f0") {
  const auto baked = bake::bake(ggx(0.3, "schlick", 0.5), "dfg", axes({"cos_theta_o=0.05:1:3", "alpha=0.1:0.9:3"}), {});
  const bake::Table& table = baked.table;
  REQUIRE(table.channels == std::vector<std::string>{"scale", "bias"});
  for (std::size_t node = 0; node < table.nodes(); ++node)
    for (const double f0 : {0.0, 0.04, 0.6, 1.0}) {
      const double cosine = table.axes[0].at(static_cast<double>(node % 3) / 2);
      const Material material = build(ggx(table.axes[1].at(static_cast<double>(node / 3) / 2), "schlick", f0));
      const double albedo = compute_or_throw(Integral::albedo, material, viewer(cosine), 1e-8);
      CHECK(std::fabs(f0 * table.values[2 * node] + table.values[2 * node + 1] - albedo) < 2e-6);
    }
}

TEST_CASE("the mean albedo is the mean of the albedo") {
  // int E 2 mu dmu by the midpoint rule in mu^2, of a smooth E.
  const auto baked = bake::bake(ggx(0.5), "mean_furnace", axes({"alpha=0.3:1:2"}), {});
  for (const std::size_t node : {0U, 1U}) {
    const Material material = build(ggx(baked.table.axes[0].at(static_cast<double>(node))));
    double mean = 0;
    constexpr int steps = 2000;
    for (int k = 0; k < steps; ++k)
      mean += compute_or_throw(Integral::furnace, material, viewer(std::sqrt((k + 0.5) / steps)), 1e-7) / steps;
    CHECK(std::fabs(baked.table.values[node] - mean) < 2e-5);
  }
}

TEST_CASE("an inverse cumulative table is the inverse") {
  // GGX: the share of D cos theta beyond theta is tan^2 / (alpha^2 + tan^2) turned round: tan^2 = alpha^2 (1 - u) / u.
  const double alpha = 0.4;
  const auto normals = bake::bake(ggx(alpha), "inverse_normals", axes({"u=0:1"}), {.error = 2e-3});
  CHECK(normals.bound <= 2e-3);
  for (int k = 0; k <= 5000; ++k) {
    const double t = k / 5000.0, u = normals.table.axes[0].at(t);
    const double exact = u > 0 ? 1 / std::sqrt(1 + alpha * alpha * (1 - u) / u) : 0;
    if (std::fabs(normals.table.interpolated({t})[0] - exact) > normals.bound) FAIL(u);
  }

  // Beckmann: tan^2 = -alpha^2 ln(u), which leaves 0 steeply.
  MaterialDescription beckmann = ggx(1);
  beckmann.terms[0].distribution.type = "beckmann";
  const auto steep = bake::bake(beckmann, "inverse_normals", axes({"u=0:1", "alpha=0.1:1:3"}), {.error = 0.01});
  for (int k = 1; k <= 5000; ++k) {
    const double t = k / 5000.0, u = std::max(steep.table.axes[0].at(t), 0x1p-53);
    const double exact = 1 / std::sqrt(1 - std::log(u));
    if (std::fabs(steep.table.interpolated({t, 1})[0] - exact) > steep.bound) FAIL(u);
  }

  // The matte part: the share of (1 - E) cos up to the cosine of a node is its u, by the midpoint rule.
  TermDescription matte;
  matte.type = matte.name = "complement";
  matte.of = {ggx(0.5).terms[0]};
  const MaterialDescription material(matte);
  const auto complement = bake::bake(material, "inverse_complement", axes({"u=0:1:9:2"}), {});
  constexpr int steps = 4000;
  std::vector<double> below{0};
  for (int k = 0; k < steps; ++k) {
    const double cosine = (k + 0.5) / steps;
    const double loss = 1 - compute_or_throw(Integral::albedo, build(ggx(0.5)), viewer(cosine), 1e-6);
    below.push_back(below.back() + loss * cosine);
  }
  for (std::size_t k = 0; k < 9; ++k) {
    const double share = complement.table.values[k] * steps;
    const auto cell = std::min(static_cast<std::size_t>(share), below.size() - 2);
    const double inside = share - static_cast<double>(cell);
    const double u = (below[cell] + inside * (below[cell + 1] - below[cell])) / below.back();
    CHECK(u == doctest::Approx(complement.table.axes[0].at(static_cast<double>(k) / 8)).epsilon(2e-4));
  }
}

TEST_CASE("what a table cannot give is an error that says so") {
  const auto refuses = [](const MaterialDescription& material, const char* quantity,
                          std::initializer_list<const char*> over, bake::BakeOptions options = {}) {
    CHECK_THROWS_AS(bake::bake(material, quantity, axes(over), options), InputError);
  };
  refuses(ggx(0.5), "fnord", {"cos_theta_o=0:1"});
  refuses(ggx(0.5), "albedo", {"alpha=0.1:1"});                        // of which viewer?
  refuses(ggx(0.5), "mean_albedo", {"cos_theta_o=0:1"});               // of all of them
  refuses(ggx(0.5), "albedo", {"cos_theta_o=0:1", "theta_o=0:1"});     // twice
  refuses(ggx(0.5), "albedo", {"cos_theta_o=0:1", "cos_theta_o=0:1"}); // twice
  refuses(ggx(0.5), "albedo", {"cos_theta_o=0:1", "gamma=1:2"});       // GGX has none
  refuses(ggx(0.5), "albedo", {"cos_theta_o=0:1:3", "alpha=-1:1:3"});  // no GGX at -1
  refuses(ggx(0.5), "albedo", {"cos_theta_o=0:1"}, {.error = 1e-7});   // below the integrals' own
  refuses(ggx(0.5), "albedo", {"cos_theta_o=0:1:1001", "alpha=0.1:1:1001"});
  TermDescription lambert;
  lambert.type = lambert.name = "lambert";
  refuses(lambert, "dfg", {"cos_theta_o=0:1"}); // has no F
  refuses(lambert, "inverse_normals", {"u=0:1"});
  refuses(ggx(0.5), "inverse_complement", {"u=0:1"});
  refuses(ggx(0.5), "inverse_normals", {"alpha=0.1:1"}); // of which share?
  refuses(ggx(0.5), "inverse_normals", {"u=0:2"});
  refuses(ggx(0.5), "inverse_normals", {"u=0:1", "cos_theta_o=0:1"});
  MaterialDescription brushed = ggx(0.5);
  brushed.terms[0].distribution.values = {};
  brushed.terms[0].distribution.values.set("alpha_x", 0.1);
  brushed.terms[0].distribution.values.set("alpha_y", 0.5);
  refuses(brushed, "albedo", {"cos_theta_o=0:1"}); // of which azimuth?
  refuses(brushed, "inverse_normals", {"u=0:1"});
  CHECK_NOTHROW(bake::bake(brushed, "albedo", axes({"cos_theta_o=0.1:1:2", "phi_o=0:90deg:2"}), {}));
}
