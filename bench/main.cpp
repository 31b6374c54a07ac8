/// \file
/// Nanoseconds per value of every kernel and of a plain implementation of the same formula, and the errors of both.
///
///   brdfplot-bench [Google Benchmark's flags]     the plain listing
///   brdfplot-bench --table[=FILE.csv]             a table of ratios and errors, also as CSV
#include "cases.hpp"
#include "table.hpp"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace {

using namespace brdfplot;

void add(const bench::Case& entry) {
  benchmark::RegisterBenchmark(entry.label().c_str(), [&entry](benchmark::State& state) {
    const kernels::Isa before = kernels::active_isa();
    if (entry.isa) kernels::use_isa(*entry.isa);
    for (auto _ : state) {
      entry.run();
      benchmark::ClobberMemory();
    }
    kernels::use_isa(before);
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * static_cast<int64_t>(bench::count)));
  })->Unit(benchmark::kMillisecond);
}

} // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments;
  bool table = false;
  std::string csv;
  for (int k = 0; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument.starts_with("--table")) {
      table = true;
      if (argument.size() > 8) csv = argument.substr(8);
    } else {
      arguments.push_back(argument);
    }
  }
  // Alternating repetitions, of which the fastest counts: other processes disturb all rows alike.
  if (table)
    arguments.insert(arguments.begin() + 1, {"--benchmark_repetitions=12", "--benchmark_min_time=0.02",
                                             "--benchmark_enable_random_interleaving=true"});
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
  for (const bench::Case& entry : bench::cases()) add(entry);
  if (!table) {
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  }
  bench::Fastest fastest;
  benchmark::RunSpecifiedBenchmarks(&fastest);
  return bench::write_table(fastest, csv) ? 0 : 3;
}
