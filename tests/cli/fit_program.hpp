/// \file
/// The code that `brdfplot fit` writes, compiled and run.
#pragma once

#include "cli/program.hpp"

#include <cmath>
#include <numbers>
#include <regex>

namespace test {

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// GLSL or HLSL as C++, in a namespace of its name.
inline std::string shader_as_cpp(const std::string& language, const std::string& code) {
  // What these have and C++ has not.
  const std::string shim = R"(
using std::abs; using std::atan2; using std::exp; using std::sqrt;
inline float max(float a, float b) { return a < b ? b : a; }
inline float min(float a, float b) { return b < a ? b : a; }
inline float atan(float y, float x) { return std::atan2(y, x); }
)";
  // A literal is a float there; in C++ it would make the arithmetic double.
  static const std::regex literal(R"(\b([0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?)\b)");
  const std::string text = std::regex_replace(code, literal, "$1f");
  return "namespace " + language + " {" + shim + replaced(text, "out float ", "float& ") + "}\n";
}

/// A program that reads `inputs` numbers into p and writes each of `calls`, whose text has T for the type, computed by
/// C++ in double and in float, by GLSL and by HLSL. Compiled as ./NAME, from out/NAME.{hpp,glsl,hlsl}.
inline void build_fit_program(const Folder& folder, const std::string& name, int inputs,
                              const std::vector<std::string>& calls) {
  std::string text = "#include \"out/" + name + ".hpp\"\n#include <cmath>\n#include <cstdio>\n" +
                     shader_as_cpp("glsl", folder.read("out/" + name + ".glsl")) +
                     shader_as_cpp("hlsl", folder.read("out/" + name + ".hlsl")) + "int main() {\n  double p[" +
                     std::to_string(inputs) + "];\n  for (;;) {\n    for (int k = 0; k < " + std::to_string(inputs) +
                     "; ++k) if (std::scanf(\"%lf\", p + k) != 1) return 0;\n";
  for (const std::string& call : calls)
    for (const std::string scope : {"double ", "float ", "float glsl::", "float hlsl::"}) {
      const std::size_t space = scope.find(' ');
      text += "    { using T = " + scope.substr(0, space) + "; std::printf(\"%.17g,\", double(" +
              scope.substr(space + 1) + call + ")); }\n";
    }
  folder.write("program.cpp", text + "    std::puts(\"\");\n  }\n}\n");
  const Outcome built =
      run(folder, BRDFPLOT_CXX " -std=c++17 -O1 -Wall -Wextra -ffp-contract=off -o " + name + " program.cpp");
  INFO(built.err);
  REQUIRE(built.code == 0);
  CHECK(built.err.empty());
}

/// What it writes, a row of numbers for each row of `points`.
inline std::vector<std::vector<double>> run_fit_program(const Folder& folder, const std::string& name,
                                                        const std::vector<std::vector<double>>& points) {
  std::string text;
  for (const auto& row : points) {
    for (const double value : row) {
      char digits[40];
      std::snprintf(digits, sizeof digits, "%.17g ", value);
      text += digits;
    }
    text += "\n";
  }
  folder.write("points", text);
  std::vector<std::vector<double>> out;
  for (const auto& cells_of_row : cells(check_output(folder, "./" + name + " <points"))) {
    auto& row = out.emplace_back();
    for (const auto& cell : cells_of_row) row.push_back(std::stod(cell));
  }
  REQUIRE(out.size() == points.size());
  return out;
}

/// The relative errors that the comment above the code grants, of G1 and of G2.
struct PrintedBounds {
  double g1 = 0;
  double g2 = 0;
};

/// `precision`: "double" or "float".
inline PrintedBounds printed_bounds(const std::string& code, const std::string& precision) {
  const std::regex line("in " + precision + ": G1 within a relative ([-+.e0-9]+).*; G2 within ([-+.e0-9]+)");
  std::smatch found;
  REQUIRE(std::regex_search(code, found, line));
  return {std::stod(found[1]), std::stod(found[2])};
}

/// The float next to a value: what both precisions can be given alike.
inline double as_float(double value) { return static_cast<double>(static_cast<float>(value)); }

} // namespace test
