#include "picture.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace brdfplot::cli {

namespace {

/// A file without a name.
class Scratch {
public:
  explicit Scratch(const std::string& path) : file_(std::tmpfile()) {
    if (!file_) throw FileError(path, std::string("no temporary file: ") + std::strerror(errno));
  }
  FILE* get() const { return file_.get(); }
  int descriptor() const { return fileno(file_.get()); }
  std::string text() const {
    std::string out;
    std::array<char, 1 << 16> buffer;
    std::rewind(get());
    while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), get())) out.append(buffer.data(), got);
    return out;
  }

private:
  struct Close {
    void operator()(FILE* file) const { (void)std::fclose(file); }
  };
  std::unique_ptr<FILE, Close> file_;
};

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Runs a program with files as its standard streams. \throws FileError
void run_program(std::vector<std::string> words, const Scratch& in, const Scratch& out, const std::string& path) {
  const Scratch said(path);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, said.descriptor(), STDERR_FILENO);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) throw FileError(path, words[0] + " was not found; PNG and PDF need it (Debian: librsvg2-bin)");
  if (failure != 0) throw FileError(path, words[0] + ": " + std::strerror(failure));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw FileError(path, words[0] + " failed: " + first_line(said.text()));
}

} // namespace

std::optional<PictureFormat> format_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".pdf") return PictureFormat::pdf;
  if (ending == ".csv") return PictureFormat::csv;
  return std::nullopt;
}

std::string converted(const std::string& svg, PictureFormat format, double width_mm, const std::string& path) {
  const Scratch in(path), out(path);
  if (std::fwrite(svg.data(), 1, svg.size(), in.get()) != svg.size() || std::fflush(in.get()) != 0)
    throw FileError(path, std::string("the temporary drawing could not be written: ") + std::strerror(errno));
  std::rewind(in.get());
  std::vector<std::string> words = {"rsvg-convert", "--format", format == PictureFormat::pdf ? "pdf" : "png"};
  if (format == PictureFormat::png && width_mm == 0) words.insert(words.end(), {"--zoom", "2"});
  if (width_mm > 0) {
    // Print has 300 pixels an inch; a PDF has none.
    words.insert(words.end(), {"--width", format_number(width_mm) + "mm", "--keep-aspect-ratio"});
    if (format == PictureFormat::png) words.insert(words.end(), {"--dpi-x", "300", "--dpi-y", "300"});
  }
  run_program(words, in, out, path);
  return out.text();
}

} // namespace brdfplot::cli
