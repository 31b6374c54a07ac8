#include "draw/svg/reading.hpp"

#include "base/number.hpp"
#include "draw/number_text.hpp"
#include "draw/text.hpp"

namespace brdfplot::plot {

namespace {

void append_attribute(std::string& out, std::string_view name, std::string_view value) {
  out.append(" data-").append(name).append("=\"");
  append_escaped(out, value);
  out += '"';
}

void append_axis(std::string& out, const std::string& name, const Axis& axis, const Range& range) {
  std::string text;
  append_number(text, range.from);
  text += ' ';
  append_number(text, range.to);
  text += axis.unit == Unit::degrees ? " degrees" : axis.unit == Unit::radians ? " radians" : " none";
  text += axis.scale == Scale::logarithmic ? " log" : " linear";
  append_attribute(out, name, text);
  std::string label;
  append_html(label, axis.label);
  if (!label.empty()) append_attribute(out, name + "-label", label);
}

std::string plot_box(const Box& box) {
  std::string text;
  for (const double value : {box.x, box.y, box.w, box.h}) {
    if (!text.empty()) text += ' ';
    append_fixed(text, value);
  }
  return text;
}

} // namespace

std::string reading_attributes(Kind kind, const PanelPlan& plan) {
  const Panel& panel = *plan.panel;
  std::string out;
  append_attribute(out, "kind", kind_of(kind).name);
  append_attribute(out, "plot", plot_box(plan.plot));
  Axis x = panel.x;
  if (kind == Kind::polar && x.unit == Unit::none) x.unit = Unit::degrees; // as its spokes are labelled
  Axis y = panel.y;
  if (kind == Kind::profile) {
    x.label = "x";
    y.label = "height";
  }
  append_axis(out, "x", x, plan.x);
  append_axis(out, "y", y, plan.y);
  if (kind != Kind::heatmap) return out;
  append_axis(out, "value", panel.value.value_or(Axis{}), plan.value);
  append_attribute(out, "panel", strip_markup(panel.title));
  append_attribute(out, "columns",
                   (panel.x.column.empty() ? "x" : panel.x.column) + "," +
                       (panel.y.column.empty() ? "y" : panel.y.column));
  return out;
}

} // namespace brdfplot::plot
