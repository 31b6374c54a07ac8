#include "table.hpp"

#include "cases.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

namespace brdfplot::bench {

void Fastest::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const double nanoseconds = run.cpu_accumulated_time / static_cast<double>(run.iterations) / count * 1e9;
    const auto [place, is_new] = fastest_.emplace(run.run_name.function_name, nanoseconds);
    if (!is_new) place->second = std::min(place->second, nanoseconds);
  }
}

double Fastest::nanoseconds(const std::string& label) const {
  const auto place = fastest_.find(label);
  return place == fastest_.end() ? std::numeric_limits<double>::infinity() : place->second;
}

bool write_table(const Fastest& fastest, const std::string& csv) {
  std::ofstream file;
  if (!csv.empty()) file.open(csv);
  file << "quantity,function,ns_per_value,ratio_to_kernel,target_ratio,max_error_ulp\n";
  std::printf("%-24s %-26s %8s %8s %8s %12s\n", "quantity", "function", "ns", "ratio", "target", "max ulp");
  std::string group;
  double kernel = 0;
  for (const Case& entry : cases()) {
    const double nanoseconds = fastest.nanoseconds(entry.label());
    if (nanoseconds == std::numeric_limits<double>::infinity()) continue;
    if (entry.group != group) {
      group = entry.group;
      kernel = nanoseconds;
    }
    const kernels::Isa before = kernels::active_isa();
    if (entry.isa) kernels::use_isa(*entry.isa);
    const double error = entry.error();
    kernels::use_isa(before);
    char line[200];
    std::snprintf(line, sizeof line, "%.3f,%.2f,%.0f,%.3g", nanoseconds, nanoseconds / kernel, entry.target, error);
    file << entry.group << ",\"" << entry.name << "\"," << line << '\n';
    std::printf("%-24s %-26s %8.2f %8.2f %8s %12.3g\n", entry.group.c_str(), entry.name.c_str(), nanoseconds,
                nanoseconds / kernel, entry.target > 0 ? std::to_string(static_cast<int>(entry.target)).c_str() : "",
                error);
  }
  file.flush();
  return csv.empty() || file.good();
}

} // namespace brdfplot::bench
