#include "config/figure/panel.hpp"

#include "base/number.hpp"
#include "config/figure/profile.hpp"
#include "config/figure/series.hpp"
#include "config/figure/sphere.hpp"
#include "figure/series/configuration.hpp"
#include "figure/series/simulated.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brdfplot::config {

namespace {

using plot::Expression;

class PanelReader {
public:
  PanelReader(const PanelContext& context, const Json& object, std::string pointer)
      : context_(context), file_(context.file), object_(object), pointer_(std::move(pointer)),
        kind_(object.contains("kind") ? kind_named(object["kind"].get<std::string>()) : context.kind) {}

  plot::PanelDescription read(Scope scope) const {
    context_.levels.enter(scope, object_, pointer_);
    plot::PanelDescription out;
    out.title = worded(file_, object_, pointer_, "title", scope);
    out.drawn = object_.value("drawn", true);
    if (object_.contains("kind")) out.kind = kind_;
    check_content();
    if (kind_ == plot::Kind::profile) return profile(std::move(out));
    if (kind_ == plot::Kind::spheres) return sphere(scope, std::move(out));
    if (object_.contains("autocorrelation")) return autocorrelation(std::move(out));
    return curves(scope, std::move(out));
  }

private:
  /// Where the axis `key` of a panel stands: in the panel, or in the figure, or it is missing in the panel.
  std::string axis_place(const std::string& key) const {
    if (object_.contains(key)) return pointer_ + "/" + key;
    return file_.root().contains(key) ? "/" + key : pointer_;
  }

  plot::Axis axis(const std::string& key, bool swept) const {
    Json merged = file_.root().value(key, Json::object());
    if (object_.contains(key))
      for (const auto& [name, value] : object_[key].items()) merged[name] = value;
    plot::Axis axis;
    axis.column = merged.value("variable", "");
    axis.label = merged.value("label", axis.column);
    axis.scale = merged.value("scale", "linear") == "log" ? plot::Scale::logarithmic : plot::Scale::linear;
    const std::string unit = merged.value("unit", "none");
    axis.unit = unit == "degrees" ? plot::Unit::degrees : unit == "radians" ? plot::Unit::radians : plot::Unit::none;
    if (merged.contains("from")) axis.from = to_number(merged["from"]);
    if (merged.contains("to")) axis.to = to_number(merged["to"]);
    const std::string place = axis_place(key);
    for (const char* end : {"from", "to"})
      if (swept && merged.contains(end)) mind_degrees(file_, axis.column, merged[end], step(place, end));
    if (swept && axis.column.empty())
      file_.fail(place, "\"variable\" of \"" + key + "\" is missing: what is swept along this axis");
    if (swept && (std::isnan(axis.from) || std::isnan(axis.to)))
      file_.fail(place, "\"" + key + "\" is swept and needs \"from\" and \"to\"");
    if (axis.from >= axis.to)
      file_.fail(place, "found from = " + format_number(axis.from) + " and to = " + format_number(axis.to) +
                            ", accepted: from < to");
    if (axis.scale == plot::Scale::logarithmic && (axis.from <= 0 || axis.to <= 0))
      file_.fail(place, "found " + std::string(axis.from <= 0 ? "from = " : "to = ") +
                            format_number(axis.from <= 0 ? axis.from : axis.to) +
                            " on a log axis, accepted: a number > 0");
    if (axis.column.empty()) axis.column = "value";
    return axis;
  }

  /// A panel has what its kind draws: a profile, a sphere or else series.
  void check_content() const {
    for (const auto& [kind, key] : {std::pair{plot::Kind::profile, "profile"}, {plot::Kind::spheres, "sphere"}}) {
      if (object_.contains(key) == (kind_ == kind)) continue;
      const std::string name(plot::kind_of(kind).name), quoted = "\"" + std::string(key) + "\"";
      file_.fail(pointer_, kind_ == kind ? "a " + std::string(key) + " has " + quoted + ", not \"series\""
                                         : "only a panel of kind \"" + name + "\" has " + quoted);
    }
  }

  /// Lines, a polar plot or a heat map.
  plot::PanelDescription curves(const Scope& scope, plot::PanelDescription out) const {
    const bool heatmap = kind_ == plot::Kind::heatmap;
    out.x = axis("x", true);
    out.y = axis("y", heatmap);
    for (const Json* level : {&file_.root(), &object_})
      if (level->contains("x")) out.samples = (*level)["x"].value("samples", out.samples);
    if (heatmap) out.value = axis("value", false);
    SeriesContext context{file_, context_.levels, kind_, context_.tolerance, {}};
    const auto add_sweep = [&](const plot::Axis& axis, const std::string& key) {
      context.swept.push_back({axis.column, axis_place(key), axis.from, axis.to});
    };
    add_sweep(out.x, "x");
    if (heatmap) add_sweep(out.y, "y");
    out.series = read_series(context, object_, pointer_, scope);
    if (object_.contains("compare_to")) out.compare_to = compared(context, scope, out);
    if (heatmap && out.series.size() != 1) file_.fail(pointer_ + "/series", "a heat map has one series");
    if (!heatmap && object_.contains("contours")) file_.fail(pointer_ + "/contours", "only a heat map has contours");
    if (kind_ != plot::Kind::polar && object_.contains("arrows"))
      file_.fail(pointer_ + "/arrows", "only a polar plot has arrows");
    const Json contours = object_.value("contours", Json::array());
    for (const auto& contour : contours)
      out.contours.push_back({contour["label"].get<std::string>(), contour["level"].get<double>()});
    const Json arrows = object_.value("arrows", Json::array());
    for (const auto& arrow : arrows) out.arrows.push_back(to_arrow(arrow.get<std::string>(), scope, out.x.column));
    return out;
  }

