#include "analysis/fit/fit.hpp"
#include "brdf/evaluate.hpp"
#include "cli/fit_program.hpp"
#include "config/load.hpp"

using namespace test;
using namespace brdfplot;

namespace {

/// A material whose fit is compiled: its JSON, the number of arguments beside the cosine, values of these, and the
/// parameters that they are (an empty key: the alpha that shape-invariant distributions have as `alpha`).
struct Case {
  std::string name;
  std::string distribution; ///< JSON
  std::string flags;
  std::vector<std::string> keys;
  std::vector<std::vector<double>> values;
};

std::vector<Case> cases() {
  return {
      {"beckmann", R"({"type": "beckmann", "alpha": 0.4})", "", {"alpha"}, {{2e-6}, {1e-3}, {0.1}, {0.7}, {3}, {1e6}}},
      {"ggx", R"({"type": "ggx", "alpha": 0.4})", "", {"alpha"}, {{2e-6}, {1e-3}, {0.1}, {0.7}, {3}, {1e6}}},
      {"phong", R"({"type": "phong", "exponent": 20})", "", {"exponent"}, {{0}, {3}, {50}, {5000}}},
      {"gtr",
       R"({"type": "gtr", "alpha": 0.4, "gamma": 1.5})",
       "",
       {"alpha"},
       {{0.01}, {0.06}, {0.2}, {0.6}, {1}, {1.5}}},
      {"gtr_fixed", R"({"type": "gtr", "alpha": 0.4, "gamma": 1.5})", "--fixed", {}, {{}}},
      {"student_t",
       R"({"type": "student_t", "alpha": 0.4, "gamma": 3})",
       "--tolerance 1e-3",
       {"alpha", "gamma"},
       {{0.1, 1.75}, {0.1, 2.5}, {1, 10}, {0.5, 1000}}},
      {"velvet", R"({"type": "velvet", "alpha": 0.4})", "", {}, {{}}}};
}

FitOptions options(const Case& c) {
  return {.tolerance = c.flags.find("1e-3") != std::string::npos ? 1e-3 : 1e-4, .fixed = c.flags == "--fixed"};
}

/// Writes G1, Lambda and G2 (with a cosine of 1/2) of a cosine and the arguments.
void build_program(const Folder& folder, const Case& c) {
  std::string arguments;
  for (std::size_t k = 0; k < c.keys.size(); ++k) arguments += ", T(p[" + std::to_string(k + 1) + "])";
  build_fit_program(folder, c.name, static_cast<int>(c.keys.size()) + 1,
                    {c.name + "_g1(T(p[0])" + arguments + ")", c.name + "_lambda(T(p[0])" + arguments + ")",
                     c.name + "_g2(T(p[0]), T(0.5)" + arguments + ")"});
}

/// Floats, so that both precisions are given the same.
std::vector<double> cosines() {
  std::vector<double> all = {-0.5, 0, 1e-12, 1e-6, 1};
  for (int k = 1; k < 400; ++k) all.push_back(std::cos(std::numbers::pi / 2 * k / 400));
  for (double& cosine : all) cosine = as_float(cosine);
  return all;
}

/// Files of the fit of a case, in out/.
void make_fit(const Folder& folder, const Case& c) {
  folder.write(c.name + ".json", R"({"name": ")" + c.name + R"(", "distribution": )" + c.distribution + "}");
  check_output(folder, "brdfplot fit " + c.name + ".json " + c.flags + " -o out");
}

double reference(const Material& material, Quantity quantity, double cosine) {
  const auto at = [](double c) { return Direction{std::sqrt((1 - c) * (1 + c)), 0, c}; };
  // The half vector of two directions in one plane faces both.
  return evaluate(material, quantity, at(cosine), quantity == Quantity::g2 ? std::optional(at(0.5)) : std::nullopt,
                  std::nullopt);
}

/// G1, Lambda and G2 against the material, within what the comment says.
void check_row(const Material& material, double cosine, const std::vector<double>& row, const std::string& code) {
  const double g1 = cosine > 0 ? reference(material, Quantity::g1, cosine) : 0;
  const double lambda = cosine > 0 ? reference(material, Quantity::lambda, cosine) : 0;
  const double g2 = cosine > 0 ? reference(material, Quantity::g2, cosine) : 0;
  for (std::size_t k = 0; k < 4; ++k) {
    INFO("cosine " << cosine << ", column " << k);
    const PrintedBounds bounds = printed_bounds(code, k == 0 ? "double" : "float");
    CHECK(std::fabs(row[k] - g1) <= bounds.g1 * g1);
    CHECK(row[k] >= 0);
    CHECK(row[k] <= 1);
    CHECK(row[4 + k] >= 0);
    if (cosine > 0) CHECK(std::fabs(row[4 + k] - lambda) <= 1.001 * bounds.g1 * (1 + lambda));
    CHECK(std::isfinite(row[4 + k]));
    CHECK(std::fabs(row[8 + k] - g2) <= bounds.g2 * g2);
  }
}

/// G1 as the library says that the code computes it.
template <class Real>
double g1_of_library(const FitResult& fit, double cosine, const std::vector<double>& values) {
  const Real c = std::max(static_cast<Real>(cosine), Real(0));
  const Real alpha = values.empty() ? Real(0) : static_cast<Real>(values[0]);
  const Real y = fit.target.parameter ? code_y(*fit.target.parameter, static_cast<Real>(values.back())) : Real(0);
  const Real s = code_roughness(fit.target, c, alpha, y);
  const FitTerms<Real> terms = code_terms(fit.code, c, code_scaled(fit.code, s), y);
  return static_cast<double>(terms.d / (terms.d + terms.n));
}

void check_values(const Folder& folder, const Case& c) {
  const std::string file = (folder.path() / (c.name + ".json")).string();
  const std::string code = folder.read("out/" + c.name + ".hpp");
  const FitResult fit = fit_lambda(config::load_material(file), options(c));
  for (std::vector<double> values : c.values) {
    std::ranges::transform(values, values.begin(), as_float);
    std::vector<std::vector<double>> points;
    for (const double cosine : cosines()) {
      points.push_back({cosine});
      points.back().insert(points.back().end(), values.begin(), values.end());
    }
    MaterialDescription description = config::load_material(file);
    for (std::size_t k = 0; k < c.keys.size(); ++k) {
      const auto& parameter = fit.target.parameter; // beyond its domain it counts as at its end
      const bool bounded = parameter && parameter->key == c.keys[k];
      set_parameter(description, c.keys[k],
                    bounded ? std::clamp(values[k], parameter->from, parameter->to) : values[k]);
    }
    const Material material = build(description);
    const auto rows = run_fit_program(folder, c.name, points);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      INFO(c.name << ", row " << k << " of the points");
      check_row(material, points[k][0], rows[k], code);
      CHECK(rows[k][0] == g1_of_library<double>(fit, points[k][0], values));
      CHECK(rows[k][1] == g1_of_library<float>(fit, points[k][0], values));
      CHECK(rows[k][2] == rows[k][1]);
      CHECK(rows[k][3] == rows[k][1]);
    }
  }
}

