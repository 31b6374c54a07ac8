#include "draw/style.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace brdfplot::plot {

namespace {

Rgb from_hex(std::string_view text) {
  const auto digit = [&](std::size_t i) {
    const char c = text[i];
    return c <= '9' ? c - '0' : c - 'a' + 10;
  };
  const auto channel = [&](std::size_t i) { return (16 * digit(i) + digit(i + 1)) / 255.0; };
  return {channel(1), channel(3), channel(5)};
}

/// Linear between evenly spaced colours.
Rgb interpolate(std::span<const std::string_view> stops, double place) {
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double t = at - static_cast<double>(below);
  const Rgb a = from_hex(stops[below]);
  const Rgb b = from_hex(stops[below + 1]);
  return {std::lerp(a.r, b.r, t), std::lerp(a.g, b.g, t), std::lerp(a.b, b.b, t)};
}

constexpr std::array<std::string_view, 16> viridis = {"#440154", "#481a6c", "#472f7d", "#414487", "#39568c", "#31688e",
                                                      "#2a788e", "#23888e", "#1f988b", "#22a884", "#35b779", "#54c568",
                                                      "#7ad151", "#a5db36", "#d2e21b", "#fde725"};

constexpr std::array<std::string_view, 9> blue_white_red = {"#053061", "#2a6eb0", "#6aaed0", "#bddaea", "#f7f7f7",
                                                            "#f9c6ad", "#e4836a", "#bb2f3b", "#67001f"};

/// Plasma's hues, cut before the yellow that white paper swallows.
constexpr std::array<std::string_view, 6> ramp_light = {"#1b0c87", "#5b02a3", "#9a179b",
                                                        "#cb4678", "#e56b2e", "#e0a010"};
constexpr std::array<std::string_view, 6> ramp_dark = {"#8087ff", "#b07cf0", "#d873d4",
                                                       "#f0789f", "#fb9a62", "#f5d04e"};

constexpr std::array<std::string_view, 6> dashes = {"", "8 3", "2.5 2.5", "9 3 2 3", "5 2.5", "9 2.5 2 2.5 2 2.5"};

std::string light_value(const std::string& colour) {
  for (const auto& entry : palette) {
    if (entry.name == colour) return std::string(entry.light);
  }
  return ramp_colour(std::stoi(colour.substr(1)), false);
}

void append_variable(std::string& css, std::string_view name, std::string_view value) {
  css.append("--bp-").append(name).append(":").append(value).append(";");
}

} // namespace

std::string hex(const Rgb& colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out = "#";
  for (const double channel : {colour.r, colour.g, colour.b}) {
    const auto byte = static_cast<unsigned>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
    out += digits[byte >> 4U];
    out += digits[byte & 15U];
  }
  return out;
}

int ramp_step(double place) {
  return std::isfinite(place) ? static_cast<int>(std::lround(std::clamp(place, 0.0, 1.0) * ramp_steps)) : 0;
}

std::string ramp_colour(int step, bool dark) {
  const double place = static_cast<double>(step) / ramp_steps;
  return hex(dark ? interpolate(ramp_dark, place) : interpolate(ramp_light, place));
}

std::string_view dash(int index) { return dashes[static_cast<std::size_t>(std::abs(index)) % dashes.size()]; }

Rgb sequential_colour(int index) { return interpolate(viridis, static_cast<double>(index) / (map_colours - 1)); }

Rgb diverging_colour(int index) { return interpolate(blue_white_red, static_cast<double>(index) / (map_colours - 1)); }

Look look_of(int style, const std::optional<double>& ramp, int order) {
  constexpr int ramp_dashes = 4;
  if (ramp) return {"r" + std::to_string(ramp_step(*ramp)), order % ramp_dashes};
  const int count = static_cast<int>(palette.size());
  const int index = std::max(style, 0);
  // Each turn through the palette shifts the dashes, so that no two styles look alike before the 42nd.
  return {std::string(palette[static_cast<std::size_t>(index % count)].name), index % count + index / count};
}

void StyleSheet::add_rule(std::string_view selector, std::string_view property, std::string_view name,
                          std::string_view value) {
  plain_.append(selector).append("{").append(property).append(":").append(value).append("}\n");
  themed_.append(selector).append("{").append(property).append(":var(--bp-").append(name);
  themed_.append(",").append(value).append(")}\n");
}

void StyleSheet::add_colour(const std::string& colour) {
  const auto value = light_value(colour);
  add_rule(".bp-" + colour, "stroke", colour, value);
  add_rule(".bp-f-" + colour, "fill", colour, value);
}

void StyleSheet::add_map(bool diverging) {
  for (int i = 0; i < map_colours; ++i) {
    plain_.append(diverging ? ".bp-d" : ".bp-q").append(std::to_string(i)).append("{fill:");
    plain_.append(hex(diverging ? diverging_colour(i) : sequential_colour(i))).append("}\n");
  }
}

void StyleSheet::add_chrome() {
  const auto rule = [&](std::string_view selector, std::string_view property, std::size_t colour) {
    add_rule(selector, property, chrome[colour].name, chrome[colour].light);
  };
  rule(".bp-bg", "fill", 0);
  rule(".bp-ink", "fill", 1);
  rule(".bp-muted", "fill", 2);
  rule(".bp-arrow", "stroke", 1);
  rule(".bp-frame", "stroke", 3);
  rule(".bp-grid", "stroke", 4);
  rule(".bp-nan", "fill", 5);
  rule(".bp-hatch", "stroke", 3);
  plain_ += ".bp-halo{stroke:#fff}\n.bp-contour{stroke:#111}\n.bp-no{fill:none}\n";
  plain_ += ".bp-veil{fill-opacity:.8}\n";
  plain_ += ".bp-line{stroke-linejoin:round}\n.bp-cells{shape-rendering:crispEdges}\n";
}

std::string StyleSheet::text() const { return plain_ + "@supports (fill:var(--bp-ink)){\n" + themed_ + "}\n"; }

std::string every_rule() {
  StyleSheet style;
  style.add_chrome();
  for (const auto& entry : palette) style.add_colour(std::string(entry.name));
  for (int step = 0; step <= ramp_steps; ++step) style.add_colour("r" + std::to_string(step));
  for (const bool diverging : {false, true}) style.add_map(diverging);
  return style.text();
}

void append_dark_variables(std::string& css) {
  for (const auto& entry : chrome) append_variable(css, entry.name, entry.dark);
  for (const auto& entry : palette) append_variable(css, entry.name, entry.dark);
  for (int step = 0; step <= ramp_steps; ++step)
    append_variable(css, "r" + std::to_string(step), ramp_colour(step, true));
}

} // namespace brdfplot::plot
