/// \file
/// The ranks that mpirun has started.
#pragma once

#include "base/threads/ranks.hpp"

namespace brdfplot::cli {

/// This process as one of the ranks of the run. \throws InputError when there are others, and MPI is not built in
std::unique_ptr<Ranks> start_ranks();

} // namespace brdfplot::cli
