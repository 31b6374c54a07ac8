#include "draw/svg/legend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace brdfplot::plot {

namespace {

constexpr double font_size = 13;
constexpr double sample_width = 34;
constexpr double sample_gap = 7;
constexpr double entry_gap = 20;
constexpr double legend_dot_radius = 4;
constexpr double legend_band = 9;
constexpr double measured_bar = 5;

/// One drawn thing that may need an entry.
struct Item {
  std::string label;
  int style = 0;
  std::optional<double> ramp;
  std::optional<Hue> hue{};
  LegendEntry::Sample sample = LegendEntry::Sample::line;
  bool solid = false; ///< the parts of a profile: dashes would look like more parts

  [[nodiscard]] bool looks_like(const Item& other) const {
    if (ramp.has_value() != other.ramp.has_value() || hue != other.hue || sample != other.sample) return false;
    return ramp ? ramp_step(*ramp) == ramp_step(*other.ramp) : style == other.style;
  }
};

/// The line that is in the colour of a channel: of the palette, so that the colour blind tell them apart too.
Look look_of_hue(Hue hue, int style) {
  constexpr std::array<std::string_view, 3> names = {"s1", "s2", "s0"};
  return {std::string(names[static_cast<std::size_t>(hue)]), style};
}

/// As the series is drawn.
LegendEntry::Sample sample_of(const Series& series, Kind kind) {
  if (!series.names.empty()) return LegendEntry::Sample::dot;
  if (series.error.empty()) return LegendEntry::Sample::line;
  if (kind != Kind::polar) return LegendEntry::Sample::measured;
  const bool exact = std::ranges::all_of(series.error, [](double error) { return error == 0; });
  return exact ? LegendEntry::Sample::line : LegendEntry::Sample::band;
}

std::vector<Item> items_of(const Panel& panel, Kind kind, const std::vector<std::string>& contour_labels) {
  std::vector<Item> items;
  if (kind == Kind::spheres) return items; // what they show is no line
  if (kind != Kind::heatmap) {
    for (const auto& series : panel.series)
      items.push_back(
          {series.label, series.style, series.ramp, series.hue, sample_of(series, kind), kind == Kind::profile});
    return items;
  }
  for (const auto& contour : panel.contours) {
    const auto at = std::find(contour_labels.begin(), contour_labels.end(), contour.label);
    items.push_back({contour.label, static_cast<int>(at - contour_labels.begin()), std::nullopt, std::nullopt,
                     LegendEntry::Sample::contour});
  }
  return items;
}

std::vector<std::string> contour_labels_of(const Figure& figure) {
  std::vector<std::string> labels;
  for (const auto& panel : figure.panels) {
    for (const auto& contour : panel.contours) {
      if (std::find(labels.begin(), labels.end(), contour.label) == labels.end()) labels.push_back(contour.label);
    }
  }
  return labels;
}

/// Adds the items with labels that the list does not have yet.
void add_distinct(std::vector<Item>& distinct, const std::vector<Item>& items) {
  for (const auto& item : items) {
    const auto same = [&](const Item& other) { return other.label == item.label; };
    if (!item.label.empty() && std::none_of(distinct.begin(), distinct.end(), same)) distinct.push_back(item);
  }
}

/// Whether one legend serves all panels: labels and looks go together, and at least one label occurs twice.
bool can_share(const std::vector<std::vector<Item>>& panels) {
  if (panels.size() == 1) return true;
  bool repeated = false;
  std::vector<Item> seen;
  for (const auto& items : panels) {
    for (const auto& item : items) {
      if (item.label.empty()) continue;
      bool known = false;
      for (const auto& other : seen) {
        const bool same_label = other.label == item.label;
        if (same_label != other.looks_like(item)) return false;
        known = known || same_label;
      }
      repeated = repeated || known;
      if (!known) seen.push_back(item);
    }
  }
  return repeated;
}

/// The look of an item; a ramp's dashes alternate with the place of its label in the legend.
Look look_in(const Item& item, const std::vector<Item>& distinct) {
  const auto same = [&](const Item& other) { return other.label == item.label; };
  const auto at = std::find_if(distinct.begin(), distinct.end(), same);
  Look look = item.hue
                  ? look_of_hue(*item.hue, item.style)
                  : look_of(item.style, item.ramp, at == distinct.end() ? 0 : static_cast<int>(at - distinct.begin()));
  if (item.solid) look.dash = 0;
  return look;
}

std::vector<LegendEntry> entries_of(const std::vector<Item>& distinct) {
  std::vector<LegendEntry> entries;
  entries.reserve(distinct.size());
  for (const auto& item : distinct) entries.push_back({item.label, look_in(item, distinct), item.sample});
  return entries;
}

bool has_undefined_cells(const Panel& panel) {
  return panel.grid && std::any_of(panel.grid->value.begin(), panel.grid->value.end(),
                                   [](double value) { return std::isnan(value); });
}

} // namespace

namespace {

/// Profiles beside other kinds have a legend of theirs, under the first one's title: their colours are those of sight.
bool stands_alone(const Figure& figure, const Panel& panel) {
  const auto profile = [&](const Panel& one) { return kind_in(figure, one) == Kind::profile; };
  return profile(panel) && !std::ranges::all_of(figure.panels, profile);
}

} // namespace

