/// \file
/// An expression of a figure, ready to be evaluated.
#pragma once

#include "plot/simulated.hpp"
#include "plot/term.hpp"

#include <optional>
#include <vector>

namespace brdfplot::plot {

class Evaluator {
public:
  /// \throws InputError as TermFunction and SimulatedTerm do. Values: AccuracyError where one is not a number, or
  /// infinite by a division.
  Evaluator(const Expression& expression, const std::vector<std::string>& swept, double tolerance);

  /// The values of an expression without simulated terms, at all rows.
  std::vector<double> operator()(const SweptColumns& x) const;

  /// Where a curve over `variable` may have something narrow.
  std::vector<double> seeds(const std::string& variable) const;

  /// Whether there is an integral among the terms.
  bool costly() const;

  /// The simulated terms, of which there may be none.
  std::vector<const SimulatedTerm*> simulated() const;

  /// Values with their standard errors; operands count as independent of each other.
  std::vector<simulation::Measured> measure(const std::vector<double>& x, simulation::Store& store, int threads) const;

private:
  std::vector<double> combined(const SweptColumns& x) const;
  simulation::Measured combine(const simulation::Measured& a, const simulation::Measured& b) const;
  /// The last guard: throws where one of the values at `x` is no answer.
  void guard(const std::vector<double>& values, const SweptColumns& x) const;

  Expression::Operation operation_;
  std::vector<std::string> swept_;
  std::optional<TermFunction> term_;
  std::optional<SimulatedTerm> simulated_;
  std::vector<Evaluator> operands_;
};

} // namespace brdfplot::plot
