// Which terms are reciprocal is measured, of every type that there is: alone, in sums, measured data too.
#include "../brdf/rgl_file.hpp"
#include "analysis/property_tests.hpp"
#include "brdf/measured/merl_writer.hpp"
#include "config/load.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace test;

namespace {

struct Case {
  std::string terms; ///< JSON
  bool reciprocal;
};

const std::string ggx = R"("distribution": {"type": "ggx", "alpha": 0.5})";
const std::string mirror = R"({"type": "mirror", )" + ggx + R"(, "fresnel": {"type": "schlick", "f0": 0.5}})";

std::vector<Case> cases() {
  return {
      {mirror, true},
      {R"({"type": "mirror", "shadowing": {"type": "none"}, )" + ggx + "}", false},
      {R"({"type": "kelemen", )" + ggx + "}", true},
      {R"({"type": "complement", "of": )" + mirror + "}", true},
      {R"({"type": "multiple_bounce", "of": )" + mirror + "}", true},
      {R"({"type": "turquin", "of": )" + mirror + "}", false},
      {R"({"type": "oren_nayar", "sigma": 0.5})", true},
      {R"({"type": "oren_nayar", "sigma": 1, "form": "direct"})", true},
      {R"({"type": "fujii_oren_nayar", "roughness": 1})", true},
      {R"({"type": "eon", "roughness": 1})", true},
      {R"({"type": "lambert"})", true},
      {R"({"type": "fresnel_lambert", "at": "normal"})", false},
      {R"({"type": "fresnel_lambert", "at": "half"})", true},
      {R"({"type": "shirley"})", true},
      {R"({"type": "disney_diffuse", "alpha": 0.5, "subsurface": 0.5})", true},
      {R"({"type": "hammon_diffuse", "alpha": 0.5})", true},
      {R"({"type": "disney_sheen"})", true},
      {R"({"type": "velvet_cloth", "alpha": 0.5, "amplitude": 10})", true},
      {R"({"type": "uncharted2", "rim": 1, "rim_power": 2, "inner": 1, "inner_power": 3, "diffuse": 0.3})", false},
      {R"({"type": "wrap", "w": 0.5})", false},
      {R"({"type": "merl", "file": "lambert.binary"})", true},
      {R"({"type": "rgl", "file": "ggx.bsdf"})", false}, // interpolated in one direction
      {R"({"type": "coated", "coat": )" + mirror + R"(, "base": [{"type": "lambert"}]})", true},
      {R"({"type": "coated", "attenuation": "half", "coat": )" + mirror + R"(, "base": [{"type": "lambert"}]})", false},
      {R"({"type": "mirror", "shadowing": {"type": "hammon"}, )" + ggx + "}", true},
      {R"({"type": "mirror", "shadowing": {"type": "neubelt"}, )" + ggx + "}", true},
      {R"({"type": "mirror", "masking": {"type": "karis"}, )" + ggx + "}", true},
      {mirror + R"(, {"type": "lambert"})", true},
      {mirror + R"(, {"type": "fresnel_lambert", "at": "normal"})", false},
      {R"({"type": "lambert"}, {"type": "wrap", "w": 0.1, "weight": 0.1})", false},
  };
}

} // namespace

TEST_CASE("reciprocity is measured: of every type of term, of sums and of files") {
  const MeasuredFolder folder;
  const Material material = test::material("ggx", 0.5);
  TermDescription lambert;
  lambert.type = "lambert";
  folder.write("lambert.binary", merl_bytes(build(lambert), 2, {6, 6, 8}));
  RglSizes sizes;
  sizes.normals = 12, sizes.colours = 8, sizes.thetas = 6;
  folder.write("ggx.bsdf", tensor_bytes(rgl_of(material, sizes, folder)));
  for (const Case& one : cases()) {
    const std::string path = folder.write("material.json", R"({"terms": [)" + one.terms + "]}");
    const PropertySubject subject{config::load_material(path)};
    WorstResidual worst(1e-6);
    test_property(Property::reciprocity, subject, {}, worst);
    CAPTURE(one.terms);
    CHECK(worst.residual().verdict == (one.reciprocal ? Verdict::holds : Verdict::fails));
    CHECK((worst.residual().max_residual > 1e-3) == !one.reciprocal);
  }
  for (const TermSpec& term : term_specs()) {
    const std::string quoted = "\"type\": \"" + term.spec.type + "\"";
    CAPTURE(term.spec.type);
    // Facets that are diffuse take a quadrature a value: tests/brdf/diffuse.cpp.
    if (term.spec.type != "facet_diffuse")
      CHECK(std::ranges::any_of(cases(), [&](const Case& one) { return one.terms.find(quoted) != std::string::npos; }));
  }
}
