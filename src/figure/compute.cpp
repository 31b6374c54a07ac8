#include "base/errors.hpp"
#include "base/number.hpp"
#include "figure/contour.hpp"
#include "figure/description.hpp"
#include "figure/numbers.hpp"
#include "figure/profile/autocorrelation.hpp"
#include "figure/profile/panel.hpp"
#include "figure/sampling.hpp"
#include "figure/series/compare.hpp"
#include "figure/series/evaluator.hpp"
#include "figure/spheres/panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace brdfplot::plot {

namespace {

using simulation::Measured;

/// Labels may hold anything; errors are one line.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

/// Rethrows an error with the series that it belongs to.
template <class Function>
auto naming(const std::string& where, const Function& function) {
  try {
    return function();
  } catch (const AccuracyError& error) {
    throw AccuracyError(where, one_line(error.what()));
  } catch (const MaterialError& error) {
    throw InputError(where, error.pointer() + ": " + one_line(error.reason()));
  } catch (const InputError& error) {
    throw InputError(where, one_line(error.what()));
  }
}

/// "fig4, panel "Smith", series 2": by title and label, by number where there is none.
std::string place(const FigureDescription& figure, const PanelDescription& panel,
                  std::optional<std::size_t> series = {}) {
  const auto call = [](const std::string& what, const std::string& name, std::ptrdiff_t index) {
    return ", " + what + " " + (name.empty() ? std::to_string(index + 1) : "\"" + one_line(name) + "\"");
  };
  std::string where = one_line(figure.id) + call("panel", panel.title, &panel - figure.panels.data());
  if (!series) return where;
  return where + call("series", panel.series.at(*series).label, static_cast<std::ptrdiff_t>(*series));
}

/// Series of one label share a style, in the order in which labels appear; the channels of one family do. Beside
/// channels the others leave the colours of red, green and blue, the first three of the palette, to them.
class Styles {
public:
  explicit Styles(const FigureDescription& figure)
      : beside_channels_(std::ranges::any_of(figure.panels, [](const PanelDescription& panel) {
          const auto coloured =
              std::ranges::count_if(panel.series, [](const auto& one) { return one.hue.has_value(); });
          return coloured > 0 && coloured < std::ssize(panel.series);
        })) {}

  int of(const SeriesDescription& series) {
    if (series.hue) return place_of(series.family, families_);
    const int place = place_of(series.label, labels_);
    constexpr std::array<int, 4> left = {6, 3, 4, 5}; // of seven colours; ink first
    constexpr int count = static_cast<int>(left.size());
    return beside_channels_ ? left[static_cast<std::size_t>(place % count)] + 7 * (place / count) : place;
  }

private:
  static int place_of(const std::string& name, std::vector<std::string>& names) {
    const auto found = std::ranges::find(names, name);
    const auto index = found - names.begin();
    if (found == names.end()) names.push_back(name);
    return static_cast<int>(index);
  }

  bool beside_channels_;
  std::vector<std::string> labels_, families_;
};

/// `values` places along the axis, evenly spaced on its scale: (k + offset) / count of the way.
std::vector<double> lattice(const Axis& axis, int count, double offset, int values) {
  std::vector<double> out;
  const bool logarithmic = axis.scale == Scale::logarithmic;
  for (int k = 0; k < values; ++k) {
    const double t = (k + offset) / count;
    out.push_back(logarithmic ? axis.from * std::pow(axis.to / axis.from, t) : axis.from + (axis.to - axis.from) * t);
  }
  return out;
}

/// Lowest and highest value of a panel.
struct Extremes {
  double low = infinity;
  double high = -infinity;

