#include "config/figure/numbers.hpp"

#include "models/parameters.hpp"

#include <algorithm>

namespace brdfplot::config {

namespace {

using plot::NumberExpression;
using plot::Reading;

ShapePtr number_expression();

std::vector<Field> expression_of_number() {
  return {{"series", text(), false, "label of what is read; extremes: of all series where none is named"},
          {"note", text(), false, "label of a number that the panel shows"},
          {"panel", either({whole_number(1, 1000), text()}), false, "title or number of its panel; default 1"},
          {"x", angle(), false, "where it is read"},
          {"take", choice({"largest", "smallest"}), false, "instead of x: the extreme of what is drawn"},
          {"from", angle(), false, "extremes: of the points from here"},
          {"to", angle(), false, "extremes: of the points up to here"},
          {"show", choice({"value", "x"}), false, "extremes: the value (default), or where it is"},
          {"magnitude", boolean(), false, "extremes: of absolute values; default false"},
          {"ratio", array(number_expression(), 2, 2), false, "first over second"},
          {"difference", array(number_expression(), 2, 2), false, "first minus second"}};
}

ShapePtr number_expression() {
  return named("number", [] { return object(expression_of_number()); });
}

/// The keys of one number of a caption.
class NumberReader {
public:
  NumberReader(const JsonFile& file, const plot::FigureDescription& figure) : file_(file), figure_(figure) {}

  NumberExpression expression(const Json& value, const std::string& pointer) const {
    const auto count = std::ranges::count_if(std::vector<std::string>{"series", "note", "ratio", "difference"},
                                             [&](const std::string& key) { return value.contains(key); });
    if (count > 1) file_.fail(pointer, "accepted: one of series, note, ratio, difference");
    NumberExpression out;
    for (const auto& [key, operation] : {std::pair{"ratio", NumberExpression::Operation::ratio},
                                         {"difference", NumberExpression::Operation::difference}}) {
      if (!value.contains(key)) continue;
      reject(value, pointer, {"panel", "x", "take", "from", "to", "show", "magnitude"}, key);
      out.operation = operation;
      for (std::size_t k = 0; k < 2; ++k)
        out.operands.push_back(expression(value[key][k], step(step(pointer, key), std::to_string(k))));
      return out;
    }
    out.reading = reading(value, pointer);
    return out;
  }

private:
  void reject(const Json& value, const std::string& pointer, const std::vector<std::string>& keys,
              const std::string& beside) const {
    for (const auto& key : keys)
      if (value.contains(key)) file_.fail(step(pointer, key), "not used beside \"" + beside + "\"");
  }

  Reading reading(const Json& value, const std::string& pointer) const {
    Reading out;
    out.panel = panel(value, pointer);
    const plot::PanelDescription& panel = figure_.panels[out.panel];
    if (value.contains("note")) {
      reject(value, pointer, {"x", "take", "from", "to", "show", "magnitude"}, "note");
      out.take = Reading::Take::note;
      out.series = value["note"].get<std::string>();
      return out;
    }
    if (value.contains("x") == value.contains("take")) file_.fail(pointer, "accepted: one of \"x\" and \"take\"");
    const bool grid = plot::kind_in(figure_, panel) == plot::Kind::heatmap;
    if (grid) reject(value, pointer, {"series", "x", "from", "to", "show"}, "heatmap");
    out.any_series = value.contains("take") && !value.contains("series");
    if (!out.any_series) out.series = series(value, pointer, panel);
    if (value.contains("x")) {
      reject(value, pointer, {"from", "to", "show", "magnitude"}, "x");
      out.x = to_number(value["x"]);
      return out;
    }
    out.take = value["take"] == "largest" ? Reading::Take::largest : Reading::Take::smallest;
    if (value.contains("from")) out.from = to_number(value["from"]);
    if (value.contains("to")) out.to = to_number(value["to"]);
    out.place = value.value("show", "value") == "x";
    out.magnitude = value.value("magnitude", false);
    return out;
  }

  std::size_t panel(const Json& value, const std::string& pointer) const {
    if (!value.contains("panel")) return 0;
    const Json& which = value["panel"];
    if (which.is_string()) {
      const auto found = std::ranges::find(figure_.panels, which.get<std::string>(), &plot::PanelDescription::title);
      if (found != figure_.panels.end()) return static_cast<std::size_t>(found - figure_.panels.begin());
      std::vector<std::string> titles;
      for (const auto& one : figure_.panels) titles.push_back(one.title);
      file_.fail(pointer + "/panel", unknown_name("panel", which.get<std::string>(), titles));
    }
    const auto number = which.get<std::size_t>();
    if (number > figure_.panels.size())
      file_.fail(pointer + "/panel",
                 "found " + std::to_string(number) + "; accepted: 1 to " + std::to_string(figure_.panels.size()));
    return number - 1;
  }

  /// Spheres name their series after channels.
  std::string series(const Json& value, const std::string& pointer, const plot::PanelDescription& panel) const {
    if (!value.contains("series")) file_.fail(pointer, "\"series\" is missing");
    auto label = value["series"].get<std::string>();
    std::vector<std::string> labels;
    for (const auto& one : panel.series) labels.push_back(one.label);
    if (!panel.sphere && std::ranges::find(labels, label) == labels.end())
      file_.fail(pointer + "/series", unknown_name("series", label, labels));
    return label;
  }

  const JsonFile& file_;
  const plot::FigureDescription& figure_;
};

} // namespace

ShapePtr numbers_shape() {
  auto fields = expression_of_number();
  fields.push_back(
      {"unit", choice({"none", "percent", "degrees"}), false, "how it is written; degrees: of radians; default none"});
  fields.push_back({"digits", whole_number(1, 9), false, "significant ones; default 2"});
  return map(object(fields), "what {name} in the caption becomes: a number read from the figure's data");
}

std::vector<plot::NumberDescription> read_numbers(const JsonFile& file, const plot::FigureDescription& figure) {
  using Form = plot::NumberDescription::Form;
  const std::vector<std::string> used = plot::names_in(figure.caption);
  std::vector<plot::NumberDescription> out;
  const Json numbers = file.root().value("numbers", Json::object());
  std::vector<std::string> names;
  for (const auto& [name, value] : numbers.items()) {
    const std::string pointer = step("/numbers", name);
    names.push_back(name);
    if (std::ranges::find(used, name) == used.end()) file.fail(pointer, "the caption has no {" + name + "}");
    const std::string unit = value.value("unit", "none");
    out.push_back({name, NumberReader(file, figure).expression(value, pointer),
                   unit == "percent"   ? Form::percent
                   : unit == "degrees" ? Form::degrees
                                       : Form::plain,
                   value.value("digits", 2)});
  }
  for (const auto& name : used)
    if (std::ranges::find(names, name) == names.end()) file.fail("/caption", unknown_name("number", name, names));
  return out;
}

} // namespace brdfplot::config