/// Shaders around the code that use every function.
void check_shaders(const Folder& folder, const Case& c) {
  std::string more;
  for (std::size_t k = 0; k < c.keys.size(); ++k) more += ", p";
  const std::string sum =
      c.name + "_g1(p" + more + ") + " + c.name + "_lambda(p" + more + ") + " + c.name + "_g2(p, p" + more + ")";
  const std::string code = folder.read("out/" + c.name + ".glsl");
  folder.write("desktop.frag", "#version 330\nin float p;\nout vec4 colour;\n" + code + "void main() { colour = vec4(" +
                                   sum + "); }\n");
  folder.write("es.frag", "#version 300 es\nprecision highp float;\nin float p;\nout vec4 colour;\n" + code +
                              "void main() { colour = vec4(" + sum + "); }\n");
  folder.write("old.frag",
               "#version 110\nvarying float p;\n" + code + "void main() { gl_FragColor = vec4(" + sum + "); }\n");
  folder.write("pixel.hlsl", folder.read("out/" + c.name + ".hlsl") +
                                 "float4 main(float p : TEXCOORD0) : SV_Target { return float4(" + sum +
                                 ", 0, 0, 1); }\n");
  for (const char* command : {"glslangValidator desktop.frag", "glslangValidator es.frag", "glslangValidator old.frag",
                              "glslangValidator -D -V -S frag -e main pixel.hlsl -o pixel.spv"}) {
    const Outcome outcome = run(folder, command);
    INFO(command << "\n" << outcome.out);
    CHECK(outcome.code == 0);
  }
}

} // namespace

