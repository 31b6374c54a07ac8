/// \file
/// The table of ratios and errors.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace brdfplot::bench {

/// Keeps the fastest repetition of each benchmark, in nanoseconds of processor time per value.
class Fastest : public benchmark::BenchmarkReporter {
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;
  /// Infinity for a benchmark that did not run.
  double nanoseconds(const std::string& label) const;

private:
  std::map<std::string, double> fastest_;
};

/// Prints the table, and writes it to `csv` unless that is empty; false when that fails.
bool write_table(const Fastest& fastest, const std::string& csv);

} // namespace brdfplot::bench
