#include "brdf/evaluate.hpp"
#include "cli/fit_program.hpp"
#include "config/load.hpp"

using namespace test;
using namespace brdfplot;

namespace {

/// A material, its file or its JSON, and how the comments of its code say that G1 and G2 are called: directions are
/// p[0..2] and p[3..5], and p[6] is their difference in azimuth.
struct Case {
  std::string name;
  std::string material;
  std::string one; ///< arguments of Lambda and of G1
  std::string two; ///< of G2
};

const std::string vectors_one = "T(p[0]), T(p[1]), T(p[2])";
const std::string vectors_two = vectors_one + ", T(p[3]), T(p[4]), T(p[5])";

Case by_vectors(const std::string& name, const std::string& material, const std::string& surface) {
  return {name, material, vectors_one + surface, vectors_two + surface};
}

Case by_cosines(const std::string& name, const std::string& material, const std::string& more,
                const std::string& phi = "") {
  return {name, material, "T(p[2])" + more, "T(p[2]), T(p[5])" + more + phi};
}

std::string shadowed(const std::string& distribution, const std::string& shadowing) {
  return R"({"name": "own", "distribution": )" + distribution + R"(, "shadowing": )" + shadowing + "}";
}

std::vector<Case> cases() {
  const std::string sheared =
      R"({"type": "beckmann", "alpha_x": 0.25, "alpha_y": 0.75, "correlation": -0.5, "mean_slope": [0.25, -0.125]})";
  const std::string tilted = R"({"type": "ggx", "alpha": 0.5, "mean_slope": [0, 0.5]})";
  const std::string isotropic = R"({"type": "beckmann", "alpha": 0.5})";
  return {
      by_vectors("rough_gold", "configs/materials/rough_gold.json", ", T(0.2), T(0.5), T(0.1)"),
      by_vectors("brushed_steel", "configs/materials/brushed_steel.json", ", T(0.4724555912615341), T(0.13228756555)"),
      by_vectors("student_s_t", "configs/materials/student_t.json", ", T(0.15), T(0.4), T(3)"),
      by_cosines("phong_plastic", "configs/materials/phong.json", ", T(50)"),
      by_cosines("gtr_with_a_long_tail", "configs/materials/gtr.json", ", T(0.2)"),
      by_cosines("beckmann", "configs/materials/beckmann.json", ", T(0.3)"),
      by_cosines("two_lobes", "configs/materials/two_lobes.json", ""),
      by_cosines("felt", "configs/materials/felt.json", ", T(0.8)"),
      by_vectors("own", shadowed(sheared, R"({"type": "separable"})"),
                 ", T(0.25), T(0.75), T(-0.5), T(0.25), T(-0.125)"),
      by_vectors("own", shadowed(tilted, R"({"type": "height_correlated"})"), ", T(0.5), T(0.5), T(0), T(0.5)"),
      by_vectors("own", shadowed(sheared, R"({"type": "direction_correlated", "lambda": "ashikhmin"})"),
                 ", T(0.25), T(0.75), T(-0.5), T(0.25), T(-0.125)"),
      by_cosines("own", shadowed(isotropic, R"({"type": "none"})"), ", T(0.5)"),
      by_cosines("own", shadowed(isotropic, R"({"type": "minimum"})"), ", T(0.5)"),
      by_cosines("own", shadowed(isotropic, R"({"type": "direction_correlated", "lambda": "ginneken"})"), ", T(0.5)",
                 ", T(p[6])"),
      by_cosines("own", shadowed(isotropic, R"({"type": "height_direction_correlated", "lambda": "ashikhmin"})"),
                 ", T(0.5)", ", T(p[6])")};
}

/// A direction with a cosine that is a float; unit in double, since a code that is given its cosine is given no more.
Direction direction(double cosine, double phi) {
  const double c = as_float(cosine), sine = std::sqrt((1 - c) * (1 + c));
  return {sine * std::cos(phi), sine * std::sin(phi), c};
}

/// Pairs of directions as seven numbers; above the horizon of the mesosurface, on it and below.
std::vector<std::vector<double>> pairs() {
  std::vector<std::vector<double>> all;
  for (const double theta_o : {0.0, 10.0, 40.0, 60.0, 75.0, 82.0, 88.0, 89.9, 90.0, 100.0})
    for (const double theta_i : {5.0, 50.0, 80.0, 89.0})
      for (const double phi_o : {0.0, 45.0, 110.0, 200.0, 317.0})
        for (const double phi : {0.0, 1.0, 30.0, 90.0, 180.0}) {
          const double degree = std::numbers::pi / 180;
          const Direction o = direction(std::cos(theta_o * degree), phi_o * degree);
          const Direction i = direction(std::cos(theta_i * degree), (phi_o + phi) * degree);
          all.push_back({o.x, o.y, o.z, i.x, i.y, i.z, phi * degree});
        }
  return all;
}

/// How much further off than printed each precision may be: the arguments are rounded to float before the code begins,
/// which it cannot know.
struct Allowance {
  double g1 = 0;
  double g2 = 0;
};

/// `unit`: of the arguments. Parameters and vectors: |d ln G1| <= |d ln s| + |d ln c|, of 8 roundings (a gamma of 3, an
/// exponent and alpha of the fits in two variables have a slope no larger); c of a sheared surface: as the comment
/// says. phi: |d G2| <= |d lambda| min(Lambda) G2, with |d lambda / d phi| <= 4.41, of 4 roundings of a unit vector.
Allowance allowance(const Material& material, const std::vector<double>& p, double unit) {
  const auto of_side = [&](const Direction& d) {
    const SlopeMap& map = material.surface().slopes();
    const double terms = std::fabs(d.z) + std::fabs(d.x * map.mean_x) + std::fabs(d.y * map.mean_y);
    return 8 * unit + (map.centred() ? 0 : 5 * unit * terms / map.project(d).c);
  };
  const Direction o{p[0], p[1], p[2]}, i{p[3], p[4], p[5]};
  const auto lambda = [&](const Direction& d) {
    return evaluate(material, Quantity::lambda, d, std::nullopt, std::nullopt);
  };
  const double sines = std::hypot(o.x, o.y) * std::hypot(i.x, i.y);
  const double of_phi = sines > 0 ? 4.41 * 4 * unit / sines * std::min({lambda(o), lambda(i), 1.0}) : 0;
  return {of_side(o), of_side(o) + of_side(i) + of_phi};
}

/// Lambda, G1 and G2 of each of double, float, GLSL and HLSL.
void check_row(const Material& material, const std::string& code, const std::vector<double>& p,
               const std::vector<double>& row) {
  const Direction o{p[0], p[1], p[2]}, i{p[3], p[4], p[5]};
  const double g1 = evaluate(material, Quantity::g1, o, std::nullopt, std::nullopt);
  const double lambda = evaluate(material, Quantity::lambda, o, std::nullopt, std::nullopt);
  const double g2 = evaluate(material, Quantity::g2, o, i, std::nullopt);
  for (std::size_t k = 0; k < 4; ++k) {
    INFO("column " << k << ": o " << o.x << " " << o.y << " " << o.z << ", i " << i.x << " " << i.y << " " << i.z);
    const PrintedBounds printed = printed_bounds(code, k == 0 ? "double" : "float");
    const Allowance more = allowance(material, p, k == 0 ? 0x1p-53 : 0x1p-24);
    CHECK(row[k] >= 0);
    if (g1 > 0) CHECK(std::fabs(row[k] - lambda) <= 1.001 * (printed.g1 + more.g1) * (1 + lambda));
    CHECK(row[4 + k] <= 1);
    CHECK(std::fabs(row[4 + k] - g1) <= (printed.g1 + more.g1) * g1);
    CHECK(std::fabs(row[8 + k] - g2) <= (printed.g2 + more.g2) * g2);
  }
}

} // namespace

