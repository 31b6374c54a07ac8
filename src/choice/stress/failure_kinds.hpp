/// \file
/// What can be wrong with a value: a list.
#pragma once

#include "choice/stress/subject.hpp"

#include <string_view>

namespace brdfplot::choice {

/// A kind of failure: a row shows it where how_bad(trial) > limit(method).
struct FailureKind {
  std::string_view name; ///< in files and flags: "digits_lost"
  std::string_view says; ///< what a number of it is
  std::string_view mend; ///< what helps in general
  double (*how_bad)(const Subject&, const Trial&);
  double (*limit)(const Subject&);

  bool shown_by(const Subject& subject, const Trial& trial) const { return how_bad(subject, trial) > limit(subject); }
};

/// The relative error of what is seen above which digits count as lost: that a method keeps half of the digits of its
/// type is asked of every formula, 2^-26 (1.5e-8) in double, 2^-12 (2.4e-4) in float; of what stands for another
/// function (an approximation, a fit, a table) the error that it states, and where it states none, 10 %.
double digits_limit(const Subject& subject);

const std::vector<FailureKind>& failure_kinds();

/// The names of the list.
std::vector<std::string> failure_names();

} // namespace brdfplot::choice
