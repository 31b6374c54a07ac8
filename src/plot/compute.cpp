#include "math/errors.hpp"
#include "plot/contour.hpp"
#include "plot/description.hpp"
#include "plot/sampling.hpp"
#include "plot/term.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace brdfplot::plot {

namespace {

/// An expression with its terms ready to be evaluated.
class Evaluator {
public:
  Evaluator(const Expression& expression, const std::vector<std::string>& swept, double tolerance)
      : operation_(expression.operation) {
    if (operation_ == Expression::Operation::term) terms_.emplace_back(expression.term, swept, tolerance);
    for (const auto& operand : expression.operands) operands_.emplace_back(operand, swept, tolerance);
  }

  double operator()(const std::vector<double>& x) const {
    switch (operation_) {
    case Expression::Operation::term: return terms_[0](x);
    case Expression::Operation::difference: return operands_[0](x) - operands_[1](x);
    case Expression::Operation::ratio: return operands_[0](x) / operands_[1](x);
    case Expression::Operation::absolute: return std::fabs(operands_[0](x));
    }
    return 0;
  }

  /// The first term, for what all share: seeds, and whether values are costly.
  const TermFunction& first() const { return terms_.empty() ? operands_[0].first() : terms_[0]; }

  bool costly() const {
    return (!terms_.empty() && terms_[0].is_integral()) ||
           std::ranges::any_of(operands_, [](const Evaluator& operand) { return operand.costly(); });
  }

private:
  Expression::Operation operation_;
  std::vector<TermFunction> terms_;
  std::vector<Evaluator> operands_;
};

/// Where a curve over `variable` may have something narrow: the mirror direction, the normal, the other direction.
std::vector<double> seeds(const std::string& variable, const Configuration& fixed) {
  const auto theta_o = fixed.theta_o();
  if (variable == "theta_m") return theta_o ? std::vector<double>{0, *theta_o} : std::vector<double>{0};
  if (variable == "theta_i") return theta_o ? std::vector<double>{-*theta_o, *theta_o, 0} : std::vector<double>{0};
  if (variable == "theta_o") return {0};
  if (variable == "phi_i" || variable == "phi_o") return {0, std::numbers::pi};
  return {};
}

/// Rethrows an error with the series that it belongs to.
template <class Function>
auto naming(const std::string& where, const Function& function) {
  try {
    return function();
  } catch (const AccuracyError& error) {
    throw AccuracyError(where, error.what());
  } catch (const MaterialError& error) {
    throw InputError(where, error.pointer() + ": " + error.reason());
  } catch (const InputError& error) {
    throw InputError(where, error.what());
  }
}

std::string place(const FigureDescription& figure, const PanelDescription& panel, const SeriesDescription& series) {
  std::string where = figure.id;
  if (!panel.title.empty()) where += ", panel \"" + panel.title + "\"";
  if (!series.label.empty()) where += ", series \"" + series.label + "\"";
  return where;
}

/// Series of one label share a style, in the order in which labels appear.
class Styles {
public:
  int of(const std::string& label) {
    const auto found = std::ranges::find(labels_, label);
    const auto index = found - labels_.begin();
    if (found == labels_.end()) labels_.push_back(label);
    return static_cast<int>(index);
  }

private:
  std::vector<std::string> labels_;
};

/// A series as a function that remembers: the first points are asked for twice.
class CurveSource {
public:
  CurveSource(const FigureDescription& figure, const PanelDescription& panel, const SeriesDescription& series)
      : evaluator_(series.value, {panel.x.column}, figure.tolerance), request_{
                                                                          panel.x, panel.y, figure.kind == Kind::polar,
                                                                          {},      129,     panel.samples == 0} {
    if (panel.samples > 0)
      request_.initial = panel.samples;
    else if (evaluator_.costly())
      request_.initial = 33;
    else
      request_.seeds = seeds(panel.x.column, evaluator_.first().fixed());
  }

  double value(double x) {
    const auto known = values_.find(x);
    if (known != values_.end()) return known->second;
    return values_.emplace(x, evaluator_({x})).first->second;
  }

  /// Widens [low, high] to the values at the first points.
  void widen(double& low, double& high) {
    for (const double x : first_points(request_)) {
      const double y = value(x);
      if (!std::isfinite(y) || (request_.y.scale == Scale::logarithmic && y <= 0)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }

  Curve draw(double low, double high) {
    if (std::isnan(request_.y.from) && low < high) request_.y.from = low;
    if (std::isnan(request_.y.to) && low < high) request_.y.to = high;
    return sample([this](double x) { return value(x); }, request_);
  }

private:
  Evaluator evaluator_;
  CurveRequest request_;
  std::map<double, double> values_;
};

/// The series of a panel, each as fine as the range of all of them asks for.
void fill_curves(const FigureDescription& figure, const PanelDescription& description, Styles& styles, Panel& panel) {
  std::vector<CurveSource> sources;
  double low = infinity;
  double high = -infinity;
  for (const auto& series : description.series)
    naming(place(figure, description, series), [&] {
      sources.emplace_back(figure, description, series);
      sources.back().widen(low, high);
    });
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const auto& series = description.series[k];
    Curve points = naming(place(figure, description, series), [&] { return sources[k].draw(low, high); });
    panel.series.push_back(
        {series.label, std::move(points.x), std::move(points.y), styles.of(series.label), series.ramp});
  }
}

/// `count` + 1 values from `from` to `to`, evenly spaced on the axis's scale.
std::vector<double> lattice(const Axis& axis, int count, double offset, int values) {
  std::vector<double> out;
  const bool logarithmic = axis.scale == Scale::logarithmic;
  for (int k = 0; k < values; ++k) {
    const double t = (k + offset) / count;
    out.push_back(logarithmic ? axis.from * std::pow(axis.to / axis.from, t) : axis.from + (axis.to - axis.from) * t);
  }
  return out;
}

void fill_heatmap(const FigureDescription& figure, const PanelDescription& description, Panel& panel) {
  const Evaluator evaluator(description.series.at(0).value, {description.x.column, description.y.column},
                            figure.tolerance);
  const auto value = [&](double x, double y) { return evaluator({x, y}); };
  Grid grid{lattice(description.x, figure.cells, 0.5, figure.cells),
            lattice(description.y, figure.cells, 0.5, figure.cells),
            {}};
  for (const double y : grid.y)
    for (const double x : grid.x) grid.value.push_back(value(x, y));
  panel.grid = std::move(grid);
  for (const auto& contour : description.contours)
    panel.contours.push_back(
        {contour.label, level_lines(value, contour.level, lattice(description.x, figure.cells, 0, figure.cells + 1),
                                    lattice(description.y, figure.cells, 0, figure.cells + 1))});
}

} // namespace

Figure compute(const FigureDescription& description) {
  Figure figure{description.id,
                description.title,
                description.caption,
                description.kind,
                description.columns,
                description.share,
                {}};
  Styles styles;
  for (const auto& from : description.panels) {
    Panel panel{from.title, from.x, from.y, {}, from.arrows, from.value, {}, {}};
    if (description.kind == Kind::heatmap) {
      naming(place(description, from, from.series.at(0)), [&] { fill_heatmap(description, from, panel); });
    } else {
      fill_curves(description, from, styles, panel);
    }
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

} // namespace brdfplot::plot