TEST_CASE("the code of a material gives its G1, Lambda and G2 at every azimuth, as far off as it says") {
  for (const Case& c : sample_of(cases(), 6)) {
    INFO(c.material);
    const Folder folder;
    const bool own = c.material.starts_with("{");
    if (own) folder.write("own.json", c.material);
    const std::string file = own ? "own.json" : c.material;
    check_output(folder, "brdfplot fit " + file + " -o out");
    const std::string code = folder.read("out/" + c.name + ".hpp");
    build_fit_program(
        folder, c.name, 7,
        {c.name + "_lambda(" + c.one + ")", c.name + "_g1(" + c.one + ")", c.name + "_g2(" + c.two + ")"});
    const Material material = build(config::load_material((folder.path() / file).string()));
    const auto points = pairs();
    const auto rows = run_fit_program(folder, c.name, points);
    for (std::size_t k = 0; k < rows.size(); ++k) check_row(material, code, points[k], rows[k]);
  }
}

TEST_CASE("the code of rough gold at 75 degrees is what eval says") {
  const Folder folder;
  check_output(folder, "brdfplot fit configs/materials/rough_gold.json -o out");
  build_fit_program(folder, "rough_gold", 3, {"rough_gold_g1(T(p[0]), T(p[1]), T(p[2]), T(0.2), T(0.5), T(0.1))"});
  folder.write("points.csv", "theta_o,phi_o\n75deg,45deg\n");
  const double g1 =
      number(check_output(folder, "brdfplot eval configs/materials/rough_gold.json -q g1 -i points.csv"), 0, 2);
  CHECK(g1 == doctest::Approx(0.7201).epsilon(1e-4));
  const double theta = 75 * std::numbers::pi / 180, along = std::sin(theta) * std::numbers::sqrt2 / 2;
  const auto row = run_fit_program(folder, "rough_gold", {{along, along, std::cos(theta)}})[0];
  for (const double value : row) CHECK(value == doctest::Approx(g1).epsilon(1e-4));
}

