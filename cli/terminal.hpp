/// \file
/// What people see while a command runs: errors, progress, and how wide their terminal is.
#pragma once

#include "command.hpp"

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace brdfplot::cli {

/// `brdfplot: error: MESSAGE` on stderr: one line, whatever the message holds. Takes no memory, of which there may be
/// none left.
void print_error(const Settings& settings, std::string_view message);

/// What has been kept of warnings (base/warnings.hpp), a line `brdfplot: warning: ...` each; nothing with --quiet.
void print_warnings(const Settings& settings);

/// Whether what is written to stdout may have colour: --color, NO_COLOR and whether it is a terminal decide.
bool colours_stdout(const Settings& settings);

/// Columns of the terminal that stdout is, within reason; 100 when it is none.
std::size_t output_width();

/// Tasks done of how many, their rate, the time left and what is being computed: on a terminal one line that changes,
/// elsewhere (`--progress always`) a line for every task. Safe to call from several threads.
class Progress {
public:
  explicit Progress(const Settings& settings, std::size_t total = 0, double work = 0);
  /// Clears the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A task begins and ends; the time left is that of the work that is left.
  void start(const std::string& name, double work);
  void finish(const std::string& name, double work);
  /// For work in many small pieces: so many of `total` are done. Elsewhere than on a terminal a line a percent.
  void set(std::size_t done, std::size_t total, const std::string& name);
  /// A line of its own, where progress is shown.
  void note(const std::string& text);

private:
  std::string line() const;
  void draw() const;

  std::mutex mutex_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::size_t total_ = 0;
  std::size_t done_ = 0;
  double all_work_ = 0, done_work_ = 0, running_work_ = 0;
  std::vector<std::string> running_;
  bool shown_ = false;
  bool terminal_ = false;
};

} // namespace brdfplot::cli
