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

constexpr double pi = std::numbers::pi;

/// Where a term over `variable` may have something narrow: the normal of the mesosurface, the direction that it mirrors
/// the other one to, the other direction itself.
std::vector<double> narrow_places(const std::string& variable, const Configuration& fixed) {
  const auto angle = [&](const char* name) { return fixed.angle(name).value_or(0); };
  const Vec2 mean = fixed.mean_slope();
  // The slope of the mean normal in the plane of azimuth phi.
  const auto slope = [&](double phi) { return -mean[0] * std::cos(phi) - mean[1] * std::sin(phi); };
  const auto around = [&](double phi) {
    return std::vector<double>{phi, phi - pi, phi + pi, phi - 2 * pi, phi + 2 * pi};
  };
  if (variable == "slope") return {slope(angle("phi_m"))};
  if (variable == "phi_i") return around(angle("phi_o"));
  if (variable == "phi_o") return around(angle("phi_i"));
  if (variable == "phi_m") {
    auto out = around(std::atan2(-mean[1], -mean[0]));
    for (const double phi : around(angle("phi_o"))) out.push_back(phi);
    return out;
  }
  if (!variable.starts_with("theta_")) return {};
  const double normal = std::atan(slope(angle(variable == "theta_i"   ? "phi_i"
                                              : variable == "theta_o" ? "phi_o"
                                                                      : "phi_m")));
  std::vector<double> out = {0, normal};
  const auto other = fixed.angle(variable == "theta_o" ? "theta_i" : "theta_o");
  if (!other) return out;
  for (const double theta : {*other, -*other}) {
    out.push_back(theta);
    if (variable != "theta_m") out.push_back(2 * normal + theta);
  }
  return out;
}

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

  /// Where a curve over `variable` may have something narrow.
  std::vector<double> seeds(const std::string& variable) const {
    std::vector<double> out;
    for (const auto& term : terms_) out = narrow_places(variable, term.fixed());
    for (const auto& operand : operands_) {
      const auto more = operand.seeds(variable);
      out.insert(out.end(), more.begin(), more.end());
    }
    return out;
  }

  bool costly() const {
    return (!terms_.empty() && terms_[0].is_integral()) ||
           std::ranges::any_of(operands_, [](const Evaluator& operand) { return operand.costly(); });
  }

private:
  Expression::Operation operation_;
  std::vector<TermFunction> terms_;
  std::vector<Evaluator> operands_;
};

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
std::string place(const FigureDescription& figure, const PanelDescription& panel, std::size_t series) {
  const auto call = [](const std::string& what, const std::string& name, std::ptrdiff_t index) {
    return ", " + what + " " + (name.empty() ? std::to_string(index + 1) : "\"" + one_line(name) + "\"");
  };
  return one_line(figure.id) + call("panel", panel.title, &panel - figure.panels.data()) +
         call("series", panel.series.at(series).label, static_cast<std::ptrdiff_t>(series));
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
      : evaluator_(series.value, {panel.x.column}, figure.tolerance) {
    request_.x = panel.x;
    request_.y = panel.y;
    request_.polar = figure.kind == Kind::polar;
    request_.adaptive = panel.samples == 0;
    if (evaluator_.costly()) request_.noise = figure.tolerance;
    if (panel.samples > 0)
      request_.initial = panel.samples;
    else if (evaluator_.costly())
      request_.initial = 33;
    else
      request_.seeds = evaluator_.seeds(panel.x.column);
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
  for (std::size_t k = 0; k < description.series.size(); ++k)
    naming(place(figure, description, k), [&] {
      sources.emplace_back(figure, description, description.series[k]);
      sources.back().widen(low, high);
    });
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const auto& series = description.series[k];
    Curve points = naming(place(figure, description, k), [&] { return sources[k].draw(low, high); });
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
      naming(place(description, from, 0), [&] { fill_heatmap(description, from, panel); });
    } else {
      fill_curves(description, from, styles, panel);
    }
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

} // namespace brdfplot::plot