  /// A panel that is a sphere.
  plot::PanelDescription sphere(const Scope& scope, plot::PanelDescription out) const {
    for (const char* key : {"x", "y", "value", "compare_to", "arrows", "contours"})
      for (const auto& [level, place] : {std::pair{&object_, pointer_}, {&file_.root(), std::string()}})
        if (level->contains(key) && (level == &object_ || context_.kind == plot::Kind::spheres))
          file_.fail(step(place, key), "a sphere has no \"" + std::string(key) + "\"");
    out.x.column = "position";
    out.y.column = "radiance";
    out.sphere = read_sphere(file_, object_, pointer_, scope, context_.tolerance);
    return out;
  }

  /// A panel that is a profile.
  plot::PanelDescription profile(plot::PanelDescription out) const {
    for (const char* key : {"x", "y", "value", "material", "at", "compare_to", "arrows", "contours", "for_each"})
      if (object_.contains(key)) file_.fail(step(pointer_, key), "a profile has no \"" + std::string(key) + "\"");
    out.x.column = "x";
    out.y.column = "height";
    out.profile = read_profile(file_, object_, pointer_);
    return out;
  }

  /// Lines that are the autocorrelation of a surface.
  plot::PanelDescription autocorrelation(plot::PanelDescription out) const {
    constexpr double farthest = 2000;
    const std::string at = step(pointer_, "autocorrelation");
    if (kind_ != plot::Kind::lines) file_.fail(at, "only a panel of kind \"lines\" has \"autocorrelation\"");
    for (const char* key : {"series", "value", "material", "at", "compare_to", "arrows", "contours", "for_each"})
      if (object_.contains(key))
        file_.fail(step(pointer_, key), "an autocorrelation has no \"" + std::string(key) + "\"");
    out.x = axis("x", true);
    out.y = axis("y", false);
    const std::string place = axis_place("x");
    if (out.x.column != "distance")
      file_.fail(place, "found \"variable\": \"" + out.x.column + "\"; accepted for an autocorrelation: distance");
    if (!(out.x.from >= 0 && out.x.to <= farthest))
      file_.fail(place, "found from = " + format_number(out.x.from) + " and to = " + format_number(out.x.to) +
                            "; accepted: distances within [0, " + format_number(farthest) + "]");
    out.autocorrelation = read_autocorrelation(file_, object_, pointer_);
    return out;
  }

  /// `compare_to` of a panel.
  plot::Term compared(const SeriesContext& context, const Scope& scope, const plot::PanelDescription& panel) const {
    const std::string at = step(pointer_, "compare_to");
    const Expression reference = read_expression(context, object_["compare_to"], at, scope);
    const bool lobe = reference.operation == Expression::Operation::term && reference.term.simulate &&
                      reference.term.quantity == "brdf_cos" &&
                      plot::SimulatedTerm(reference.term, {panel.x.column}).is_binned();
    if (kind_ != plot::Kind::polar || panel.x.column != "theta_i" || !lobe)
      file_.fail(at, "accepted: in a polar plot over theta_i, \"brdf_cos\" simulated by \"surface\"");
    const Expression& first = panel.series.at(0).value;
    if (first.operation != Expression::Operation::term || first.term.quantity != "brdf_cos" ||
        (first.term.simulate && first.term.simulate->source != "bins"))
      file_.fail(at, "the first series is no computed \"brdf_cos\"");
    return reference.term;
  }

  /// Positive angles are on the viewer's side of the plot, unless the azimuth of what is swept is opposite to his.
  plot::Arrow to_arrow(const std::string& name, const Scope& scope, const std::string& swept) const {
    const std::string variable = name == "omega_i" ? "theta_i" : "theta_o";
    const auto& directions = plot::direction_variables();
    plot::Configuration angles({});
    for (const plot::Setting& setting : scope.at)
      if (std::ranges::find(directions, setting.variable) != directions.end()) angles.set(setting);
    const auto theta = angles.angle(variable);
    if (!theta) file_.fail(pointer_ + "/arrows", "\"" + name + "\" needs \"" + variable + "\" in the panel's \"at\"");
    if (name == "omega_i") return {"ω_i", *theta, true};
    const auto phi = [&](const std::string& of) { return angles.angle("phi_" + of).value_or(0); };
    const bool opposite = swept.starts_with("theta_") && std::cos(phi(swept.substr(6)) - phi("o")) < -1e-9;
    const double viewer = opposite ? -*theta : *theta;
    if (name == "mirror") return {"mirror", -viewer, false};
    return {"ω_o", viewer, false};
  }

  const PanelContext& context_;
  const JsonFile& file_;
  const Json& object_;
  std::string pointer_;
  plot::Kind kind_;
};

} // namespace

plot::Kind kind_named(const std::string& name) {
  const auto found = std::ranges::find(plot::panel_kinds, name, &plot::PanelKind::name);
  return static_cast<plot::Kind>(found - plot::panel_kinds.begin());
}

plot::PanelDescription read_panel(const PanelContext& context, const Json& object, const std::string& pointer,
                                  const Scope& scope) {
  return PanelReader(context, object, pointer).read(scope);
}

} // namespace brdfplot::config
