#include "brdf/evaluate.hpp"
#include "cli/program.hpp"
#include "config/load.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <regex>

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
  return {{"beckmann", R"({"type": "beckmann", "alpha": 0.4})", "", {"alpha"}, {{1e-3}, {0.1}, {0.7}, {3}}},
          {"ggx", R"({"type": "ggx", "alpha": 0.4})", "", {"alpha"}, {{1e-3}, {0.1}, {0.7}, {3}}},
          {"phong", R"({"type": "phong", "exponent": 20})", "", {"exponent"}, {{0}, {3}, {50}, {5000}}},
          {"gtr", R"({"type": "gtr", "alpha": 0.4, "gamma": 1.5})", "", {"alpha"}, {{0.05}, {0.2}, {0.6}, {1}}},
          {"gtr_fixed", R"({"type": "gtr", "alpha": 0.4, "gamma": 1.5})", "--fixed", {}, {{}}},
          {"student_t",
           R"({"type": "student_t", "alpha": 0.4, "gamma": 3})",
           "--tolerance 1e-3",
           {"alpha", "gamma"},
           {{0.1, 1.75}, {0.1, 2.5}, {1, 10}, {0.5, 1000}}},
          {"velvet", R"({"type": "velvet", "alpha": 0.4})", "", {}, {{}}}};
}

double tolerance(const Case& c) { return c.flags.find("1e-3") != std::string::npos ? 1e-3 : 1e-4; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// What GLSL and HLSL have and C++ has not, for their text to be C++ in a namespace.
const std::string shim = R"(
using std::sqrt;
inline float max(float a, float b) { return a < b ? b : a; }
inline float clamp(float x, float a, float b) { return x < a ? a : x > b ? b : x; }
)";

std::string as_cpp(const std::string& language, const std::string& code) {
  // A literal is a float there; in C++ it would make the arithmetic double.
  static const std::regex literal(R"(\b([0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?)\b)");
  const std::string text = std::regex_replace(code, literal, "$1f");
  return "namespace " + language + " {" + shim + replaced(text, "out float ", "float& ") + "}\n";
}

/// Reads cosines and arguments; writes G1 by C++ in double and float, by GLSL and by HLSL, then Lambda and G2 likewise.
std::string program(const Case& c, const Folder& folder) {
  std::string arguments;
  for (std::size_t k = 0; k < c.keys.size(); ++k) arguments += ", T(p[" + std::to_string(k) + "])";
  std::string text = "#include \"out/" + c.name + ".hpp\"\n#include <cstdio>\n" +
                     as_cpp("glsl", folder.read("out/" + c.name + ".glsl")) +
                     as_cpp("hlsl", folder.read("out/" + c.name + ".hlsl")) +
                     "int main() {\n  double x, p[2];\n  const int count = " + std::to_string(c.keys.size()) +
                     ";\n  while (std::scanf(\"%lf\", &x) == 1) {\n"
                     "    for (int k = 0; k < count; ++k) if (std::scanf(\"%lf\", p + k) != 1) return 1;\n";
  for (const std::string function : {"g1", "lambda", "g2"}) {
    const std::string cosines = function == "g2" ? "(T(x), T(0.5)" : "(T(x)";
    for (const std::string scope : {"double ", "float ", "float glsl::", "float hlsl::"}) {
      const std::string type = scope.substr(0, scope.find(' '));
      text += "    { using T = " + type + "; std::printf(\"%.17g,\", double(" + scope.substr(type.size() + 1) + c.name +
              "_" + function + cosines + arguments + "))); }\n";
    }
  }
  return text + "    std::puts(\"\");\n  }\n}\n";
}