LegendPlan plan_legend(const Figure& figure) {
  LegendPlan plan;
  const auto contour_labels = contour_labels_of(figure);
  std::vector<std::vector<Item>> items;
  for (const auto& panel : figure.panels) items.push_back(items_of(panel, kind_in(figure, panel), contour_labels));
  std::vector<std::vector<Item>> common;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!stands_alone(figure, figure.panels[i])) common.push_back(items[i]);
  const bool can = can_share(common);
  std::vector<Item> all;
  for (const auto& list : common) add_distinct(all, list);

  std::vector<Item> alone;
  std::optional<std::size_t> first_alone;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!stands_alone(figure, figure.panels[i])) continue;
    if (!first_alone) first_alone = i;
    add_distinct(alone, items[i]);
  }

  plan.own.resize(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool profile = stands_alone(figure, figure.panels[i]);
    std::vector<Item> own;
    if (!profile)
      add_distinct(own, items[i]);
    else if (i == first_alone)
      own = alone;
    const bool share = can && !profile;
    if (!share) plan.own[i] = entries_of(own);
    plan.looks.emplace_back();
    for (const auto& item : items[i]) plan.looks.back().push_back(look_in(item, share ? all : own));
  }
  if (can) plan.shared = entries_of(all);
  if (std::any_of(figure.panels.begin(), figure.panels.end(), has_undefined_cells)) {
    plan.shared.push_back({"undefined", {}, LegendEntry::Sample::undefined});
  }
  return plan;
}

LegendLayout lay_out_legend(const std::vector<LegendEntry>& entries, double width) {
  LegendLayout layout;
  double widest = 0;
  double total = 0;
  for (const auto& entry : entries) {
    auto text = fit_text(entry.label, font_size, width - sample_width - sample_gap, 1);
    const double full = sample_width + sample_gap + text.width() + entry_gap;
    widest = std::max(widest, full);
    total += full;
    layout.placed.push_back({entry, std::move(text), {}});
  }
  // Columns read better than a ragged flow, unless one long label would make them sparse.
  const double columns = std::floor((width + entry_gap) / std::max(widest, 1.0));
  const double average = total / std::max(1.0, static_cast<double>(entries.size()));
  const bool aligned = total > width + entry_gap && columns >= 2 && widest < 1.6 * average;
  const double cell = aligned ? (width + entry_gap) / columns : 0;

  Point at;
  double row_height = 0;
  for (auto& placed : layout.placed) {
    const double full = std::max(cell, sample_width + sample_gap + placed.text.width() + entry_gap);
    if (at.x > 0 && at.x + full > width + entry_gap + 0.01) {
      at = {0, at.y + row_height};
      row_height = 0;
    }
    placed.at = at;
    at.x += full;
    row_height = std::max(row_height, placed.text.height() + 3);
  }
  layout.height = layout.placed.empty() ? 0 : at.y + row_height;
  return layout;
}

void append_error_bar(PathData& bars, double x, double top, double bottom) {
  constexpr double cap = 2.5;
  bars.move({x, top});
  bars.line({x, bottom});
  for (const double end : {top, bottom}) {
    bars.move({x - cap, end});
    bars.line({x + cap, end});
  }
}

namespace {

/// A dot with its bar, on the line that joins the dots.
void draw_measured_sample(SvgWriter& svg, const Look& look, Point from, Point to) {
  const double x = (from.x + to.x) / 2;
  PathData bar, dot;
  append_error_bar(bar, x, from.y - measured_bar, from.y + measured_bar);
  dot.dot({x, from.y}, measured_radius);
  svg.line(from, to, {"bp-no bp-" + look.colour, measured_line, dash(look.dash), {}});
  svg.path(bar, {"bp-no bp-" + look.colour, 1.2, {}, {}});
  svg.path(dot, {"bp-f-" + look.colour, 0, {}, {}});
}

} // namespace

void draw_legend(SvgWriter& svg, const LegendLayout& legend, Point corner) {
  if (legend.placed.empty()) return;
  svg.open_group("bp-legend");
  for (const auto& placed : legend.placed) {
    const Point at{corner.x + placed.at.x, corner.y + placed.at.y};
    const double y = at.y + 0.66 * placed.text.size;
    const Point to{at.x + sample_width, y};
    const auto& look = placed.entry.look;
    const bool series = placed.entry.sample != LegendEntry::Sample::undefined;
    svg.open_group("bp-entry", series ? key_attribute(look) : std::string());
    if (!series) {
      svg.rect({at.x, y - 5, sample_width, 10}, "bp-nan");
    } else if (placed.entry.sample == LegendEntry::Sample::dot) {
      PathData dot;
      dot.dot({at.x + sample_width / 2, y}, legend_dot_radius);
      svg.path(dot, {"bp-f-" + look.colour, 0, {}, {}});
    } else if (placed.entry.sample == LegendEntry::Sample::contour) {
      svg.line({at.x, y}, to, {"bp-no bp-halo", 4, {}, {}});
      svg.line({at.x, y}, to, {"bp-no bp-contour", 1.6, dash(look.dash), {}});
    } else if (placed.entry.sample == LegendEntry::Sample::measured) {
      draw_measured_sample(svg, look, {at.x, y}, to);
    } else {
      if (placed.entry.sample == LegendEntry::Sample::band) {
        PathData band;
        band.rectangle({at.x, y - legend_band / 2, sample_width, legend_band});
        svg.path(band, {"bp-f-" + look.colour, 0, {}, " fill-opacity=\"0.35\""});
      }
      svg.line({at.x, y}, to, {"bp-no bp-" + look.colour, 2, dash(look.dash), {}});
    }
    svg.lines({at.x + sample_width + sample_gap, at.y}, placed.text, Anchor::start);
    svg.close_group();
  }
  svg.close_group();
}

} // namespace brdfplot::plot
