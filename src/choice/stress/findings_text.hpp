/// \file
/// What a search for failures found, as text.
#pragma once

#include "choice/stress/stress.hpp"

namespace brdfplot::choice {

/// "a = 4, b = 0.5": a row; `single`: of floats, which have fewer digits.
std::string row_text(const std::vector<std::string>& names, const Row& row, bool single);

/// "a 3.1 .. 1e8": where the rows of the sweep lie that fail.
std::string region_text(const Finding& finding);

/// A block for each method that fails: its kinds of failure, how bad, where, and what mends it.
std::string findings_table(const std::vector<MethodReport>& reports);

/// A row for each failure: problem, method, kind, worst, worst_at, value, exact, simplest, rows, mend.
std::string findings_csv(const std::vector<MethodReport>& reports);

/// The same as a table for a page, with figures of three digits.
std::string findings_markdown(const std::vector<MethodReport>& reports);

} // namespace brdfplot::choice
