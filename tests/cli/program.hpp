/// \file
/// Runs the real brdfplot, by the shell, in a folder of its own.
#pragma once

#include "../sample.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace test {

namespace fs = std::filesystem;

// Sanitizers make everything slower.
#if defined(BRDFPLOT_SANITIZED)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

inline std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A scratch folder with `configs`, the ones of the source tree. Removed at the end.
class Folder {
public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "brdfplot-test-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
    fs::create_directory_symlink(fs::path(BRDFPLOT_SOURCE_DIR) / "configs", path_ / "configs");
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) const { return read_file(path_ / name); }
  bool has(const std::string& name) const { return fs::exists(path_ / name); }
  /// What is there, sorted; neither `configs` nor what belongs to Process.
  std::vector<std::string> list(const std::string& below = ".") const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_ / below))
      if (const auto name = entry.path().filename().string(); name != "configs" && name != ".out" && name != ".err")
        names.push_back(name);
    std::ranges::sort(names);
    return names;
  }

private:
  fs::path path_;
};

struct Outcome {
  int code = -1; ///< of the exit; 128 + n: ended by signal n
  std::string out;
  std::string err;
  long kilobytes = 0; ///< largest resident set
};

/// A command that runs by itself; stdin stays open until the end, and gives nothing.
class Process {
public:
  Process(const Folder& folder, const std::string& command) : folder_(folder) {
    REQUIRE(pipe2(stdin_.data(), O_CLOEXEC) == 0);
    pid_ = fork();
    REQUIRE(pid_ >= 0);
    if (pid_ == 0) become(command);
  }
  ~Process() {
    for (const int fd : stdin_) close(fd);
    for (const char* name : {".out", ".err"}) fs::remove(folder_.path() / name);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int number) const { kill(pid_, number); }
  void type(const std::string& text) const {
    REQUIRE(::write(stdin_[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  }
  Outcome wait() {
    int status = 0;
    rusage usage{};
    REQUIRE(wait4(pid_, &status, 0, &usage) == pid_);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), folder_.read(".out"),
            folder_.read(".err"), usage.ru_maxrss};
  }

private:
  [[noreturn]] void become(const std::string& command) const {
    const std::string binaries = fs::path(BRDFPLOT_BINARY).parent_path().string();
    setenv("PATH", (binaries + ":" + std::getenv("PATH")).c_str(), 1);
    unsetenv("NO_COLOR");
    const auto redirect = [](const char* name, int to) { dup2(open(name, O_CREAT | O_TRUNC | O_WRONLY, 0600), to); };
    if (chdir(folder_.path().c_str()) != 0) _exit(99);
    dup2(stdin_[0], STDIN_FILENO);
    redirect(".out", STDOUT_FILENO);
    redirect(".err", STDERR_FILENO);
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(99);
  }

  const Folder& folder_;
  std::array<int, 2> stdin_{};
  pid_t pid_ = -1;
};

/// Runs a shell command to its end. Without `<` or a pipe stdin never ends.
inline Outcome run(const Folder& folder, const std::string& command) { return Process(folder, command).wait(); }

/// Waits until `condition` holds; fails after 20 s.
template <class Condition>
void wait_for(const Condition& condition) {
  for (int k = 0; k < 2000; ++k) {
    if (condition()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  FAIL("waited in vain");
}

/// The command ends with `code`, prints nothing on stdout and exactly one line on stderr, with each of `parts` in it.
inline void check_error(const Folder& folder, const std::string& command, int code,
                        const std::vector<std::string>& parts) {
  INFO(command);
  const Outcome outcome = run(folder, command);
  INFO(outcome.err);
  CHECK(outcome.code == code);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.starts_with("brdfplot: error: "));
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK(outcome.err.ends_with('\n'));
  for (const auto& part : parts) {
    INFO("looked for: " << part);
    CHECK(outcome.err.find(part) != std::string::npos);
  }
}

/// The command succeeds and says nothing on stderr. What it prints.
inline std::string check_output(const Folder& folder, const std::string& command) {
  INFO(command);
  const Outcome outcome = run(folder, command);
  CHECK(outcome.code == 0);
  CHECK(outcome.err == "");
  return outcome.out;
}

/// CSV without quotes as cells.
inline std::vector<std::vector<std::string>> cells(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
  }
  return rows;
}

/// Number in a row (0: the first below the header) and column of a CSV.
inline double number(const std::string& csv, std::size_t row, std::size_t column) {
  return std::stod(cells(csv).at(row + 1).at(column));
}

} // namespace test
