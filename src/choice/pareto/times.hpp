/// \file
/// What methods cost on this machine, now.
#pragma once

#include "choice/methods/method.hpp"

#include <functional>
#include <string>
#include <vector>

namespace brdfplot::choice {

/// Nanoseconds of processor time for one value.
struct Time {
  double least = 0; ///< what repeats best: everything else that runs only adds to it
  double lower_quartile = 0, median = 0, upper_quartile = 0;
};

/// Of every method of a problem, at random inputs from where they mostly are, in blocks that stay in the nearest
/// caches. All methods are run in turn, in an order that is drawn anew in every round, on this thread alone, which
/// is kept on one processor meanwhile. `rest` is called between rounds, with the share that is done.
std::vector<Time> times_of(const Problem& problem, const std::function<void(double)>& rest);

/// What times belong to: "AMD EPYC, GCC 12.2, 2026-11-27".
struct MachineRecord {
  std::string processor; ///< of /proc/cpuinfo; "unknown processor" where it is not told
  std::string compiler;
  std::string date; ///< of the day, UTC

  std::string text() const { return processor + ", " + compiler + ", " + date; }
};

MachineRecord machine_record();

} // namespace brdfplot::choice
