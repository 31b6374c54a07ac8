#include "choice/compare/compare.hpp"

#include "base/number.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace brdfplot::choice {

namespace {

std::string digits(double value, int count) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", count, value);
  return text;
}

std::string in_degrees(double radians) { return digits(radians * 180 / std::numbers::pi, 3) + "°"; }

std::string direction_text(const Direction& d) {
  const double theta = std::atan2(std::hypot(d.x, d.y), d.z);
  return in_degrees(theta) + ", " + in_degrees(std::atan2(d.y, d.x));
}

std::string pair_text(const DifferentPair& pair, bool coloured) {
  return "at θ_o, φ_o = " + direction_text(pair.omega_o) + ", θ_i, φ_i = " + direction_text(pair.omega_i) + ": " +
         digits(pair.a, 4) + " and " + digits(pair.b, 4) + " /sr" +
         (coloured ? std::string(", channel ") + "rgb"[pair.channel] : "");
}

bool is_grey(const Rgb& rgb) { return rgb[0] == rgb[1] && rgb[1] == rgb[2]; } // NOLINT(clang-diagnostic-float-equal)

std::string colour_text(const Rgb& rgb) {
  if (is_grey(rgb)) return digits(rgb[0], 4);
  return digits(rgb[0], 4) + " " + digits(rgb[1], 4) + " " + digits(rgb[2], 4);
}

std::string with_error(double value, double error) {
  return digits(100 * value, 3) + " % (± " + digits(100 * error, 1) + ")";
}

bool is_coloured(const MaterialDifference& one) {
  for (const AlbedoPair& pair : one.albedo)
    if (!is_grey(pair.a) || !is_grey(pair.b)) return true;
  return false;
}

} // namespace

std::vector<std::vector<std::string>> comparison_rows(const std::string& a, const MaterialDifference& one) {
  const bool coloured = is_coloured(one);
  std::vector<std::vector<std::string>> rows = {
      {"largest",
       digits(std::abs(one.largest.a - one.largest.b), 3) + " /sr of ρ cos θ_i " + pair_text(one.largest, coloured)},
      {"largest, relative",
       one.relative > 0 ? digits(100 * one.relative, 3) + " % " + pair_text(one.largest_relative, coloured) : "none"},
      {"RMS", with_error(one.rms, one.rms_error) + " of the RMS of " + a},
      {"light", with_error(one.light, one.light_error) + " of the light that " + a +
                    " reflects, as the integral of |difference|"},
      {"sphere", "ΔE_ITP " + digits(one.sphere.p95, 3) + " (95th percentile), " + digits(one.sphere.worst, 3) +
                     " (worst 1 %); light " + digits(100 * one.sphere.energy, 2) + " %"}};
  for (const AlbedoPair& pair : one.albedo)
    rows.push_back({"albedo at " + std::to_string(std::lround(pair.theta_o * 180 / std::numbers::pi)) + "deg",
                    colour_text(pair.a) + " and " + colour_text(pair.b)});
  return rows;
}

std::string comparison_text(const std::string& a, const std::vector<MaterialDifference>& all) {
  std::string out;
  for (const MaterialDifference& one : all) {
    out += (out.empty() ? "" : "\n") + one.name + " against " + a + "\n";
    for (const auto& row : comparison_rows(a, one))
      out += "  " + row[0] + std::string(20 - row[0].size(), ' ') + row[1] + "\n";
  }
  return out;
}

std::string comparison_csv(const std::vector<MaterialDifference>& all) {
  std::string out = "material,quantity,theta_o,channel,a,b,value,standard_error\n";
  const auto quoted = [](const std::string& text) {
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + "\"";
  };
  for (const MaterialDifference& one : all) {
    const std::string name = quoted(one.name);
    const auto row = [&](const std::string& quantity, const std::string& angle, const std::string& channel,
                         const std::string& a, const std::string& b, double value, const std::string& error) {
      out += name + "," + quantity + "," + angle + "," + channel + "," + a + "," + b + "," + format_number(value) +
             "," + error + "\n";
    };
    const auto pair = [&](const std::string& quantity, const DifferentPair& at, double value) {
      const double theta = std::atan2(std::hypot(at.omega_o.x, at.omega_o.y), at.omega_o.z);
      row(quantity, format_number(theta), std::string(1, "rgb"[at.channel]), format_number(at.a), format_number(at.b),
          value, "");
    };
    pair("largest", one.largest, std::abs(one.largest.a - one.largest.b));
    pair("largest_relative", one.largest_relative, one.relative);
    row("rms", "", "", "", "", one.rms, format_number(one.rms_error));
    row("light", "", "", "", "", one.light, format_number(one.light_error));
    row("delta_e_p95", "", "", "", "", one.sphere.p95, "");
    row("delta_e_worst", "", "", "", "", one.sphere.worst, "");
    row("sphere_light", "", "", "", "", one.sphere.energy, "");
    for (const AlbedoPair& albedo : one.albedo)
      for (std::size_t c = 0; c < 3; ++c)
        row("albedo", format_number(albedo.theta_o), std::string(1, "rgb"[c]), format_number(albedo.a[c]),
            format_number(albedo.b[c]), albedo.b[c] - albedo.a[c], "");
  }
  return out;
}

} // namespace brdfplot::choice
