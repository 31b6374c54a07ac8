#include "bake/formats.hpp"

#include <array>
#include <cctype>
#include <cstdio>

namespace brdfplot::bake {

namespace {

/// Letters, digits and underscores of a name.
std::string identifier(const std::string& name) {
  std::string out;
  for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  if (out.empty() || std::isdigit(static_cast<unsigned char>(out.front())) != 0) out = "table_" + out;
  return out;
}

std::string literal(double value, bool is_c) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  std::string out = text.data();
  if (out.find_first_of(".e") == std::string::npos) out += ".0";
  return is_c ? out + "f" : out;
}

std::string values_of(const Table& table, bool is_c) {
  std::string text;
  for (std::size_t k = 0; k < table.values.size(); ++k) {
    text += k == 0 ? "\n  " : k % 6 == 0 ? ",\n  " : ", ";
    text += literal(table.values[k], is_c);
  }
  return text;
}

/// t of an axis, in [0, nodes - 1], and the node below.
std::string place_of(const Axis& axis, std::size_t k, bool is_c) {
  const std::string n = std::to_string(k), f = is_c ? "f" : "";
  std::string share =
      "(" + axis.variable + " - " + literal(axis.from, is_c) + ") * " + literal(1 / (axis.to - axis.from), is_c);
  std::string text = "  float t" + n + " = " + share + ";\n";
  text +=
      is_c ? "  t" + n + " = fminf(fmaxf(t" + n + ", 0.0f), 1.0f);\n" : "  t" + n + " = clamp(t" + n + ", 0.0, 1.0);\n";
  if (axis.power != 1)
    text += "  t" + n + " = " + (is_c ? "powf" : "pow") + "(t" + n + ", " + literal(1.0 / axis.power, is_c) + ");\n";
  const std::string last = std::to_string(axis.nodes - 1);
  text += "  t" + n + " *= " + last + ".0" + f + ";\n";
  text += "  int k" + n + " = " + (is_c ? "(int)t" + n : "int(t" + n + ")") + ";\n";
  text += "  if (k" + n + " > " + std::to_string(axis.nodes - 2) + ") k" + n + " = " + std::to_string(axis.nodes - 2) +
          ";\n";
  return text + "  t" + n + " -= " + (is_c ? "(float)k" + n : "float(k" + n + ")") + ";\n";
}

/// A function that reads the table: name(axis..., out values).
std::string reader(const Table& table, const std::string& name, bool is_c) {
  const std::string channels = std::to_string(table.channels.size()), zero = is_c ? "0.0f" : "0.0",
                    one = is_c ? "1.0f" : "1.0";
  std::string text = is_c ? "static inline void " + name + "(" : "void " + name + "(";
  for (const Axis& axis : table.axes) text += "float " + axis.variable + ", ";
  text += is_c ? "float values[" + channels + "]) {\n" : "out float values[" + channels + "]) {\n";
  for (std::size_t k = 0; k < table.axes.size(); ++k) text += place_of(table.axes[k], k, is_c);
  text += "  for (int c = 0; c < " + channels + "; ++c) values[c] = " + zero + ";\n";
  const std::size_t corners = std::size_t{1} << table.axes.size();
  text += "  for (int corner = 0; corner < " + std::to_string(corners) + "; ++corner) {\n";
  text += "    float weight = " + one + ";\n    int node = 0;\n";
  std::size_t stride = 1;
  for (std::size_t k = 0; k < table.axes.size(); ++k) {
    const std::string n = std::to_string(k), bit = "(corner >> " + n + " & 1)";
    text += "    weight *= " + bit + " != 0 ? t" + n + " : " + one + " - t" + n + ";\n";
    text += "    node += " + std::to_string(stride) + " * (k" + n + " + " + bit + ");\n";
    stride *= table.axes[k].nodes;
  }
  text += "    for (int c = 0; c < " + channels + "; ++c) values[c] += weight * " + name + "_values[" + channels +
          " * node + c];\n";
  return text + "  }\n}\n";
}

/// The base of a path's name, without its ending.
std::string stem_of(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.find_last_of('.'));
}

std::string comments(const BakedTable& baked) {
  std::string text = "// Made by brdfplot bake.\n";
  for (const std::string& line : description_of(baked)) text += "// " + line + "\n";
  return text;
}

} // namespace

std::string c_header(const BakedTable& baked, Stored, const std::string& path) {
  const std::string name = identifier(stem_of(path));
  return comments(baked) + "#pragma once\n\n#include <math.h>\n\nstatic const float " + name + "_values[" +
         std::to_string(baked.table.values.size()) + "] = {" + values_of(baked.table, true) + "};\n\n" +
         reader(baked.table, name, true);
}

std::string glsl_source(const BakedTable& baked, Stored, const std::string& path) {
  const std::string name = identifier(stem_of(path));
  return comments(baked) + "\nconst float " + name + "_values[" + std::to_string(baked.table.values.size()) +
         "] = float[](" + values_of(baked.table, false) + ");\n\n" + reader(baked.table, name, false);
}

} // namespace brdfplot::bake
