#include "base/errors.hpp"
#include "base/interrupt.hpp"
#include "base/number.hpp"
#include "base/warnings.hpp"
#include "config/figure_count.hpp"
#include "config/figure_numbers.hpp"
#include "config/figure_profile.hpp"
#include "config/figure_scope.hpp"
#include "config/figure_sphere.hpp"
#include "config/load.hpp"
#include "config/quick_figure.hpp"
#include "config/shapes.hpp"
#include "figure/series/simulated.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace brdfplot::config {

namespace {

using plot::Expression;

plot::Kind kind_named(const std::string& name) {
  const auto found = std::ranges::find(plot::panel_kinds, name, &plot::PanelKind::name);
  return static_cast<plot::Kind>(found - plot::panel_kinds.begin());
}

class Reader {
public:
  explicit Reader(const JsonFile& file) : file_(file) {}

  plot::FigureDescription figure() {
    const Json& root = file_.root();
    plot::FigureDescription out;
    out.id = root["id"].get<std::string>();
    out.title = root["title"].get<std::string>();
    out.caption = root["caption"].get<std::string>();
    out.kind = kind_ = kind_named(root["kind"].get<std::string>());
    out.columns = root.value("columns", 1);
    out.share = std::map<std::string, plot::Share>{{"none", plot::Share::none},
                                                   {"rows", plot::Share::rows},
                                                   {"all", plot::Share::all}}
                    .at(root.value("share", "none"));
    out.tolerance = tolerance_ = root.value("tolerance", out.tolerance);
    out.cells = root.value("cells", out.cells);
    const Json materials = root.value("materials", Json::object());
    for (const auto& [name, value] : materials.items())
      materials_.emplace(name, read_material(file_, value, step("/materials", name)));
    Scope scope;
    enter(scope, root, "");
    for (std::size_t k = 0; k < root["panels"].size(); ++k) {
      const std::string pointer = "/panels/" + std::to_string(k);
      for_each(root["panels"][k], pointer, scope, [&](const Scope& inner, std::optional<double>) {
        out.panels.push_back(panel(root["panels"][k], pointer, inner));
      });
    }
    out.numbers = read_numbers(file_, out);
    return out;
  }

private:
  /// Takes `material` and `at` of an object into the scope.
  void enter(Scope& scope, const Json& object, const std::string& pointer) {
    if (object.contains("material")) {
      const Json& value = object["material"];
      if (value.is_object()) {
        scope.material = read_material(file_, value, pointer + "/material");
      } else {
        const auto name = value.get<std::string>();
        std::vector<std::string> names;
        for (const auto& [key, material] : materials_) names.push_back(key);
        if (!materials_.contains(name)) file_.fail(pointer + "/material", unknown_name("material", name, names));
        scope.material = materials_.at(name);
      }
    }
    if (object.contains("channel"))
      scope.set({"channel", object["channel"].get<std::string>()}, step(pointer, "channel"));
    if (!object.contains("at")) return;
    for (const auto& [variable, value] : object["at"].items()) {
      mind_degrees(variable, value, step(pointer + "/at", variable));
      scope.set(to_setting(variable, value), step(pointer + "/at", variable));
    }
  }

  /// Warns of an angle whose unit was forgotten.
  void mind_degrees(const std::string& variable, const Json& value, const std::string& pointer) const {
    if (value.is_number() && (variable.starts_with("theta_") || variable.starts_with("phi_")))
      warn_of_degrees(file_.where(pointer), variable, value.get<double>());
  }

  /// One variable of a `for_each`, and where it stands.
  struct Loop {
    Json json;
    std::string place;
  };

