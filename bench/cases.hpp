/// \file
/// What is measured: groups of functions that compute the same, the kernel first.
#pragma once

#include "inputs.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::bench {

struct Case {
  std::string group; ///< what is computed, and the type
  std::string name;
  std::optional<kernels::Isa> isa; ///< of a kernel
  std::function<void()> run;       ///< over all inputs
  std::function<double()> error;   ///< largest error in ulp on a sample of the inputs
  /// The ratio to the group's kernel that is aimed at; 0: none.
  double target = 0;

  std::string label() const { return group + "/" + name; }
};

const std::vector<Case>& cases();

} // namespace brdfplot::bench
