#include "../materials.hpp"

#include "brdf/evaluate_single.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <vector>

using namespace test;

namespace {

Direction random_direction(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> unit(0, 1);
  return from_angles(std::acos(unit(engine)), 2 * std::numbers::pi * unit(engine));
}

std::vector<Material> reciprocal_materials() {
  std::vector<Material> out;
  for (const auto* type : {"separable", "minimum", "height_correlated"})
    out.push_back(build(shadowed(general("beckmann", 0.3, 0.7, 0.4), type)));
  for (const auto* type : {"direction_correlated", "height_direction_correlated"})
    for (const auto* factor : {"ashikhmin", "ginneken", "fitted"})
      out.push_back(build(shadowed(describe("ggx", 0.6), type, factor)));
  out.push_back(
      build(shadowed(general("beckmann", 0.3, 0.7, 0.4, {0.2, 0.1}), "height_direction_correlated", "fitted")));
  for (const auto* masking : {"v_cavity", "implicit", "schlick_smith", "schlick_smith_rational", "kelemen"})
    out.push_back(material("beckmann", 0.5, masking));
  out.push_back(material("phong", 0.5));
  out.push_back(gtr(0.3, 1.5));
  out.push_back(build(general("ggx", 0.4, 0.2, 0.3, {0.3, -0.2})));
  return out;
}

} // namespace

TEST_CASE("the BRDF is Eq. 29, F D G2 / (4 cos cos), where that can be evaluated as printed") {
  std::mt19937_64 engine(1);
  for (const Material& m : reciprocal_materials())
    for (int k = 0; k < 50; ++k) {
      const Direction o = random_direction(engine), i = random_direction(engine), h = half_vector(o, i);
      const double c_o = m.surface().slopes().project(o).c, c_i = m.surface().slopes().project(i).c;
      const double printed =
          c_o > 0 && c_i > 0 ? value_at_normal(m, Quantity::d, o, h) * value(m, Quantity::g2, o, i) / (4 * c_o * c_i)
                             : 0;
      INFO(m.name);
      CHECK(value(m, Quantity::brdf, o, i) == doctest::Approx(printed).epsilon(1e-13));
      CHECK(value(m, Quantity::brdf_cos, o, i) == doctest::Approx(printed * std::max(0.0, c_i)).epsilon(1e-13));
    }
}

TEST_CASE("the BRDF does not look at a normal given beside the two directions; G2 and F do") {
  const Direction o = from_angles(1.0, 0.3), i = from_angles(0.6, 2.0), m = from_angles(1.2, 1.0);
  TermDescription metal = describe("ggx", 0.25);
  metal.fresnel.type = "schlick";
  metal.fresnel.values.set("f0", Rgb{0.1, 0.2, 0.3});
  for (const Material& material :
       {material("ggx", 0.25), material("beckmann", 0.25), material("ggx", 0.25, "v_cavity"), gtr(0.25, 1.5),
        build(shadowed(describe("ggx", 0.25), "direction_correlated", "ginneken")), build(metal)})
    for (const Quantity q : {Quantity::brdf, Quantity::brdf_cos}) {
      INFO(material.name);
      CHECK(evaluate(material, q, o, i, m) == evaluate(material, q, o, i, std::nullopt));
      std::array<float, 3> with{}, without{};
      const auto columns = [](const Direction& d) { return Columns{&d.x, &d.y, &d.z}; };
      evaluate(material, q, {1, columns(o), columns(i), columns(m)}, with.data());
      evaluate(material, q, {1, columns(o), columns(i), {}}, without.data());
      CHECK(with == without);
    }
  CHECK(evaluate(material("ggx", 0.25), Quantity::g2, o, i, {{0, -1, 0.01}}) == 0);
  CHECK(evaluate(build(metal), Quantity::fresnel, o, i, m) !=
        evaluate(build(metal), Quantity::fresnel, o, i, std::nullopt));
}

TEST_CASE("the BRDF is reciprocal") {
  std::mt19937_64 engine(2);
  for (const Material& m : reciprocal_materials())
    for (int k = 0; k < 100; ++k) {
      const Direction o = random_direction(engine), i = random_direction(engine);
      INFO(m.name);
      CHECK(relative(value(m, Quantity::brdf, o, i), value(m, Quantity::brdf, i, o)) < 1e-13);
    }
}

