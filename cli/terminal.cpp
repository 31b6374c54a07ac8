#include "terminal.hpp"

#include "base/warnings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace brdfplot::cli {

namespace {

constexpr std::string_view clear_line = "\r\x1b[K";

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool coloured(const Settings& settings, int fd) {
  if (settings.color != "auto") return settings.color == "always";
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return isatty(fd) == 1 && !is_set("NO_COLOR") && !dumb;
}

/// There is nowhere left to tell that stderr cannot be written.
void write_to_stderr(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
    if (count <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::size_t columns_of(int fd, std::size_t otherwise) {
  winsize size{};
  return ioctl(fd, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : otherwise;
}

} // namespace

void print_error(const Settings& settings, std::string_view message) {
  // Longer than any message: values and paths are cut where they are put in.
  std::array<char, 16384> line{};
  const std::string_view start =
      coloured(settings, STDERR_FILENO) ? "brdfplot: \x1b[1;31merror:\x1b[0m " : "brdfplot: error: ";
  auto end = std::ranges::copy(start, line.begin()).out;
  for (const char c : message.substr(0, line.size() - start.size() - 1)) *end++ = c == '\n' || c == '\r' ? ' ' : c;
  *end++ = '\n';
  write_to_stderr({line.begin(), end});
}

void print_warnings(const Settings& settings) {
  for (std::string text : take_warnings()) {
    if (settings.quiet) continue;
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    write_to_stderr(
        (coloured(settings, STDERR_FILENO) ? "brdfplot: \x1b[1;33mwarning:\x1b[0m " : "brdfplot: warning: ") + text +
        "\n");
  }
}

bool colours_stdout(const Settings& settings) { return coloured(settings, STDOUT_FILENO); }

std::size_t output_width() { return std::clamp<std::size_t>(columns_of(STDOUT_FILENO, 100), 40, 120); }

Progress::Progress(const Settings& settings, std::size_t total, double work)
    : total_(total), all_work_(work), terminal_(isatty(STDERR_FILENO) == 1) {
  shown_ = settings.progress == "always" || (settings.progress == "auto" && terminal_ && !settings.quiet);
}

Progress::~Progress() {
  if (shown_ && terminal_) write_to_stderr(clear_line);
}

void Progress::start(const std::string& name, double work) {
  const std::lock_guard lock(mutex_);
  running_work_ += work;
  running_.push_back(name);
  if (shown_ && terminal_) draw();
}

void Progress::finish(const std::string& name, double work) {
  const std::lock_guard lock(mutex_);
  running_work_ -= work;
  done_work_ += work;
  running_.erase(std::ranges::find(running_, name));
  ++done_;
  if (shown_) draw();
}

void Progress::set(std::size_t done, std::size_t total, const std::string& name) {
  const std::lock_guard lock(mutex_);
  const bool next_percent = total_ != total || 100 * done / total > 100 * done_ / total;
  total_ = total;
  done_ = done;
  all_work_ = static_cast<double>(total);
  done_work_ = static_cast<double>(done);
  running_ = {name};
  if (shown_ && next_percent) draw();
}

void Progress::note(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (shown_) write_to_stderr((terminal_ ? std::string(clear_line) : "") + text + "\n");
}

std::string Progress::line() const {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  std::ostringstream out;
  out << std::fixed << std::setprecision(1) << done_ << '/' << total_;
  if (done_ > 0) {
    out << ", " << static_cast<double>(done_) / seconds << "/s";
    // What is running is half done, on average.
    const double done = done_work_ + running_work_ / 2;
    if (done > 0) out << ", " << seconds * (all_work_ - done) / done << " s left";
  }
  if (!running_.empty()) out << ": " << running_.back();
  return out.str();
}

void Progress::draw() const {
  if (!terminal_) return write_to_stderr(line() + "\n");
  // A line that wraps could not be cleared.
  write_to_stderr(std::string(clear_line) + line().substr(0, columns_of(STDERR_FILENO, 80) - 1));
}

} // namespace brdfplot::cli
