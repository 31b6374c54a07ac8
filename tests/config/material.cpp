#include "config/load.hpp"
#include "temp_files.hpp"

#include <vector>

namespace {

using namespace brdfplot;
using test::contains;
using test::error_of;
using test::TempFolder;

struct BadMaterial {
  std::string text;
  std::string pointer;
  std::vector<std::string> says;
};

std::string with(const std::string& rest) { return R"({"distribution": {"type": "ggx", "alpha": 0.5}, )" + rest + "}"; }
std::string ggx(const std::string& rest) { return R"({"distribution": {"type": "ggx")" + rest + "}}"; }

void check_all(const std::vector<BadMaterial>& cases) {
  const TempFolder folder;
  for (const auto& one : cases) {
    CAPTURE(one.text);
    const auto path = folder.write("m.json", one.text);
    const std::string error = error_of(folder, 2, [&] { config::load_material(path); });
    CAPTURE(error);
    CHECK(error.substr(0, error.find(": ", 8)) == "m.json: " + one.pointer);
    for (const auto& part : one.says) CHECK_MESSAGE(contains(error, part), part);
  }
}

TermDescription load(const std::string& text) {
  const TempFolder folder;
  MaterialDescription material = config::load_material(folder.write("stem of.the file.json", text));
  TermDescription& term = material.terms.at(0);
  term.name = material.name;
  return term;
}

} // namespace

TEST_CASE("materials: names, parameters and what is left to defaults") {
  const auto plain =
      load(R"({"$schema": "https://example.org/s.json", "distribution": {"type": "ggx", "alpha": 0.5}})");
  CHECK(plain.name == "stem of.the file");
  CHECK(plain.distribution.type == "ggx");
  CHECK(plain.distribution.values.number("alpha") == 0.5);
  CHECK(plain.masking.type == "smith");
  CHECK(!plain.shadowing);
  CHECK(plain.fresnel.type == "none");
  CHECK(build(plain).channels() == 1);

  const auto full = load(R"({"name": "α", "facet": "specular",
    "distribution": {"type": "beckmann", "alpha_x": 1, "alpha_y": 0.25, "correlation": -0.5, "mean_slope": [0.5, -1]},
    "shadowing": {"type": "height_direction_correlated", "lambda": "ashikhmin"}})");
  CHECK(full.name == "α");
  const SlopeMap slopes = build(full).surface().slopes();
  CHECK(slopes.alpha_x == 1);
  CHECK(slopes.alpha_y == 0.25);
  CHECK(slopes.correlation == -0.5);
  CHECK(slopes.mean_x == 0.5);
  CHECK(slopes.mean_y == -1);
  CHECK(full.shadowing->values.text("lambda") == "ashikhmin");
}

TEST_CASE("materials: a Fresnel value is a number or three") {
  const auto grey = load(with(R"("fresnel": {"type": "schlick", "f0": 0.04})"));
  CHECK(build(grey).channels() == 1);
  const auto coloured = load(with(R"("fresnel": {"type": "conductor", "eta": [0.1, 0.4, 1.4], "k": 2})"));
  CHECK(build(coloured).channels() == 3);
  const auto conductor = std::get<ConductorFresnel>(*build(coloured).terms[0].fresnel());
  CHECK(conductor.eta == Rgb{0.1, 0.4, 1.4});
  CHECK(conductor.k == Rgb{2, 2, 2});
}

TEST_CASE("materials: shadowing follows from masking where it is not given") {
  const auto shadowing_of = [](const std::string& masking) {
    return build(load(with(R"("masking": {"type": ")" + masking + "\"}"))).surface().shadowing;
  };
  for (const std::string masking : {"smith", "smith_rational", "schlick_smith", "schlick_smith_rational"})
    CHECK_MESSAGE(std::holds_alternative<HeightCorrelated>(shadowing_of(masking)), masking);
  CHECK(std::holds_alternative<Minimum>(shadowing_of("v_cavity")));
  for (const std::string masking : {"implicit", "kelemen"})
    CHECK_MESSAGE(std::holds_alternative<Separable>(shadowing_of(masking)), masking);
}

