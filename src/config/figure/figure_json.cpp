#include "config/figure/count.hpp"
#include "config/figure/numbers.hpp"
#include "config/figure/panel.hpp"
#include "config/load.hpp"
#include "config/quick_figure.hpp"

#include <map>

namespace brdfplot::config {

namespace {

plot::FigureDescription read_figure(const JsonFile& file) {
  static const ShapePtr shape = figure_shape();
  file.check(*shape);
  check_count(file);
  const Json& root = file.root();
  plot::FigureDescription out;
  out.id = root["id"].get<std::string>();
  out.title = root["title"].get<std::string>();
  out.caption = root["caption"].get<std::string>();
  out.kind = kind_named(root["kind"].get<std::string>());
  out.columns = root.value("columns", 1);
  const std::map<std::string, plot::Share> shares = {
      {"none", plot::Share::none}, {"rows", plot::Share::rows}, {"all", plot::Share::all}};
  out.share = shares.at(root.value("share", "none"));
  out.tolerance = root.value("tolerance", out.tolerance);
  out.cells = root.value("cells", out.cells);
  const Levels levels(file);
  const PanelContext context{file, levels, out.kind, out.tolerance};
  Scope scope;
  levels.enter(scope, root, "");
  for (std::size_t k = 0; k < root["panels"].size(); ++k) {
    const std::string pointer = "/panels/" + std::to_string(k);
    levels.for_each(root["panels"][k], pointer, scope, [&](const Scope& inner, std::optional<double>) {
      out.panels.push_back(read_panel(context, root["panels"][k], pointer, inner));
    });
  }
  out.numbers = read_numbers(file, out);
  return out;
}

FigureFile figure_of(const JsonFile& file) {
  expect_kind(file, "figure");
  return {read_figure(file), file.shown()};
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
