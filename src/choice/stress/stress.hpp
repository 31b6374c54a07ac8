/// \file
/// Where the methods of a problem fail: a sweep over the whole domain, a search that climbs from the worst rows, and
/// for each kind of failure the worst and the simplest input that show it.
#pragma once

#include "choice/stress/failure_kinds.hpp"

namespace brdfplot::choice {

/// A kind of failure that a method shows.
struct Finding {
  std::string problem;
  std::string method;
  const FailureKind* kind = nullptr;
  std::vector<std::string> inputs{}; ///< names
  double worst = 0;                  ///< a lower bound: the worst that the search found
  Row worst_at{};
  double value = 0, exact = 0; ///< there
  bool has_exact = true;       ///< false of a property that needs no exact value
  Row simplest{};              ///< the simplest input that shows it
  Row from{}, to{};            ///< for each input, the range of the rows of the sweep that show it
  std::size_t rows = 0;        ///< of the sweep that show it
  std::string mend{};          ///< what mends it
  bool single = false;         ///< the inputs are floats
};

/// What a method does over the whole domain.
struct MethodReport {
  std::string problem;
  std::string method;
  std::vector<std::string> inputs{}; ///< names
  std::size_t rows = 0;              ///< of the sweep
  double error = 0;                  ///< the largest relative error of what is seen that was found: a lower bound
  Row error_at{};
  bool single = false;
  std::vector<Finding> findings{};
};

/// Every method of the problem that every machine has; `only`: the method of this name, whatever it is. What mends a
/// failure is named from all of them.
std::vector<MethodReport> stress(const Problem& problem, const std::string& only = "");

} // namespace brdfplot::choice