  void widen(const Axis& axis, double y) {
    if (!std::isfinite(y) || (axis.scale == Scale::logarithmic && y <= 0)) return;
    low = std::min(low, y);
    high = std::max(high, y);
  }
};

/// A series that is computed.
class CurveSource {
public:
  CurveSource(const FigureDescription& figure, const PanelDescription& panel, Evaluator evaluator)
      : evaluator_(std::move(evaluator)) {
    request_.x = panel.x;
    request_.y = panel.y;
    request_.polar = kind_in(figure, panel) == Kind::polar;
    request_.adaptive = panel.samples == 0;
    if (evaluator_.costly()) request_.noise = figure.tolerance;
    if (panel.samples > 0)
      request_.initial = panel.samples;
    else if (evaluator_.costly())
      request_.initial = 33;
    else
      request_.seeds = evaluator_.seeds(panel.x.column);
  }

  /// Widens the extremes to the values at the first points.
  void widen(Extremes& extremes) {
    for (const double y : evaluator_({first_points(request_)})) extremes.widen(request_.y, y);
  }

  Curve draw(const Extremes& extremes) {
    if (std::isnan(request_.y.from) && extremes.low < extremes.high) request_.y.from = extremes.low;
    if (std::isnan(request_.y.to) && extremes.low < extremes.high) request_.y.to = extremes.high;
    return sample([this](const std::vector<double>& x) { return evaluator_({x}); }, request_);
  }

private:
  Evaluator evaluator_;
  CurveRequest request_;
};

/// Where simulations come from.
struct Simulator {
  simulation::Store& store;
  int threads;
};

/// The points of a simulated series.
std::vector<double> simulated_points(const PanelDescription& panel, const SimulatedTerm& term) {
  const int samples = term.samples();
  return term.is_binned() ? lattice(panel.x, samples, 0.5, samples) : lattice(panel.x, samples - 1, 0, samples);
}

Series simulate(const PanelDescription& panel, const Evaluator& evaluator, const Simulator& simulator) {
  Series series;
  series.x = simulated_points(panel, *evaluator.simulated().front());
  for (const Measured& measured : evaluator.measure(series.x, simulator.store, simulator.threads)) {
    series.y.push_back(measured.value);
    series.error.push_back(measured.standard_error);
  }
  return series;
}

/// The series of a panel, those that are computed each as fine as the range of all of them asks for.
void fill_curves(const FigureDescription& figure, const PanelDescription& description, const Simulator& simulator,
                 FirstValues& first, Styles& styles, Panel& panel) {
  std::vector<std::optional<CurveSource>> sources(description.series.size());
  panel.series.resize(sources.size());
  Extremes extremes;
  for (std::size_t k = 0; k < sources.size(); ++k)
    naming(place(figure, description, k), [&] {
      Evaluator evaluator(description.series[k].value, {description.x.column}, figure.tolerance, &first);
      if (evaluator.simulated().empty()) {
        sources[k].emplace(figure, description, std::move(evaluator)).widen(extremes);
        return;
      }
      panel.series[k] = simulate(description, evaluator, simulator);
      for (const double y : panel.series[k].y) extremes.widen(description.y, y);
    });
  for (std::size_t k = 0; k < sources.size(); ++k) {
    Series& series = panel.series[k];
    if (sources[k]) {
      Curve points = naming(place(figure, description, k), [&] { return sources[k]->draw(extremes); });
      series.x = std::move(points.x);
      series.y = std::move(points.y);
    }
    series.label = description.series[k].label;
    series.style = styles.of(description.series[k]);
    series.ramp = description.series[k].ramp;
    series.hue = description.series[k].hue;
  }
  if (!description.compare_to) return;
  naming(place(figure, description, 0), [&] {
    const SimulatedTerm simulated(*description.compare_to, {description.x.column});
    panel.notes = compare_lobes(description.series[0].value.term, simulated, simulated_points(description, simulated),
                                simulator.store, simulator.threads);
    for (const Note& note : panel.notes)
      if (!std::isfinite(note.value))
        throw AccuracyError(note.label, "found " + format_number(note.value) + ", accepted: a finite number");
  });
}

void fill_heatmap(const FigureDescription& figure, const PanelDescription& description, Panel& panel) {
  const Evaluator evaluator(description.series.at(0).value, {description.x.column, description.y.column},
                            figure.tolerance);
  Grid grid{lattice(description.x, figure.cells, 0.5, figure.cells),
            lattice(description.y, figure.cells, 0.5, figure.cells),
            {}};
  SweptColumns cells(2);
  for (const double y : grid.y)
    for (const double x : grid.x) {
      cells[0].push_back(x);
      cells[1].push_back(y);
    }
  grid.value = evaluator(cells);
  panel.grid = std::move(grid);
  const PlaneFunction value = [&](const std::vector<double>& x, const std::vector<double>& y) {
    return evaluator({x, y});
  };
  for (const auto& contour : description.contours)
    panel.contours.push_back(
        {contour.label, level_lines(value, contour.level, lattice(description.x, figure.cells, 0, figure.cells + 1),
                                    lattice(description.y, figure.cells, 0, figure.cells + 1))});
}

} // namespace

