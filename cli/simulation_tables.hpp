/// \file
/// Tables of a simulation as text.
#pragma once

#include "simulation/simulate.hpp"

#include <string>
#include <vector>

namespace brdfplot::cli {

/// The statistics of the surface, then what was measured.
std::vector<simulation::Table> all_tables(const simulation::SimulationResult& result);

/// One header line, LF, shortest numbers; an empty cell where there is no value.
std::string table_csv(const simulation::Table& table);

/// For reading: values with their standard errors, rounded to two digits of those; angles in degrees. `traced` below 1
/// is said above the table.
std::string table_markdown(const simulation::Table& table, double traced);

} // namespace brdfplot::cli
