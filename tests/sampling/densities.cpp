#include "materials.hpp"

#include "base/random.hpp"
#include "sampling/sampler.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace test;

namespace {

/// Pairs all over the sphere, each with a viewer of its own; the last ones are opposite, and below the horizon.
struct Pairs {
  DirectionArrays o, i;

  explicit Pairs(std::size_t n) {
    Random random(7, 0);
    const auto direction = [&] {
      return from_angles(std::acos(2 * random.uniform() - 1), 2 * std::numbers::pi * random.uniform());
    };
    o.resize(n + 2), i.resize(n + 2);
    for (std::size_t k = 0; k < n; ++k) {
      const Direction viewer = direction();
      o.set(k, {viewer.x, viewer.y, std::fabs(viewer.z)});
      i.set(k, direction());
    }
    const Direction last = o.view()[0];
    o.set(n, last), i.set(n, -1.0 * last);
    o.set(n + 1, {last.x, last.y, -last.z}), i.set(n + 1, i.view()[0]);
  }
  std::size_t size() const { return o.x.size(); }
};

std::vector<double> densities(const Sampler& sampler, const Pairs& pairs) {
  std::vector<double> out(pairs.size());
  sampler.densities(pairs.size(), pairs.o.view(), pairs.i.view(), out.data());
  return out;
}

double density(const Sampler& sampler, const Direction& o, const Direction& i) {
  double out = 0;
  sampler.densities(1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, &out);
  return out;
}

TermDescription of_type(const std::string& type) {
  TermDescription description;
  description.type = description.name = type;
  return description;
}

/// A specular term of Kelemen and Szirmay-Kalos with what it leaves.
MaterialDescription coupled() {
  TermDescription specular = of_type("kelemen"), matte = of_type("complement");
  specular.distribution = test::distribution("beckmann", {{"alpha", 0.3}}).distribution;
  specular.fresnel = {"schlick", {}};
  specular.fresnel.values.set("f0", Rgb{0.9, 0.5, 0.1});
  matte.of.push_back(specular);
  return {"both", {specular, matte}, true};
}

} // namespace

TEST_CASE("the density of a pair is the same in whatever batch it is") {
  const Pairs pairs(700);
  const MaterialDescription sum("sum", {general("ggx", 0.1, 0.4, 0.3), of_type("lambert")}, true);
  const TermDescription mixed = mixture({{0.7, test::distribution("ggx", {{"alpha", 0.1}}).distribution},
                                         {0.3, test::distribution("beckmann", {{"alpha", 0.6}}).distribution}});
  TermDescription eon = of_type("eon");
  eon.values.set("roughness", 0.6);
  const std::pair<Material, const char*> all[] = {{material("beckmann", 0.3), "visible_normals"},
                                                  {material("ggx", 0.3), "heitz_2018"},
                                                  {material("sheen", 0.5), "half_vector"},
                                                  {build(mixed), "visible_normals"},
                                                  {build(eon), "eon"},
                                                  {build(sum), "default"},
                                                  {build(coupled()), "kelemen"}};
  for (const auto& one : all) {
    const Sampler sampler(one.first, one.second);
    const std::vector<double> batch = densities(sampler, pairs);
    CAPTURE(one.first.name);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      CHECK(batch[k] == density(sampler, pairs.o.view()[k], pairs.i.view()[k]));
    CHECK(batch[pairs.size() - 1] == 0);
  }
}

TEST_CASE("densities are those of Heitz 2014, Eq. 16, and of D cos theta_m, mirrored") {
  const Pairs pairs(700);
  for (const auto* type : {"beckmann", "ggx", "student_t"}) {
    TermDescription description = general(type, 0.3, 0.6, -0.4, {0.1, -0.2});
    if (std::string(type) == "student_t") description.distribution.values.set("gamma", 2.5);
    const Material material = build(description);
    const std::vector<double> visible = densities(Sampler(material, "visible_normals"), pairs);
    const std::vector<double> ground = densities(Sampler(material, "half_vector"), pairs);
    for (std::size_t k = 0; k + 2 < pairs.size(); ++k) {
      const Direction o = pairs.o.view()[k], h = half_vector(o, pairs.i.view()[k]);
      const Projection p = material.mesosurface().project(o);
      const double facing = dot(o, h);
      if (!(p.c > 1e-3 && std::fabs(h.z) > 1e-3)) continue;
      const double d = value_at_normal(material, Quantity::d, o, h);
      const double turned = value_at_normal(material, Quantity::d, o, h.z < 0 ? -1.0 * h : h);
      CAPTURE(type);
      CAPTURE(k);
      CHECK(visible[k] == doctest::Approx(d / (4 * p.c * (1 + lambda(material, o)))).epsilon(1e-12));
      CHECK(ground[k] == doctest::Approx(turned * std::fabs(h.z) / (4 * facing)).epsilon(1e-12));
    }
  }
}
