/// \file
/// An expression of a figure, ready to be evaluated.
#pragma once

#include "figure/series/simulated.hpp"
#include "figure/series/term.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::plot {

/// The values of terms where they are first asked for. Series share terms, such as what all are compared with, and the
/// points with which their sampling begins; and these are asked for twice.
class FirstValues {
public:
  /// The values of `term` at `x`, which belongs to the text that defines it.
  std::vector<double> of(const std::string& text, const TermFunction& term, const SweptColumns& x);

private:
  struct Known {
    SweptColumns x;
    std::vector<double> values;
  };
  std::map<std::string, Known> known_;
};

class Evaluator {
public:
  /// What `first` remembers of other expressions with the same tolerance is not computed again; it may be null.
  /// \throws InputError as TermFunction and SimulatedTerm do. Values: AccuracyError where one is not a number, or
  /// infinite by a division.
  Evaluator(const Expression& expression, const std::vector<std::string>& swept, double tolerance,
            FirstValues* first = nullptr);

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
  std::string text_; ///< that defines the term
  FirstValues* first_ = nullptr;
};

} // namespace brdfplot::plot