Figure compute(const FigureDescription& description, simulation::Store& store, int threads) {
  Figure figure{description.id,
                description.title,
                description.caption,
                description.kind,
                description.columns,
                description.share,
                {}};
  Styles styles(description);
  FirstValues first;
  const auto computed = [&](const PanelDescription& from) {
    const Kind kind = kind_in(description, from);
    if (kind == Kind::profile) return naming(place(description, from), [&] { return profile_panel(from); });
    if (kind == Kind::spheres) return naming(place(description, from), [&] { return sphere_panel(from, threads); });
    if (from.autocorrelation) return naming(place(description, from), [&] { return autocorrelation_panel(from); });
    Panel panel{from.title, from.x, from.y, {}, from.arrows, from.value, {}, {}, {}};
    if (kind == Kind::heatmap)
      naming(place(description, from, 0), [&] { fill_heatmap(description, from, panel); });
    else
      fill_curves(description, from, {store, threads}, first, styles, panel);
    return panel;
  };
  for (const auto& from : description.panels) {
    Panel panel = computed(from);
    panel.drawn = from.drawn;
    panel.kind = from.kind;
    figure.panels.push_back(std::move(panel));
  }
  figure.description = naming(one_line(description.id) + ", caption",
                              [&] { return caption_with(description.caption, description.numbers, figure); });
  return figure;
}

Figure compute(const FigureDescription& description) {
  simulation::Store store;
  return compute(description, store);
}

std::vector<SimulationTask> simulations(const FigureDescription& description) {
  std::vector<SimulationTask> tasks;
  std::set<std::string> keys;
  const auto add = [&](const SimulatedTerm& term, const std::vector<double>& x, const std::string& where) {
    for (auto& job : term.jobs(x)) {
      if (!keys.insert(job.key).second) continue;
      const std::string key = job.key;
      const double work = term.work(job);
      auto run = [term, job = std::move(job)](simulation::Store& store, int threads) {
        store.get(job.key, [&] { return term.run(job, threads); });
      };
      tasks.push_back({key, where, std::move(run), work});
    }
  };
  for (const auto& panel : description.panels) {
    const Kind kind = kind_in(description, panel);
    if (kind != Kind::lines && kind != Kind::polar) continue;
    for (std::size_t k = 0; k < panel.series.size(); ++k) {
      const std::string where = place(description, panel, k);
      naming(where, [&] {
        const Evaluator evaluator(panel.series[k].value, {panel.x.column}, description.tolerance);
        for (const SimulatedTerm* term : evaluator.simulated())
          add(*term, simulated_points(panel, *evaluator.simulated().front()), where);
      });
    }
    if (!panel.compare_to) continue;
    const std::string where = place(description, panel, 0);
    naming(where, [&] {
      const SimulatedTerm term(*panel.compare_to, {panel.x.column});
      add(term, simulated_points(panel, term), where);
    });
  }
  return tasks;
}

} // namespace brdfplot::plot
