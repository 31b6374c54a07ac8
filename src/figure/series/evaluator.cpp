#include "figure/series/evaluator.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::plot {

namespace {

using simulation::Measured;

using std::numbers::pi;

/// Where a term over `variable` may have something narrow about a mean slope: the normal there, the direction that it
/// mirrors the other one to, the other direction itself.
std::vector<double> narrow_places(const std::string& variable, const Configuration& fixed, const Vec2& mean) {
  const auto angle = [&](const char* name) { return fixed.angle(name).value_or(0); };
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
  if (!variable.starts_with("theta_") || variable == "theta_d") return {};
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

} // namespace

std::vector<double> FirstValues::of(const std::string& text, const TermFunction& term, const SweptColumns& x) {
  const auto known = known_.find(text);
  if (known == known_.end()) return known_.emplace(text, Known{x, term(x)}).first->second.values;
  return known->second.x == x ? known->second.values : term(x);
}

Evaluator::Evaluator(const Expression& expression, const std::vector<std::string>& swept, double tolerance,
                     FirstValues* first)
    : operation_(expression.operation), swept_(swept), first_(first) {
  if (operation_ == Expression::Operation::term && expression.term.simulate)
    simulated_.emplace(expression.term, swept);
  else if (operation_ == Expression::Operation::term)
    term_.emplace(expression.term, swept, tolerance);
  if (term_ && first_) text_ = defining_text(expression.term, swept);
  for (const auto& operand : expression.operands) operands_.emplace_back(operand, swept, tolerance, first);
}

std::vector<double> Evaluator::operator()(const SweptColumns& x) const {
  std::vector<double> values = combined(x);
  guard(values, x);
  return values;
}

void Evaluator::guard(const std::vector<double>& values, const SweptColumns& x) const {
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double value = values[row];
    // Lambda is infinite at the horizon, and so is what is made of it; a quotient is by 0.
    if (std::isfinite(value) || (std::isinf(value) && operation_ != Expression::Operation::ratio)) continue;
    std::string place;
    for (std::size_t k = 0; k < std::min(x.size(), swept_.size()); ++k)
      place += (k == 0 ? " at " : ", ") + swept_[k] + " = " + format_number(x[k][row]);
    throw AccuracyError("", "found " + format_number(value) + place + "; accepted: a finite number");
  }
}

std::vector<double> Evaluator::combined(const SweptColumns& x) const {
  if (term_) return first_ ? first_->of(text_, *term_, x) : (*term_)(x);
  std::vector<double> values = operands_[0](x);
  if (operation_ == Expression::Operation::absolute) {
    for (double& value : values) value = std::fabs(value);
    return values;
  }
  const std::vector<double> others = operands_[1](x);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (operation_ == Expression::Operation::difference)
      values[k] -= others[k];
    else
      values[k] /= others[k];
  }
  return values;
}

std::vector<double> Evaluator::seeds(const std::string& variable) const {
  std::vector<double> out;
  const std::vector<Vec2> means = term_ ? term_->fixed().mean_slopes() : std::vector<Vec2>{};
  for (const Vec2& mean : means) {
    const auto places = narrow_places(variable, term_->fixed(), mean);
    out.insert(out.end(), places.begin(), places.end());
  }
  for (const auto& operand : operands_) {
    const auto more = operand.seeds(variable);
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

bool Evaluator::costly() const {
  return (term_ && term_->is_integral()) ||
         std::ranges::any_of(operands_, [](const Evaluator& operand) { return operand.costly(); });
}

std::vector<const SimulatedTerm*> Evaluator::simulated() const {
  std::vector<const SimulatedTerm*> out;
  if (simulated_) out.push_back(&*simulated_);
  for (const auto& operand : operands_) {
    const auto more = operand.simulated();
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

std::vector<Measured> Evaluator::measure(const std::vector<double>& x, simulation::Store& store, int threads) const {
  std::vector<Measured> out(x.size());
  if (simulated_) {
    out = simulated_->measure(x, store, threads);
  } else if (term_) {
    const std::vector<double> values = (*term_)({x});
    for (std::size_t k = 0; k < x.size(); ++k) out[k] = {values[k], 0};
    return out;
  } else {
    const auto a = operands_[0].measure(x, store, threads);
    const auto b = operands_.size() > 1 ? operands_[1].measure(x, store, threads) : a;
    for (std::size_t k = 0; k < x.size(); ++k) out[k] = combine(a[k], b[k]);
  }
  std::vector<double> values;
  for (const Measured& measured : out) values.push_back(measured.value);
  guard(values, {x});
  return out;
}

Measured Evaluator::combine(const Measured& a, const Measured& b) const {
  switch (operation_) {
  case Expression::Operation::difference: return {a.value - b.value, std::hypot(a.standard_error, b.standard_error)};
  case Expression::Operation::ratio: {
    const double ratio = a.value / b.value;
    return {ratio, std::hypot(a.standard_error, ratio * b.standard_error) / std::fabs(b.value)};
  }
  case Expression::Operation::absolute: return {std::fabs(a.value), a.standard_error};
  case Expression::Operation::term: break;
  }
  return a;
}

} // namespace brdfplot::plot
