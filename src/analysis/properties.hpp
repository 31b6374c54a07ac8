/// \file
/// The properties that Table 3 of Heitz 2014 lists, measured.
#pragma once

#include "analysis/integrals.hpp"

#include <string>
#include <vector>

namespace brdfplot {

/// Which combinations a table of properties covers, and where it looks for the largest residual.
struct PropertyTableDescription {
  std::string id;
  std::string title;
  std::string caption;
  std::vector<std::string> maskings;
  std::vector<std::string> distributions;
  std::vector<double> alpha;
  std::vector<double> theta_o; ///< rad
  double tolerance = 1e-6;     ///< a residual up to this counts as zero
};

enum class Verdict { holds, fails, unknown };

/// The largest |integral - what it should be| over the sampled configurations.
struct Residual {
  double max_residual = 0;
  double error = 0; ///< of the integral there
  double alpha = 0; ///< where
  double theta_o = 0;
  Verdict verdict = Verdict::unknown; ///< holds: residual + error <= tolerance; fails: residual - error > tolerance
};

struct PropertyRow {
  std::string distribution;
  std::string masking;
  Residual eq14; ///< |projected area / c_o - 1|
  Residual eq18; ///< |int D_o - 1|
  Residual eq36; ///< |weak white furnace - 1|
  bool physically_based() const {
    return eq14.verdict == Verdict::holds && eq18.verdict == Verdict::holds && eq36.verdict == Verdict::holds;
  }
};

PropertyRow measure_properties(const PropertyTableDescription& table, const std::string& distribution,
                               const std::string& masking);

/// All rows, masking functions outermost, as the paper orders them.
std::vector<PropertyRow> measure_properties(const PropertyTableDescription& table);

} // namespace brdfplot
