#include "analysis/properties.hpp"

#include <cmath>

namespace brdfplot {

namespace {

/// Takes the residual of one configuration into the largest so far.
void take(Residual& residual, const Estimate& estimate, double scale, double alpha, double theta_o) {
  const double distance = std::fabs(estimate.value / scale - 1);
  if (distance < residual.max_residual) return;
  residual.max_residual = distance;
  residual.error = estimate.error / scale;
  residual.alpha = alpha;
  residual.theta_o = theta_o;
}

void judge(Residual& residual, double tolerance) {
  if (residual.max_residual + residual.error <= tolerance)
    residual.verdict = Verdict::holds;
  else if (residual.max_residual - residual.error > tolerance)
    residual.verdict = Verdict::fails;
}

} // namespace

PropertyRow measure_properties(const PropertyTableDescription& table, const std::string& distribution,
                               const std::string& masking) {
  PropertyRow row{distribution, masking, {}, {}, {}};
  const double asked = 0.01 * table.tolerance;
  for (const double alpha : table.alpha) {
    MaterialDescription description;
    description.name = distribution + " with " + masking;
    description.distribution.type = distribution;
    description.distribution.values.set("alpha", alpha);
    description.masking.type = masking;
    const Material material = build(description);
    for (const double theta : table.theta_o) {
      const Direction o = from_angles(theta, 0);
      const double c = material.slopes().project(o).c;
      take(row.eq14, compute(Integral::projected_area, material, o, asked), c, alpha, theta);
      take(row.eq18, compute(Integral::visible_norm, material, o, asked), 1, alpha, theta);
      take(row.eq36, compute(Integral::weak_furnace, material, o, asked), 1, alpha, theta);
    }
  }
  for (Residual* residual : {&row.eq14, &row.eq18, &row.eq36}) judge(*residual, table.tolerance);
  return row;
}

std::vector<PropertyRow> measure_properties(const PropertyTableDescription& table) {
  std::vector<PropertyRow> rows;
  for (const auto& masking : table.maskings)
    for (const auto& distribution : table.distributions)
      rows.push_back(measure_properties(table, distribution, masking));
  return rows;
}

} // namespace brdfplot