  /// Calls `make` for every combination of the values of `for_each` (once when there is none), with the place of the
  /// value among its fellows in [0, 1] where they form a family of numbers.
  template <class Make>
  void for_each(const Json& object, const std::string& pointer, const Scope& scope, const Make& make) {
    std::vector<Loop> loops;
    if (object.contains("for_each")) {
      const Json& json = object["for_each"];
      if (json.is_array())
        for (std::size_t k = 0; k < json.size(); ++k)
          loops.push_back({json[k], pointer + "/for_each/" + std::to_string(k)});
      else
        loops.push_back({json, pointer + "/for_each"});
    }
    nest(loops, 0, scope, {}, make);
  }

  template <class Make>
  void nest(const std::vector<Loop>& loops, std::size_t depth, const Scope& scope, std::optional<double> ramp,
            const Make& make) {
    if (depth == loops.size()) return make(scope, ramp);
    const Json& loop = loops[depth].json;
    const std::string& place = loops[depth].place;
    const auto variable = loop["variable"].get<std::string>();
    const Json& values = loop["values"];
    if (loop.contains("labels") && loop["labels"].size() != values.size())
      file_.fail(place + "/labels", "found " + std::to_string(loop["labels"].size()) + " labels for " +
                                        std::to_string(values.size()) + " values, accepted: as many");
    const bool family = loops.size() == 1 && values.size() >= 5 && std::ranges::all_of(values, is_numeric);
    for (std::size_t k = 0; k < values.size(); ++k) {
      throw_if_interrupted();
      Scope inner = scope;
      mind_degrees(variable, values[k], place + "/values/" + std::to_string(k));
      inner.set(to_setting(variable, values[k]), place + "/values/" + std::to_string(k));
      inner.words[variable] = loop.contains("labels") ? loop["labels"][k].get<std::string>() : word_for(values[k]);
      nest(loops, depth + 1, inner,
           family ? std::optional(static_cast<double>(k) / static_cast<double>(values.size() - 1)) : ramp, make);
    }
  }

  /// Where the axis `key` of a panel stands: in the panel, or in the figure, or it is missing in the panel.
  std::string axis_place(const Json& panel, const std::string& pointer, const std::string& key) const {
    if (panel.contains(key)) return pointer + "/" + key;
    return file_.root().contains(key) ? "/" + key : pointer;
  }