TEST_CASE("an anisotropic material without slope keeps the functions of a cosine and alpha_o") {
  const Folder folder;
  check_output(folder, "brdfplot fit configs/materials/brushed_steel.json -o out");
  build_fit_program(folder, "brushed_steel", 4,
                    {"brushed_steel_g1(T(p[0]), T(p[1]))", "brushed_steel_lambda(T(p[0]), T(p[1]))"});
  const Material material =
      build(config::load_material((folder.path() / "configs/materials/brushed_steel.json").string()));
  const Direction o = direction(0.25, 1);
  const double alpha = material.surface().slopes().project(o).s / std::hypot(o.x, o.y);
  const auto row = run_fit_program(folder, "brushed_steel", {{o.z, alpha, 0, 0}})[0];
  const double g1 = evaluate(material, Quantity::g1, o, std::nullopt, std::nullopt);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(row[k] == doctest::Approx(g1).epsilon(1e-4));
    CHECK(row[4 + k] == doctest::Approx(1 / g1 - 1).epsilon(1e-3));
  }
}

TEST_CASE("shaders of a material whose azimuth counts compile") {
  const Folder folder;
  folder.write("own.json", cases()[10].material);
  check_output(folder, "brdfplot fit own.json -o out");
  const std::string call = "own_g2(p, p, p, p, p, p, p, p, p, p, p) + own_lambda(p, p, p, p, p, p, p, p)";
  folder.write("old.frag", "#version 110\nvarying float p;\n" + folder.read("out/own.glsl") +
                               "void main() { gl_FragColor = vec4(" + call + "); }\n");
  folder.write("pixel.hlsl",
               folder.read("out/own.hlsl") + "float4 main(float p : TEXCOORD0) : SV_Target { return " + call + "; }\n");
  for (const char* command :
       {"glslangValidator old.frag", "glslangValidator -D -V -S frag -e main pixel.hlsl -o pixel.spv"}) {
    const Outcome outcome = run(folder, command);
    INFO(command << "\n" << outcome.out);
    CHECK(outcome.code == 0);
  }
}

