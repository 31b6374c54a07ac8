#include "config/records/stress_json.hpp"

#include "config/shapes.hpp"

#include <cmath>

namespace brdfplot::config {

namespace {

Json told_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json row_json(const std::vector<std::string>& names, const choice::Row& row) {
  Json out = Json::object();
  for (std::size_t k = 0; k < row.size(); ++k) out[names[k]] = row[k];
  return out;
}

Json finding_json(const choice::Finding& finding) {
  return {{"kind", std::string(finding.kind->name)},
          {"is", std::string(finding.kind->says)},
          {"worst", finding.worst},
          {"bound", "lower"}, // of a search
          {"worst_at", row_json(finding.inputs, finding.worst_at)},
          {"value", told_or_null(finding.value)},
          {"exact", finding.has_exact ? told_or_null(finding.exact) : Json()},
          {"simplest", row_json(finding.inputs, finding.simplest)},
          {"from", row_json(finding.inputs, finding.from)},
          {"to", row_json(finding.inputs, finding.to)},
          {"rows", finding.rows},
          {"mend", finding.mend}};
}

Json report_json(const choice::MethodReport& report) {
  Json findings = Json::array();
  for (const auto& finding : report.findings) findings.push_back(finding_json(finding));
  return {{"problem", report.problem},
          {"method", report.method},
          {"type", report.single ? "float" : "double"},
          {"rows", report.rows},
          {"largest_error",
           {{"error", report.error}, {"bound", "lower"}, {"at", row_json(report.inputs, report.error_at)}}},
          {"failures", findings}};
}

} // namespace

std::string stress_record(const std::vector<choice::MethodReport>& reports, const std::string& version) {
  Json methods = Json::array();
  for (const auto& report : reports) methods.push_back(report_json(report));
  return Json{{"brdfplot", version}, {"methods", methods}}.dump(2) + "\n";
}

} // namespace brdfplot::config