TEST_CASE("materials: unknown keys and names, with the nearest accepted one") {
  check_all({
      {"[]", "/", {"found an array of 0", "accepted: an object"}},
      {"3", "/", {"found 3", "an object"}},
      {"{}", "/", {"\"distribution\" is missing"}},
      {R"({"distribusion": {}})", "/distribusion", {"unknown key \"distribusion\"", "did you mean \"distribution\"?"}},
      {with(R"("colour": 1)"), "/colour", {"unknown key \"colour\"", "accepted: name, distribution, masking"}},
      {ggx(R"(, "alpha": 1, "$schema": "x")"), "/distribution/$schema", {"unknown key"}},
      {ggx(R"(, "alhpa": 1)"), "/distribution/alhpa", {"unknown key \"alhpa\"; did you mean \"alpha\"?"}},
      {R"({"distribution": {"type": "gxx", "alpha": 1}})", "/distribution/type", {"\"gxx\"; did you mean \"ggx\"?"}},
      {R"({"distribution": {"alpha": 1}})", "/distribution", {"\"type\" is missing", "\"beckmann\", \"ggx\""}},
      {with(R"("masking": {"type": "smiht"})"), "/masking/type", {"did you mean \"smith\"?", "v_cavity"}},
      {with(R"("claims": ["physicaly_based"])"), "/claims/0", {"did you mean \"physically_based\"?", "eq37"}},
      {with(R"("facet": "difuse")"),
       "/facet",
       {"\"difuse\"", "accepted: specular, diffuse, oren_nayar, oren_nayar_direct, oren_nayar_qualitative"}},
      {with(R"("facet": "diffuse", "fresnel": {"type": "schlick", "f0": 1})"),
       "/fresnel/type",
       {"\"schlick\"", "accepted: none"}},
      {with(R"("shadowing": {"type": "direction_correlated"})"),
       "/shadowing",
       {"\"lambda\" is missing", "\"ginneken\""}},
      {with(R"("shadowing": {"type": "direction_correlated", "lambda": "heitz2013"})"),
       "/shadowing/lambda",
       {"\"heitz2013\"", "accepted: ashikhmin, ginneken, fitted"}},
      {with(R"("fresnel": {"type": "schlick"})"), "/fresnel", {"\"f0\" is missing"}},
      {with("\"a\\nb\": 1"), "/a\\nb", {"unknown key \"a\\nb\""}},
  });
}

TEST_CASE("materials: wrong types at every level") {
  check_all({
      {R"({"distribution": "ggx"})", "/distribution", {"found \"ggx\"", "an object with \"type\""}},
      {R"({"distribution": {"type": 1}})", "/distribution/type", {"found 1", "\"ggx\""}},
      {ggx(R"(, "alpha": "0.5")"), "/distribution/alpha", {"found \"0.5\"", "a number in [1e-06, "}},
      {ggx(R"(, "alpha": null)"), "/distribution/alpha", {"found null"}},
      {ggx(R"(, "alpha": true)"), "/distribution/alpha", {"found true"}},
      {ggx(R"(, "alpha": [1])"), "/distribution/alpha", {"found an array of 1"}},
      {ggx(R"(, "alpha": 1, "mean_slope": 1)"), "/distribution/mean_slope", {"an array of 2 items"}},
      {ggx(R"(, "alpha": 1, "mean_slope": [1])"), "/distribution/mean_slope", {"found 1 items"}},
      {ggx(R"(, "alpha": 1, "mean_slope": [1, "2"])"), "/distribution/mean_slope/1", {"found \"2\""}},
      {with(R"("name": 1)"), "/name", {"found 1", "a string"}},
      {with(R"("facet": {})"), "/facet", {"found an object", "\"specular\""}},
      {with(R"("fresnel": {"type": "schlick", "f0": [0.1, 0.2]})"), "/fresnel/f0", {"found 2 items"}},
      {with(R"("fresnel": {"type": "schlick", "f0": "0.1"})"), "/fresnel/f0", {"found \"0.1\""}},
      {with(R"("name": ")" + std::string(500, 'x') + "\", \"facet\": \"" + std::string(100, 'y') + "\""), "/facet", {}},
  });
}

