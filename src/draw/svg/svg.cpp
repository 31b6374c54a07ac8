#include <algorithm>
#include <set>
#include <string>

#include "base/threads/interrupt.hpp"
#include "draw/number_text.hpp"
#include "draw/svg/plan.hpp"
#include "draw/svg/reading.hpp"

namespace brdfplot::plot {

namespace {

/// The font by which text is measured, so that the same text is the same picture; where it is not, one of its widths.
constexpr std::string_view font = "DejaVu Sans,Verdana,sans-serif";

std::string fixed(double value) {
  std::string text;
  append_fixed(text, value);
  return text;
}

void append_root(std::string& out, const FigurePlan& plan, const Layout& layout) {
  const std::string box = fixed(plan.width) + " " + fixed(plan.height);
  const double millimetres = layout.width_mm / plan.width;
  const std::string width = millimetres > 0 ? fixed(layout.width_mm) + "mm" : fixed(plan.width);
  const std::string height = millimetres > 0 ? fixed(millimetres * plan.height) + "mm" : fixed(plan.height);
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + box + "\" aria-labelledby=\"" + plan.id + "-title " + plan.id + "-desc\" font-family=\"";
  out.append(font).append("\">\n");
}

void append_description(std::string& out, const Figure& figure, const FigurePlan& plan) {
  out += "<title id=\"" + plan.id + "-title\">";
  append_escaped(out, strip_markup(figure.title.empty() ? figure.id : figure.title));
  out += "</title>\n<desc id=\"" + plan.id + "-desc\">";
  append_escaped(out, strip_markup(figure.description));
  out += "</desc>\n";
}

void append_style(std::string& out, const FigurePlan& plan) {
  StyleSheet style;
  style.add_chrome();
  std::set<std::string> colours;
  for (const auto& panel : plan.panels) {
    if (panel.panel->grid) continue;
    for (const auto& look : panel.looks) colours.insert(look.colour);
  }
  for (const auto& colour : colours) style.add_colour(colour);
  for (const bool diverging : {false, true}) {
    const auto uses = [&](const PanelPlan& p) { return p.panel->grid && is_diverging(p) == diverging; };
    if (std::any_of(plan.panels.begin(), plan.panels.end(), uses)) style.add_map(diverging);
  }
  out += "<style>\n" + style.text() + "</style>\n";
}

/// Where a text over a panel has its middle: over that of the plot, or beside it where the text would reach farther
/// than into half of the page's margin or of the gap between panels.
double middle_of(const FittedText& text, const PanelPlan& panel) {
  constexpr double overhang = std::min(page_margin, column_gap) / 2;
  const double half = text.width() / 2, middle = panel.plot.x + panel.plot.w / 2;
  const double least = panel.plot.x - panel.insets.left - overhang + half;
  const double most = panel.plot.right() + panel.insets.right + overhang - half;
  return least < most ? std::clamp(middle, least, most) : (least + most) / 2;
}

void draw_head(SvgWriter& svg, const PanelPlan& panel) {
  svg.lines({middle_of(panel.title, panel), panel.title_top}, panel.title, Anchor::middle);
  const double title = panel.title.lines.empty() ? 0 : panel.title.height() + 4;
  svg.lines({middle_of(panel.note, panel), panel.title_top + title}, panel.note, Anchor::middle, "bp-muted");
  draw_legend(svg, panel.legend, {panel.plot.x - panel.insets.left + 4, panel.legend_top});
}

/// A figure of which all panels are drawn.
std::string draw_figure(const Figure& figure, const Layout& layout) {
  const auto plan = plan_figure(figure, layout);
  std::string out;
  out.reserve(16384);
  append_root(out, plan, layout);
  append_description(out, figure, plan);
  append_style(out, plan);
  SvgWriter svg(out);
  svg.rect({0, 0, plan.width, plan.height}, "bg bp-bg");
  svg.lines({page_margin, page_margin}, plan.title, Anchor::start, "bp-ink bp-title");
  draw_legend(svg, plan.legend, {page_margin, plan.legend_top});
  for (const auto& panel : plan.panels) {
    throw_if_interrupted();
    svg.open_group("bp-panel", reading_attributes(panel.kind, panel));
    draw_head(svg, panel);
    kind_of(panel.kind).draw(svg, panel);
    svg.close_group();
  }
  out += "</svg>\n";
  return out;
}

} // namespace

std::string to_svg(const Figure& figure) { return to_svg(figure, {}); }

std::string to_svg(const Figure& figure, const Layout& layout) {
  if (std::ranges::all_of(figure.panels, &Panel::drawn)) return draw_figure(figure, layout);
  Figure drawn = figure;
  std::erase_if(drawn.panels, [](const Panel& panel) { return !panel.drawn; });
  return draw_figure(drawn, layout);
}

} // namespace brdfplot::plot
