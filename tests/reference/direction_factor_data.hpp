/// \file
/// What simulate_direction_factor measured, and the errors of a factor lambda over it.
#pragma once

#include "brdf/evaluate.hpp"
#include "microfacet/direction_factor.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace brdfplot::direction_factor_data {

struct Row {
  std::string set;
  double alpha, theta_o, theta_i, phi, g1_o, g1_i, g2, g2_error, lambda, lambda_error;

  Projection side(double theta) const { return {std::cos(theta), alpha * std::sin(theta)}; }
  DirectionPair pair() const { return {phi, side(theta_o), side(theta_i)}; }
};

inline std::vector<Row> read(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    for (char& c : line)
      if (c == ',') c = ' ';
    std::istringstream words(line);
    Row row;
    if (!(words >> row.set >> row.alpha >> row.theta_o >> row.theta_i >> row.phi >> row.g1_o >> row.g1_i >> row.g2 >>
          row.g2_error >> row.lambda >> row.lambda_error))
      throw std::runtime_error(path + ": a line that is none: " + line);
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error(path + ": no rows");
  return rows;
}

template <class Keep>
std::vector<Row> kept(const std::vector<Row>& rows, const Keep& keep) {
  std::vector<Row> some;
  for (const Row& row : rows)
    if (keep(row)) some.push_back(row);
  return some;
}

inline std::vector<Row> of_set(const std::vector<Row>& rows, const std::string& set) {
  return kept(rows, [&](const Row& row) { return row.set == set; });
}

/// Where one side is all but unmasked, lambda says little of G2, and is noise: chosen by the standard error, not by
/// what is found.
inline std::vector<Row> of_small_error(const std::vector<Row>& rows) {
  return kept(rows, [](const Row& row) { return row.lambda_error < 0.03; });
}

template <class Of>
double rms(const std::vector<Row>& rows, const Of& of) {
  double sum = 0;
  for (const Row& row : rows) sum += std::pow(of(row), 2);
  return std::sqrt(sum / static_cast<double>(rows.size()));
}

using Factor = std::function<double(const Row&)>;

inline Factor published(DirectionFactor which) {
  return [which](const Row& row) { return direction_correlation(which, row.pair()).lambda; };
}

/// Over the rows with a small error.
inline double rms_lambda(const std::vector<Row>& rows, const Factor& factor) {
  return rms(of_small_error(rows), [&](const Row& row) { return factor(row) - row.lambda; });
}

/// Where Lambda of Eq. 101 comes from: the G1 of the same facets, so that the error is that of lambda alone, or Smith.
enum class Lambda { measured, smith };

inline double smith(double alpha, double theta) {
  TermDescription description;
  description.distribution.type = "beckmann";
  description.distribution.values.set("alpha", alpha);
  return evaluate(build(description), Quantity::lambda, from_angles(theta, 0), std::nullopt, std::nullopt);
}

/// Over all rows.
inline double rms_g2(const std::vector<Row>& rows, const Factor& factor, Lambda from) {
  return rms(rows, [&](const Row& row) {
    const bool measured = from == Lambda::measured;
    const double o = measured ? 1 / row.g1_o - 1 : smith(row.alpha, row.theta_o);
    const double i = measured ? 1 / row.g1_i - 1 : smith(row.alpha, row.theta_i);
    return 1 / (1 + std::max(o, i) + factor(row) * std::min(o, i)) - row.g2;
  });
}

} // namespace brdfplot::direction_factor_data
