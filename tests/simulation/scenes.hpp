/// \file
/// Short ways to describe a scene.
#pragma once

#include "simulation/measures/tally.hpp"
#include "simulation/simulate.hpp"
#include "simulation/surface.hpp"

#include "materials.hpp"

#include <string>
#include <vector>

namespace test {

using namespace brdfplot::simulation;

inline ModelChoice surface(const std::string& type, double alpha) {
  ModelChoice choice{.type = type, .values = {}};
  choice.values.set("alpha", alpha);
  return choice;
}

inline ModelChoice mesh(const std::string& type, double alpha, double samples, double correlation_length) {
  ModelChoice choice = surface(type, alpha);
  choice.values.set("samples", samples);
  choice.values.set("correlation_length", correlation_length);
  return choice;
}

inline MeasureDescription measure(const std::string& type, const std::vector<double>& degrees, double rays) {
  MeasureDescription description;
  description.id = description.type = type;
  description.theta_o.clear();
  for (const double theta : degrees) description.theta_o.push_back(theta * degree);
  description.rays = rays;
  return description;
}

inline SceneDescription scene(const ModelChoice& surface, const MeasureDescription& measure) {
  SceneDescription description;
  description.name = "test";
  description.surface = surface;
  description.measures = {measure};
  return description;
}

inline SimulationResult run(const SceneDescription& description, int threads = 2) {
  SimulationOptions options;
  options.threads = threads;
  return simulate(description, options);
}

inline double at(const Table& table, std::size_t row, const std::string& column) {
  return table.rows.at(row).at(table.column(column));
}

} // namespace test