  plot::Axis axis(const Json& panel, const std::string& pointer, const std::string& key, bool swept) {
    Json merged = file_.root().value(key, Json::object());
    if (panel.contains(key))
      for (const auto& [name, value] : panel[key].items()) merged[name] = value;
    plot::Axis axis;
    axis.column = merged.value("variable", "");
    axis.label = merged.value("label", axis.column);
    axis.scale = merged.value("scale", "linear") == "log" ? plot::Scale::logarithmic : plot::Scale::linear;
    const std::string unit = merged.value("unit", "none");
    axis.unit = unit == "degrees" ? plot::Unit::degrees : unit == "radians" ? plot::Unit::radians : plot::Unit::none;
    if (merged.contains("from")) axis.from = to_number(merged["from"]);
    if (merged.contains("to")) axis.to = to_number(merged["to"]);
    const std::string place = axis_place(panel, pointer, key);
    for (const char* end : {"from", "to"})
      if (swept && merged.contains(end)) mind_degrees(axis.column, merged[end], step(place, end));
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

  /// The text at `key`, with the words of what `for_each` runs over.
  std::string worded(const Json& object, const std::string& pointer, const std::string& key, const Scope& scope) const {
    std::string text = substituted(object.value(key, ""), scope.words);
    for (const std::string& name : plot::names_in(text)) {
      std::vector<std::string> names;
      for (const auto& [variable, word] : scope.words) names.push_back(variable);
      file_.fail(step(pointer, key), unknown_name("variable of for_each", name, names));
    }
    return text;
  }

  /// A panel has what its kind draws: a profile, a sphere or else series.
  void check_content(const Json& object, const std::string& pointer) const {
    for (const auto& [kind, key] : {std::pair{plot::Kind::profile, "profile"}, {plot::Kind::spheres, "sphere"}}) {
      if (object.contains(key) == (kind_ == kind)) continue;
      const std::string name(plot::kind_of(kind).name), quoted = "\"" + std::string(key) + "\"";
      file_.fail(pointer, kind_ == kind ? "a " + std::string(key) + " has " + quoted + ", not \"series\""
                                        : "only a figure of kind \"" + name + "\" has " + quoted);
    }
  }

  plot::PanelDescription panel(const Json& object, const std::string& pointer, Scope scope) {
    enter(scope, object, pointer);
    plot::PanelDescription out;
    out.title = worded(object, pointer, "title", scope);
    out.drawn = object.value("drawn", true);
    check_content(object, pointer);
    if (kind_ == plot::Kind::profile) return profile(object, pointer, std::move(out));
    if (kind_ == plot::Kind::spheres) return sphere(object, pointer, scope, std::move(out));
    const bool heatmap = kind_ == plot::Kind::heatmap;
    out.x = axis(object, pointer, "x", true);
    out.y = axis(object, pointer, "y", heatmap);
    for (const Json* level : {&file_.root(), &object})
      if (level->contains("x")) out.samples = (*level)["x"].value("samples", out.samples);
    if (heatmap) out.value = axis(object, pointer, "value", false);
    const auto sweep = [&](const plot::Axis& axis, const std::string& key) {
      return Sweep{axis.column, axis_place(object, pointer, key), axis.from, axis.to};
    };
    swept_ = {sweep(out.x, "x")};
    if (heatmap) swept_.push_back(sweep(out.y, "y"));
    for (std::size_t k = 0; k < object["series"].size(); ++k) {
      const std::string at = pointer + "/series/" + std::to_string(k);
      const Json& one = object["series"][k];
      for_each(one, at, scope, [&](const Scope& inner, std::optional<double> ramp) {
        out.series.push_back({worded(one, at, "label", inner), expression(one, at, inner), ramp});
      });
    }
    if (object.contains("compare_to")) out.compare_to = compared(object["compare_to"], pointer, scope, out);
    if (heatmap && out.series.size() != 1) file_.fail(pointer + "/series", "a heat map has one series");
    if (!heatmap && object.contains("contours")) file_.fail(pointer + "/contours", "only a heat map has contours");
    if (kind_ != plot::Kind::polar && object.contains("arrows"))
      file_.fail(pointer + "/arrows", "only a polar plot has arrows");
    const Json contours = object.value("contours", Json::array());
    for (const auto& contour : contours)
      out.contours.push_back({contour["label"].get<std::string>(), contour["level"].get<double>()});
    const Json arrows = object.value("arrows", Json::array());
    for (const auto& arrow : arrows) out.arrows.push_back(to_arrow(arrow.get<std::string>(), scope, pointer));
    return out;
  }

  /// A panel that is a sphere.
  plot::PanelDescription sphere(const Json& object, const std::string& pointer, const Scope& scope,
                                plot::PanelDescription out) const {
    for (const char* key : {"x", "y", "value", "compare_to", "arrows", "contours"})
      for (const auto& [level, place] : {std::pair{&object, pointer}, {&file_.root(), std::string()}})
        if (level->contains(key)) file_.fail(step(place, key), "a sphere has no \"" + std::string(key) + "\"");
    out.x.column = "position";
    out.y.column = "radiance";
    out.sphere = read_sphere(file_, object, pointer, scope, tolerance_);
    return out;
  }

  /// A panel that is a profile.
  plot::PanelDescription profile(const Json& object, const std::string& pointer, plot::PanelDescription out) {
    for (const char* key : {"x", "y", "value", "material", "at", "compare_to", "arrows", "contours", "for_each"})
      if (object.contains(key)) file_.fail(step(pointer, key), "a profile has no \"" + std::string(key) + "\"");
    out.x.column = "x";
    out.y.column = "height";
    out.profile = read_profile(file_, object, pointer);
    return out;
  }

  /// `compare_to` of a panel.
  plot::Term compared(const Json& object, const std::string& pointer, const Scope& scope,
                      const plot::PanelDescription& panel) {
    const std::string at = step(pointer, "compare_to");
    const Expression reference = expression(object, at, scope);
    const bool lobe = reference.operation == Expression::Operation::term && reference.term.simulate &&
                      reference.term.quantity == "brdf_cos" &&
                      plot::SimulatedTerm(reference.term, {panel.x.column}).is_binned();
    if (kind_ != plot::Kind::polar || panel.x.column != "theta_i" || !lobe)
      file_.fail(at, "accepted: in a polar plot over theta_i, \"brdf_cos\" simulated by \"surface\"");
    const Expression& first = panel.series.at(0).value;
    if (first.operation != Expression::Operation::term || first.term.simulate)
      file_.fail(at, "the first series is no computed quantity");
    return reference.term;
  }

  plot::Arrow to_arrow(const std::string& name, const Scope& scope, const std::string& pointer) {
    const std::string variable = name == "omega_i" ? "theta_i" : "theta_o";
    double theta = plot::automatic;
    for (const auto& setting : scope.at)
      if (setting.variable == variable) theta = std::get<double>(setting.value);
    if (std::isnan(theta))
      file_.fail(pointer + "/arrows", "\"" + name + "\" needs \"" + variable + "\" in the panel's \"at\"");
    if (name == "mirror") return {"mirror", -theta, false};
    return {name == "omega_o" ? "ω_o" : "ω_i", theta, name == "omega_i"};
  }

  Expression expression(const Json& object, const std::string& pointer, Scope scope) {
    enter(scope, object, pointer);
    Expression out;
    const auto operands = [&](const std::string& key, Expression::Operation operation) {
      out.operation = operation;
      for (std::size_t k = 0; k < object[key].size(); ++k)
        out.operands.push_back(expression(object[key][k], step(step(pointer, key), std::to_string(k)), scope));
    };
    if (object.contains("ratio"))
      operands("ratio", Expression::Operation::ratio);
    else if (object.contains("difference"))
      operands("difference", Expression::Operation::difference);
    else if (object.contains("absolute")) {
      out.operation = Expression::Operation::absolute;
      out.operands.push_back(expression(object["absolute"], step(pointer, "absolute"), scope));
    } else {
      if (!scope.material) file_.fail(pointer, "\"material\" is missing here and above");
      out.term = {object["quantity"].get<std::string>(), *scope.material, scope.at, {}};
      if (object.contains("simulate")) {
        if (kind_ == plot::Kind::heatmap) file_.fail(step(pointer, "simulate"), "a heat map is not simulated");
        out.term.simulate = read_simulate(object["simulate"]);
      }
      check_term(file_, out.term, pointer, scope, swept_, tolerance_);
    }
    return out;
  }

  const JsonFile& file_;
  plot::Kind kind_ = plot::Kind::lines;
  double tolerance_ = 0;
  std::map<std::string, MaterialDescription> materials_;
  std::vector<Sweep> swept_;
};

} // namespace

namespace {

plot::FigureDescription read_figure(const JsonFile& file) {
  static const ShapePtr shape = figure_shape();
  file.check(*shape);
  check_count(file);
  return Reader(file).figure();
}

FigureFile figure_of(const JsonFile& file) {
  expect_kind(file, "figure");
  const bool refers = file.text().find("\"$ref\"") != std::string::npos;
  return {read_figure(file), refers ? file.root().dump(2) + "\n" : file.text()};
}

} // namespace

FigureFile load_figure(const std::string& path) { return figure_of(JsonFile(path)); }

FigureFile figure_from_text(const std::string& json, const std::string& name) {
  return figure_of(JsonFile(name, json));
}

plot::FigureDescription load_quick_figure(const QuickFigure& figure) {
  return read_figure(JsonFile("plot", quick_figure(figure, ".")));
}

} // namespace brdfplot::config
