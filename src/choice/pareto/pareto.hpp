/// \file
/// The methods of a problem, with what they cost, how far they are off, and which of them nothing is better than.
#pragma once

#include "choice/pareto/errors.hpp"
#include "choice/pareto/front.hpp"
#include "choice/pareto/times.hpp"

namespace brdfplot::choice {

/// Cost as counted or as measured, error of the value or of what is seen of it.
enum class CostKind { counted, measured };
enum class ErrorKind { relative, absolute };

/// The estimated cost in multiply-adds of floats: cost() of the operations, twice that in double, of which a vector
/// register holds half as many. Of a problem with a unit of its own, the evaluations. Nothing where they are not
/// counted.
std::optional<double> estimated_cost(const Problem& problem, const Method& method);

/// What is not told apart: times within 10 %, since the least of some repeats within 0.3 to 8 %; and errors within 25
/// %, since the largest of roundings is chance.
inline constexpr Slack counted_slack{.cost = 1, .error = 1.25}, measured_slack{.cost = 1.1, .error = 1.25};

struct MethodResult {
  Method method;
  std::optional<double> cost; ///< estimated
  Errors errors;
  std::optional<Time> time;
};

struct ProblemResult {
  Problem problem;                   ///< its methods are moved to `methods`
  std::size_t samples = 0;           ///< how many inputs its errors were looked for at
  std::vector<MethodResult> methods; ///< in the order of the problem
  std::size_t reference = 0;         ///< the method that ratios of times refer to: the first kernel, or the first

  /// The front of these; methods that are not portable are on that of measured costs only.
  const Dominated& front(CostKind cost, ErrorKind error) const {
    return fronts.at(2 * static_cast<std::size_t>(cost) + static_cast<std::size_t>(error));
  }
  bool has_costs() const;                                    ///< whether any is counted
  double cost_of(std::size_t method, CostKind kind) const;   ///< NaN where it is not known
  double error_of(std::size_t method, ErrorKind kind) const; ///< >= 0

  std::vector<Dominated> fronts{};
};

/// What is shown while it works: the share that is done and of what.
using Report = std::function<void(double share, const std::string& what)>;

struct ParetoOptions {
  int threads = 1;
  bool times = true; ///< measured on this thread while nothing else runs
};

/// Errors are the same for any number of threads.
std::vector<ProblemResult> pareto(std::vector<Problem> problems, const ParetoOptions& options, const Report& report);

} // namespace brdfplot::choice