std::vector<double> cosines() {
  std::vector<double> all = {-0.5, 0, 1e-12, 1e-6, 1};
  for (int k = 1; k < 400; ++k) all.push_back(std::cos(std::numbers::pi / 2 * k / 400));
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

void check_row(const Material& material, double cosine, const std::vector<double>& row, double bound) {
  const double g1 = cosine > 0 ? reference(material, Quantity::g1, cosine) : 0;
  const double lambda = cosine > 0 ? reference(material, Quantity::lambda, cosine) : 0;
  const double g2 = cosine > 0 ? reference(material, Quantity::g2, cosine) : 0;
  for (std::size_t k = 0; k < 4; ++k) {
    INFO("cosine " << cosine << ", column " << k);
    // Single precision adds some roundings of coefficients that partly cancel.
    const double rounding = k == 0 ? 0 : 2e-5;
    CHECK(std::fabs(row[k] - g1) <= (bound + rounding) * g1);
    CHECK(row[k] >= 0);
    CHECK(row[k] <= 1);
    CHECK(row[4 + k] >= 0);
    if (cosine > 0) CHECK(std::fabs(row[4 + k] - lambda) <= 1.001 * (bound + rounding) * (1 + lambda));
    CHECK(std::isfinite(row[4 + k]));
    // |d ln G2| = G2 |d Lambda_o + d Lambda_i| <= |d ln G1_o| + |d ln G1_i|.
    CHECK(std::fabs(row[8 + k] - g2) <= 2 * (bound + rounding) * g2);
  }
}

void check_values(const Folder& folder, const Case& c) {
  std::string points;
  for (const auto& values : c.values) {
    for (const double cosine : cosines()) {
      char text[100];
      std::snprintf(text, sizeof text, "%.17g", cosine);
      points += text;
      for (const double value : values) {
        std::snprintf(text, sizeof text, " %.17g", value);
        points += text;
      }
      points += "\n";
    }
  }
  folder.write("points", points);
  const auto rows = cells(check_output(folder, "./" + c.name + " <points"));
  REQUIRE(rows.size() == c.values.size() * cosines().size());
  std::size_t line = 0;
  for (const auto& values : c.values) {
    MaterialDescription description = config::load_material((folder.path() / (c.name + ".json")).string());
    for (std::size_t k = 0; k < c.keys.size(); ++k) set_parameter(description, c.keys[k], values[k]);
    const Material material = build(description);
    for (const double cosine : cosines()) {
      std::vector<double> row;
      for (const auto& cell : rows[line]) row.push_back(std::stod(cell));
      INFO(c.name << ", row " << line << " of the points");
      check_row(material, cosine, row, tolerance(c));
      ++line;
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
  for (const Case& c : cases()) {
    INFO(c.name);
    const Folder folder;
    make_fit(folder, c);
    folder.write("program.cpp", program(c, folder));
    const Outcome built = run(folder, BRDFPLOT_CXX " -std=c++17 -O1 -Wall -Wextra -o " + c.name + " program.cpp");
    INFO(built.err);
    REQUIRE(built.code == 0);
    CHECK(built.err.empty());
    check_values(folder, c);
    check_shaders(folder, c);
  }
}

TEST_CASE("what fit writes") {
  const Folder folder;
  const std::string code = check_output(folder, "brdfplot fit configs/materials/beckmann.json --tolerance 1e-3");
  CHECK(code.starts_with("// Beckmann: distribution beckmann, masking smith\n"));
  CHECK(code.find("#pragma once") != std::string::npos);
  CHECK(folder.list().empty());
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
  check_error(folder, "brdfplot fit configs/materials/v_cavity.json -o out", 2, {"/masking/type", "v_cavity"});
  for (const char* value : {"0", "-1", "x", "1"})
    check_error(folder, "brdfplot fit configs/materials/ggx.json --tolerance=" + std::string(value), 2,
                {"--tolerance: ", "a number in (0, 0.1]"});
  check_error(folder, "brdfplot fit configs/materials/beckmann.json --tolerance 1e-14 -o out", 4,
              {"relative error of G1 of ", "(asked: 1e-14)"});
  CHECK(folder.list().empty());
}
