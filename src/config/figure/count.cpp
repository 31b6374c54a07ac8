#include "config/figure/count.hpp"

#include "base/number.hpp"
#include "figure/description.hpp"

#include <algorithm>

namespace brdfplot::config {

namespace {

/// Points drawn take some 10 bytes each in the SVG, simulated ones a file each.
constexpr double most_points = 1e7;
constexpr double most_simulated = 1e5;

/// A count that an integer may not hold.
std::string count_text(double count) {
  return count < 1e15 ? std::to_string(static_cast<long long>(count)) : format_number(count);
}

/// How often a panel or series with this `for_each` is made.
double repetitions(const Json& object) {
  if (!object.contains("for_each")) return 1;
  const Json& loops = object["for_each"];
  if (loops.is_object()) return static_cast<double>(loops["values"].size());
  double count = 1;
  for (const Json& loop : loops) count *= static_cast<double>(loop["values"].size());
  return count;
}

/// Points of the longest simulation among the operands of an expression; 0: there is none.
double simulated_samples(const Json& expression) {
  if (expression.contains("simulate")) return expression["simulate"].value("samples", plot::Simulate{}.samples);
  double most = 0;
  for (const char* key : {"ratio", "difference"})
    if (expression.contains(key))
      for (const Json& operand : expression[key]) most = std::max(most, simulated_samples(operand));
  if (expression.contains("absolute")) most = std::max(most, simulated_samples(expression["absolute"]));
  return most;
}

class Count {
public:
  explicit Count(const JsonFile& file) : file_(file) {}

  void add_panel(const Json& panel, const std::string& pointer) {
    const Json& root = file_.root();
    const double panels = repetitions(panel);
    add(panels_, panels, most_panels, "panels", pointer);
    double samples = 1;
    for (const Json* level : {&root, &panel})
      if (level->contains("x")) samples = (*level)["x"].value("samples", samples);
    if (panel.value("kind", root["kind"]) == "heatmap") {
      const double cells = root.value("cells", plot::FigureDescription{}.cells);
      samples = cells * cells;
    }
    if (panel.contains("sphere")) {
      double side = plot::SphereDescription{}.pixels;
      for (const Json* level : {&root, &panel})
        if (level->contains("sphere")) side = (*level)["sphere"].value("pixels", side);
      add(pixels_, panels * side * side, most_points, "pixels", pointer);
    }
    if (!panel.contains("series")) return;
    for (std::size_t k = 0; k < panel["series"].size(); ++k) {
      const Json& one = panel["series"][k];
      const std::string at = pointer + "/series/" + std::to_string(k);
      std::string channel;
      for (const Json* level : {&root, &panel, &one}) channel = level->value("channel", channel);
      const double series = panels * repetitions(one) * (channel == "rgb" ? 3 : 1);
      add(series_, series, most_series, "series", at);
      add(points_, series * samples, most_points, "points", at);
      add(simulated_, series * simulated_samples(one), most_simulated, "simulated points", at);
    }
  }

private:
  void add(double& sum, double count, double most, const std::string& what, const std::string& pointer) const {
    sum += count;
    if (sum > most)
      file_.fail(pointer, count_text(sum) + " " + what + "; accepted: at most " + count_text(most) + " in one figure");
  }

  const JsonFile& file_;
  double panels_ = 0, series_ = 0, points_ = 0, simulated_ = 0, pixels_ = 0;
};

} // namespace

void check_count(const JsonFile& file) {
  Count count(file);
  const Json& panels = file.root()["panels"];
  for (std::size_t k = 0; k < panels.size(); ++k) count.add_panel(panels[k], "/panels/" + std::to_string(k));
}

} // namespace brdfplot::config