TEST_CASE("the code of a fit compiles, and its G1, Lambda and G2 are those of the material") {
  for (const Case& c : sample_of(cases(), 6)) {
    INFO(c.name);
    const Folder folder;
    make_fit(folder, c);
    build_program(folder, c);
    check_values(folder, c);
    check_shaders(folder, c);
  }
}

TEST_CASE("what fit writes") {
  const Folder folder;
  const std::string code = check_output(folder, "brdfplot fit configs/materials/beckmann.json --tolerance 1e-3");
  CHECK(code.starts_with("// Beckmann: distribution beckmann, masking smith, shadowing height_correlated\n"));
  CHECK(code.find("#pragma once") != std::string::npos);
  CHECK(folder.list().empty());
  const std::string strict = check_output(folder, "brdfplot fit configs/materials/beckmann.json --tolerance 1e-6");
  CHECK(printed_bounds(strict, "double").g1 <= 1e-6);
  CHECK(printed_bounds(strict, "float").g1 > 1e-6);
  CHECK(strict.find("above what was asked: sure in double alone") != std::string::npos);
  CHECK(code.find("above what was asked") == std::string::npos);
  const std::string summary = check_output(folder, "brdfplot fit configs/materials/ggx.json -o deep/out");
  CHECK(summary.find("exact: Lambda = (sqrt(1 + 1 / a^2) - 1) / 2") != std::string::npos);
  CHECK(folder.list("deep/out") ==
        std::vector<std::string>{"ggx.glsl", "ggx.hlsl", "ggx.hpp", "ggx_error.csv", "ggx_error.svg"});
  const auto rows = cells(folder.read("deep/out/ggx_error.csv"));
  CHECK(rows[0] == std::vector<std::string>{"panel", "series", "a", "relative_error"});
  double largest = 0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (rows[k][1] != "tolerance") largest = std::max(largest, std::fabs(std::stod(rows[k][3])));
  CHECK(largest <= 1e-4);
  CHECK(largest > 1e-5);
}

TEST_CASE("fits that fail write nothing") {
  const Folder folder;
  check_error(folder, "brdfplot fit", 2, {"fit: needs MATERIAL.json"});
  check_error(folder, "brdfplot fit configs/materials/v_cavity.json -o out", 2,
              {"configs/materials/v_cavity.json: /masking/type: found \"v_cavity\""});
  for (const char* value : {"0", "-1", "x", "1"})
    check_error(folder, "brdfplot fit configs/materials/ggx.json --tolerance=" + std::string(value), 2,
                {"--tolerance: ", "a number in (0, 0.1]"});
  check_error(
      folder, "brdfplot fit configs/materials/beckmann.json --tolerance 1e-14 -o out", 4,
      {"error: configs/materials/beckmann.json: the rational fits", "relative error of G1 of ", "(asked: 1e-14)"});
  CHECK(folder.list().empty());
}