TEST_CASE("materials: numbers out of bounds") {
  check_all({
      {ggx(R"(, "alpha": 0)"), "/distribution/alpha", {"found 0, accepted: a number in [1e-06, 1e+06]"}},
      {ggx(R"(, "alpha": -1)"), "/distribution/alpha", {"found -1"}},
      {ggx(R"(, "alpha": 1e-999)"), "/distribution/alpha", {"a number in [1e-06, "}},
      {ggx(R"(, "alpha_x": 1, "alpha_y": -0.0)"), "/distribution/alpha_y", {"a number in [1e-06, "}},
      {ggx(R"(, "alpha_x": 1e-4, "alpha_y": 1e4)"),
       "/distribution",
       {"alpha_x = 1e-04", "alpha_y = 10000", "[1, 1e+06]"}},
      {ggx(R"(, "alpha": 1, "correlation": 1)"), "/distribution/correlation", {"found 1", "in (-1, 1)"}},
      {ggx(R"(, "alpha": 1, "correlation": -1)"), "/distribution/correlation", {"found -1"}},
      {R"({"distribution": {"type": "phong", "exponent": -1}})",
       "/distribution/exponent",
       {"found -1", "in (-1, 2e+12]"}},
      {R"({"distribution": {"type": "phong", "alpha": 1.5}})", "/distribution/alpha", {"found 1.5", "[1e-06, 1.41421"}},
      {with(R"("fresnel": {"type": "dielectric", "eta": 0})"),
       "/fresnel/eta",
       {"found 0, accepted: a number in [1e-06, 1e+06]"}},
      {with(R"("fresnel": {"type": "dielectric", "eta": [1.5, 1.5, 0]})"), "/fresnel/eta/2", {"found 0"}},
      {with(R"("fresnel": {"type": "schlick", "f0": 1.1})"), "/fresnel/f0", {"found 1.1", "[0, 1]"}},
  });
}

TEST_CASE("materials: exactly one of the alternatives, whole") {
  const std::string accepted = "accepted: either alpha, or alpha_x with alpha_y, or roughness, or roughness with "
                               "disney_anisotropy, or roughness with imageworks_anisotropy, or roughness with "
                               "roughness_convention, or alpha with mean_normal_length";
  check_all({
      {ggx(""),
       "/distribution",
       {"found none of alpha, alpha_x, alpha_y, roughness, disney_anisotropy, imageworks_anisotropy, "
        "roughness_convention, mean_normal_length; " +
        accepted}},
      {ggx(R"(, "alpha_x": 1)"), "/distribution", {"found alpha_x alone; " + accepted}},
      {ggx(R"(, "alpha": 1, "alpha_x": 1)"), "/distribution", {"found alpha with alpha_x; " + accepted}},
      {ggx(R"(, "alpha": 1, "alpha_x": 1, "alpha_y": 1)"), "/distribution", {"found alpha with alpha_x with alpha_y"}},
      {ggx(R"(, "disney_anisotropy": 0.5)"), "/distribution", {"found disney_anisotropy alone; " + accepted}},
      {ggx(R"(, "roughness": 0.5, "alpha": 0.5)"), "/distribution", {"found alpha with roughness; " + accepted}},
      {ggx(R"(, "roughness": 0.5, "imageworks_anisotropy": 1)"), "/distribution/imageworks_anisotropy", {"(-1, 1)"}},
      {R"({"distribution": {"type": "phong", "alpha": 1, "exponent": 2}})",
       "/distribution",
       {"found exponent with alpha; accepted: either exponent, or alpha"}},
  });
}

TEST_CASE("materials: a shape that is no density of slopes says why and where") {
  const auto custom = [](const std::string& shape) {
    return R"({"distribution": {"type": "custom", "alpha": 0.5, "shape": ")" + shape + "\"}}";
  };
  const std::string at = "/distribution/shape";
  check_all({
      {custom("exp(-t3)"), at, {"\"t3\" found at position 5", "did you mean \"t2\"?"}},
      {custom("exp(-t2"), at, {"Missing parenthesis at position"}},
      {custom("t2 = 1"), at, {"assignment at position 3; == compares"}},
      {custom("1 / (1 + t2)"), at, {"falls like t2^-1 to infinity", "its mass is infinite"}},
      {custom("1"), at, {"falls like t2^0 to infinity", "its mass is infinite"}},
      {custom("1 / (1 + t2)^1.4"), at, {"falls like t2^-1.4 to infinity", "its mean slope is infinite"}},
      {custom("exp(-t2) * (1 - t2)"), at, {"is negative (-0.0", "at t2 = 1.0"}},
      {custom("exp(-t2) / (t2 - 4)^2"), at, {"is infinite at t2 = 4"}},
      {custom("exp(-t2) / t"), at, {"is infinite at t2 = 0", "accepted: finite and not negative from t2 = 0 on"}},
      {custom("1 / ((1 + t2)^1.5 * log(3 + t2)^2)"), at, {"too slowly for its mean slope"}},
      {custom("exp(-1e10 * t2)"), at, {"half of the shape is within t2 = 1e-10", "[1e-04, 10000]"}},
      {custom("1e200 * exp(-t2)"), at, {"e+199, accepted: a number in [1e-50, 1e+50]"}},
      {custom("sin(t) / t"), at, {"is not a number at t2 = 0"}},
      {custom("sqrt(2 - t2)"), at, {"is not a number at t2 = 2.0"}},
      {custom("0 * t"), at, {"is 0 wherever"}},
      {R"({"distribution": {"type": "custom", "alpha": 0.5}})", "/distribution", {"\"shape\" is missing"}},
  });
}

