#include "config/load.hpp"
#include "config/shapes.hpp"

#include <cmath>

namespace brdfplot::config {

namespace {

std::string word(Verdict verdict) {
  switch (verdict) {
  case Verdict::holds: return "holds";
  case Verdict::fails: return "fails";
  case Verdict::unknown: return "unknown";
  case Verdict::not_applicable: break;
  }
  return "does not apply";
}

/// JSON has no NaN: null.
Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json residual_json(const Residual& residual) {
  Json out = {{"max_residual", finite_or_null(residual.max_residual)},
              {"holds", residual.verdict == Verdict::holds},
              {"verdict", word(residual.verdict)}};
  if (residual.verdict == Verdict::not_applicable) {
    out["max_residual"] = nullptr;
    out["reason"] = residual.reason;
    return out;
  }
  out["error"] = finite_or_null(residual.error);
  out["alpha"] = residual.alpha;
  out["theta_o"] = residual.theta_o;
  out["phi_o"] = residual.phi_o;
  return out;
}

} // namespace

Json property_row(const PropertyRow& row) {
  Json out = Json::object();
  if (!row.material.empty()) out["material"] = row.material;
  out["distribution"] = row.distribution;
  out["masking"] = row.masking;
  if (row.label != row.distribution) out["distribution_label"] = row.label;
  for (const auto& info : properties()) {
    const auto found = row.residuals.find(info.property);
    if (found != row.residuals.end()) out[info.name] = residual_json(found->second);
  }
  if (!row.mistake.empty()) out["mistake"] = row.mistake;
  out["physically_based"] = row.physically_based() == Verdict::holds;
  return out;
}

std::string check_record(const std::vector<CheckRecord>& checked, double tolerance) {
  Json rows = Json::array();
  for (const auto& record : checked) {
    Json row = property_row(record.row);
    if (!record.file.empty()) row["file"] = record.file;
    Json claims = Json::object();
    for (const auto& claim : record.claims) claims[claim] = word(record.row.verdict(claim));
    if (!claims.empty()) row["claims"] = std::move(claims);
    rows.push_back(std::move(row));
  }
  return Json{{"tolerance", tolerance}, {"rows", rows}}.dump(2) + "\n";
}

} // namespace brdfplot::config