TEST_CASE("a row's value depends on that row alone, to the last bit") {
  std::mt19937_64 engine(3);
  constexpr std::size_t n = 1000; // more than one block, and a rest
  std::array<std::vector<double>, 6> c;
  std::vector<Direction> os, is;
  for (std::size_t k = 0; k < n; ++k) {
    os.push_back(random_direction(engine));
    is.push_back(random_direction(engine));
    if (k % 3 == 0 && k > 0) os[k] = os[k - 1];
    for (auto& column : c) column.resize(n);
    c[0][k] = os[k].x, c[1][k] = os[k].y, c[2][k] = os[k].z;
    c[3][k] = is[k].x, c[4][k] = is[k].y, c[5][k] = is[k].z;
  }
  const Batch batch{n, {c[0].data(), c[1].data(), c[2].data()}, {c[3].data(), c[4].data(), c[5].data()}, {}};
  std::vector<double> out(n);
  for (const Material& m : {material("beckmann", 0.3), material("ggx", 0.3, "v_cavity")})
    for (const auto& info : quantities()) {
      if (info.quantity == Quantity::lambda && !m.surface().has_lambda()) continue;
      evaluate(m, info.quantity, batch, out.data());
      for (std::size_t k = 0; k < n; ++k) {
        INFO(m.name << ", " << info.name << ", row " << k);
        REQUIRE(out[k] == value(m, info.quantity, os[k], is[k]));
      }
    }
}

/// Models of every way to compute, among them coloured ones.
std::vector<Material> materials_of_all_kinds() {
  auto all = reciprocal_materials();
  TermDescription description = describe("ggx", 0.3);
  description.fresnel.type = "conductor";
  description.fresnel.values.set("eta", Rgb{0.14, 0.38, 1.44});
  description.fresnel.values.set("k", Rgb{3.98, 2.39, 1.60});
  all.push_back(build(description));
  all.push_back(build(shadowed(description, "direction_correlated", "fitted")));
  description.masking.type = "v_cavity";
  all.push_back(build(description));
  return all;
}

TEST_CASE("several quantities at once have the bytes of one at a time") {
  std::mt19937_64 engine(4);
  constexpr std::size_t n = 300; // more than one block
  std::array<std::vector<double>, 9> c;
  for (std::size_t k = 0; k < 3 * n; ++k) {
    const std::size_t letter = k % 3;
    const Direction d = random_direction(engine);
    c[3 * letter].push_back(d.x), c[3 * letter + 1].push_back(d.y), c[3 * letter + 2].push_back(d.z);
  }
  const auto columns = [&](std::size_t k) { return Columns{c[k].data(), c[k + 1].data(), c[k + 2].data()}; };
  for (const Material& m : materials_of_all_kinds())
    for (const bool with_normal : {false, true})
      for (const bool backwards : {false, true}) {
        const Batch batch{n, columns(0), columns(3), with_normal ? columns(6) : Columns{}};
        std::vector<std::vector<double>> together(quantities().size(), std::vector<double>(3 * n));
        std::vector<Wanted> wanted;
        for (const auto& info : quantities())
          if (info.quantity != Quantity::lambda || m.surface().has_lambda())
            wanted.push_back({info.quantity, together[static_cast<std::size_t>(info.quantity)].data()});
        if (backwards) std::ranges::reverse(wanted);
        evaluate(m, wanted, batch);
        for (const Wanted& one : wanted) {
          std::vector<double> alone(3 * n);
          evaluate(m, one.quantity, batch, alone.data());
          INFO(m.name << ", " << quantities()[static_cast<std::size_t>(one.quantity)].name << ", normal "
                      << with_normal);
          REQUIRE(std::memcmp(alone.data(), one.out, alone.size() * sizeof(double)) == 0);
        }
      }
}