TEST_CASE("materials: mixtures tell which component is wrong, and fits refuse what they do not fit") {
  const auto mixture = [](const std::string& components) {
    return R"({"distribution": {"type": "mixture", "components": [)" + components + "]}}";
  };
  const std::string good = R"({"weight": 1, "distribution": {"type": "ggx", "alpha": 0.1}})";
  const std::string at = "/distribution/components";
  check_all({
      {mixture(""), at, {"1 to 64 items"}},
      {mixture(good + R"(, {"weight": 0, "distribution": {"type": "ggx", "alpha": 0.1}})"),
       at + "/1/weight",
       {"in [1e-100, 1e+100]"}},
      {mixture(good + R"(, {"weight": 1, "distribution": {"type": "ggx"}})"),
       at + "/1/distribution",
       {"none of alpha"}},
      {mixture(good + R"(, {"weight": 1, "distribution": {"type": "mixture"}})"), at + "/1/distribution/type", {"ggx"}},
      {mixture(good + R"(, {"weight": 1, "distribution": {"type": "custom", "alpha": 1, "shape": "1"}})"),
       at + "/1/distribution/shape",
       {"its mass is infinite"}},
      {mixture(good + R"(, {"weight": 1, "distribution": {"type": "ggx", "alpha": 1, "slope_variance": 1}})"),
       at + "/1/distribution/slope_variance",
       {"the slopes of \"ggx\" have no finite variance", "accepted in \"beckmann\" alone"}},
      {with(R"("masking": {"type": "sheen_fit"})"), "/masking/type", {"a fit for the distribution \"sheen\" alone"}},
  });
  CHECK_NOTHROW(load(mixture(good + ", " + good)));
  CHECK_NOTHROW(
      load(mixture(good + R"(, {"weight": 1, "distribution": {"type": "ggx", "alpha": 1, "mean_slope": [1, 0]}})")));
}

TEST_CASE("materials: second moments of a normal map") {
  const auto beckmann = [](const std::string& rest) {
    return R"({"distribution": {"type": "beckmann", "alpha": 0.1)" + rest + "}}";
  };
  check_all({
      {beckmann(R"(, "slope_moments": [0.1, 0.1])"), "/distribution/slope_moments", {"3"}},
      {beckmann(R"(, "slope_moments": [0.1, 0.1, 0], "slope_variance": 0.1)"),
       "/distribution",
       {"found alpha with slope_moments with slope_variance"}},
      {beckmann(R"(, "slope_moments": [0.1, 0.1, 0.2])"), "/distribution/slope_moments", {"a variance of -0.1"}},
      {ggx(R"(, "alpha": 0.1, "slope_moments": [0.1, 0.1, 0])"),
       "/distribution/slope_moments",
       {"the slopes of \"ggx\" have no finite variance"}},
  });
  CHECK_NOTHROW(load(beckmann(R"(, "slope_moments": [0.1, 0.1, 0.05], "mean_slope": [0.1, 0])")));
}

TEST_CASE("materials: joint shadowing that the masking function does not allow") {
  for (const std::string masking : {"v_cavity", "implicit", "kelemen"}) {
    for (const std::string shadowing :
         {R"("height_correlated")", R"("height_direction_correlated", "lambda": "ginneken")"}) {
      check_all({{with(R"("masking": {"type": ")" + masking + R"("}, "shadowing": {"type": )" + shadowing + "}"),
                  "/shadowing/type",
                  {"needs a masking function with a Lambda", "\"" + masking + "\"",
                   "accepted: none, separable, minimum, direction_correlated"}}});
    }
    CHECK_NOTHROW(load(with(R"("masking": {"type": ")" + masking + R"("}, "shadowing": {"type": "separable"})")));
  }
}