TEST_CASE("what the code of a fit cannot do is refused, by file and place") {
  const Folder folder;
  const auto refused = [&](const std::string& material, const std::vector<std::string>& parts,
                           const std::string& flags = "") {
    folder.write("own.json", material);
    check_error(folder, "brdfplot fit own.json -o out " + flags, 2, parts);
    CHECK(folder.list() == std::vector<std::string>{"own.json"});
  };
  refused(shadowed(R"({"type": "ggx", "alpha": 0.5})", R"({"type": "direction_correlated", "lambda": "fitted"})"),
          {"own.json: /shadowing/lambda: found \"fitted\"", "accepted by fit: ashikhmin, ginneken"});
  refused(R"({"distribution": {"type": "student_t", "alpha": 0.3, "gamma": 1.6}})",
          {"own.json: /distribution/gamma: found 1.6; accepted by fit: gamma >= 1.75", "--fixed"});
  refused(R"({"distribution": {"type": "gtr", "alpha": 0.04, "gamma": 1.5}})",
          {"own.json: /distribution/alpha: found 0.04; accepted by fit: alpha in [0.05, 1]", "--fixed"});
  refused(R"({"distribution": {"type": "gtr", "roughness": 2, "gamma": 1.5}})",
          {"own.json: /distribution/roughness: found 2 (alpha = 4); accepted by fit: alpha in [0.05, 1]"});
  refused(R"({"distribution": {"type": "phong", "exponent": -0.5}})",
          {"own.json: /distribution/exponent: found -0.5; accepted by fit: exponent >= 0", "--fixed"});
  refused(R"({"distribution": {"type": "phong", "alpha": 1.2}})",
          {"own.json: /distribution/alpha: found 1.2 (exponent = -0.61", "exponent >= 0"});
  const std::string formula = R"({"distribution": {"type": "ggx", "alpha": 1},
                                  "masking": {"type": "custom", "lambda": "0.1 * tan_theta"}})";
  for (const char* flags : {"", "--fixed"})
    refused(formula,
            {"own.json: /masking/lambda: found a formula of \"tan_theta\"; accepted by fit: one of \"a\" alone"},
            flags);
  refused(R"({"distribution": {"type": "mixture", "components": [
             {"weight": 1, "distribution": {"type": "ggx", "alpha_x": 0.1, "alpha_y": 0.2}}]}})",
          {"own.json: /distribution: its Lambda depends on the azimuth"});
}

TEST_CASE("--fixed fits every value of a parameter, as far off as it says") {
  const Folder folder;
  for (const char* distribution : sample_of<const char*>({R"({"type": "student_t", "alpha": 0.5, "gamma": 1.6})",
                                                          R"({"type": "gtr", "alpha": 0.03125, "gamma": 1.5})",
                                                          R"({"type": "gtr", "alpha": 4, "gamma": 1.5})",
                                                          R"({"type": "phong", "exponent": -0.5})"},
                                                         3)) {
    INFO(distribution);
    folder.write("own.json", R"({"name": "own", "distribution": )" + std::string(distribution) + "}");
    check_output(folder, "brdfplot fit own.json --fixed -o out");
    const std::string alpha = std::string(distribution).find("student_t") != std::string::npos ? ", T(0.5)" : "";
    build_fit_program(
        folder, "own", 7,
        {"own_lambda(T(p[2])" + alpha + ")", "own_g1(T(p[2])" + alpha + ")", "own_g2(T(p[2]), T(p[5])" + alpha + ")"});
    const Material material = build(config::load_material((folder.path() / "own.json").string()));
    const auto points = pairs();
    const auto rows = run_fit_program(folder, "own", points);
    for (std::size_t k = 0; k < rows.size(); ++k) check_row(material, folder.read("out/own.hpp"), points[k], rows[k]);
  }
}