TEST_CASE("never NaN, never negative, 0 where there is nothing, at the ends of the domain") {
  std::vector<Direction> ends = {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for (const double theta : {1e-300, 1e-160, 1e-9, 0.7, 1.5707963, std::numbers::pi / 2, 1.8, 3.1})
    for (const double phi : {0.0, 1.3, std::numbers::pi}) ends.push_back(from_angles(theta, phi));
  auto all = reciprocal_materials();
  for (const double alpha : {1e-6, 1e-3, 1e3})
    for (const auto* type : {"beckmann", "ggx"}) all.push_back(material(type, alpha));
  for (const Material& m : all)
    for (const Direction& o : ends)
      for (const Direction& i : ends) {
        const bool hidden = !(m.surface().slopes().project(o).c > 0) || !(m.surface().slopes().project(i).c > 0);
        for (const Quantity q : {Quantity::brdf, Quantity::brdf_cos, Quantity::g2}) {
          const double v = value(m, q, o, i);
          INFO(m.name << " o = " << o.x << " " << o.y << " " << o.z << " i = " << i.x << " " << i.y << " " << i.z);
          REQUIRE(std::isfinite(v));
          REQUIRE(v >= 0);
          if (hidden) REQUIRE(v == 0);
        }
        const double visible = value_at_normal(m, Quantity::d_visible, o, i);
        REQUIRE(std::isfinite(visible));
        REQUIRE(visible >= 0);
      }
  const Direction o = from_angles(0.5, 0);
  CHECK(value(material("ggx", 0.5), Quantity::brdf, o, -1.0 * o) == 0);
  CHECK(lambda(material("ggx", 0.5), {1, 0, 0}) == infinity);
}

TEST_CASE("grazing values tend to their limit instead of to 0 / 0") {
  const Material m = material("ggx", 0.5);
  const Direction i = from_angles(0.4, std::numbers::pi);
  const double near = value(m, Quantity::brdf, from_angles(std::numbers::pi / 2 - 1e-9, 0), i);
  const double nearer = value(m, Quantity::brdf, from_angles(std::numbers::pi / 2 - 1e-14, 0), i);
  CHECK(nearer == doctest::Approx(near).epsilon(1e-7));
  CHECK(nearer > 0.01);
}

TEST_CASE("colour comes from the Fresnel term alone") {
  TermDescription gold = describe("ggx", 0.3);
  gold.fresnel.type = "conductor";
  gold.fresnel.values.set("eta", Rgb{0.14, 0.38, 1.44});
  gold.fresnel.values.set("k", Rgb{3.98, 2.39, 1.60});
  const Material m = build(gold);
  REQUIRE(m.channels() == 3);
  const Direction o = from_angles(0.5, 0), i = from_angles(0.8, 3), h = half_vector(o, i);
  std::array<double, 3> out{};
  evaluate(m, Quantity::brdf, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, out.data());
  const double white = value(material("ggx", 0.3), Quantity::brdf, o, i);
  const double eta[] = {0.14, 0.38, 1.44}, k[] = {3.98, 2.39, 1.60};
  for (std::size_t channel = 0; channel < 3; ++channel)
    CHECK(relative(out[channel], white * conductor_reflectance(dot(o, h), eta[channel], k[channel])) < 1e-14);
  CHECK(material("ggx", 0.3).channels() == 1);
}

TEST_CASE("what a quantity needs is asked for by name") {
  const Material smith = material("ggx", 0.5), cavity = material("ggx", 0.5, "v_cavity");
  CHECK_THROWS_WITH_AS(lambda(cavity, {0, 0, 1}), doctest::Contains("no Lambda"), InputError);
  CHECK_THROWS_WITH_AS(g1(cavity, {0, 0, 1}), doctest::Contains("theta_m"), InputError);
  CHECK_THROWS_WITH_AS(evaluate(smith, Quantity::brdf, {0, 0, 1}, std::nullopt, std::nullopt),
                       doctest::Contains("theta_i"), InputError);
  CHECK(g1(smith, from_angles(1, 0)) == doctest::Approx(1 / (1 + lambda(smith, from_angles(1, 0)))));
}

TEST_CASE("what cannot be built is refused with its place") {
  const auto pointer = [](const TermDescription& description) {
    try {
      build(description);
    } catch (const MaterialError& error) {
      return error.pointer();
    }
    return std::string("built");
  };
  CHECK(pointer(describe("ggxx", 0.5)) == "/distribution/type");
  CHECK(pointer(describe("ggx", 0)) == "/distribution/alpha");
  CHECK(pointer(describe("ggx", 0.5, "smit")) == "/masking/type");
  CHECK(pointer(shadowed(describe("ggx", 0.5, "v_cavity"), "height_correlated")) == "/shadowing/type");
  CHECK(pointer(shadowed(describe("ggx", 0.5), "direction_correlated")) == "/shadowing");
  CHECK(pointer(general("ggx", 0.1, 0.2, 1)) == "/distribution/correlation");
  TermDescription both = general("ggx", 0.1, 0.2, 0);
  both.distribution.values.set("alpha", 0.3);
  CHECK(pointer(both).starts_with("/distribution/alpha"));
  set_parameter(both, "alpha", 0.3); // displaces the other alternative
  CHECK(pointer(both) == "built");
  CHECK_THROWS_AS(set_parameter(both, "alhpa", 1), MaterialError);
}
