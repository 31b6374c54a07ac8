/// \file
/// brdfplot check --sampling: whether a sampler draws what its density says.
#pragma once

#include "command.hpp"

#include <string>
#include <vector>

namespace brdfplot::cli {

struct SamplingCheckFlags {
  bool asked = false; ///< --sampling
  std::string strategy, samples, seed;
  std::string density; ///< a formula to test instead of the strategy's own; empty: that
};

/// Tests every material from several viewers and writes a row for each, as a table or as CSV. Returns the exit code: 1
/// where something fails. \throws InputError, AccuracyError
int check_samplers(const std::vector<std::string>& files, const SamplingCheckFlags& flags, bool csv,
                   const std::string& output, const Settings& settings);

} // namespace brdfplot::cli
