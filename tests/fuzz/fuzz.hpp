/// \file
/// What the fuzzers share. Each gives a reader the bytes that libFuzzer makes up; an error is an answer, as long as it
/// is one line of bounded length. Anything else that is thrown, a fault that a sanitizer finds, ten seconds without an
/// answer or two gigabytes of memory are findings.
#pragma once

#include "base/errors.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace brdfplot::fuzz {

/// A file named `input` in a folder of its own, so that relative paths in it lead to nothing else.
class ScratchFile {
public:
  ScratchFile() {
    if (mkdtemp(folder_.data()) == nullptr) std::abort();
    path_ = folder_ + "/input";
    fd_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (fd_ < 0) std::abort();
  }
  ~ScratchFile() {
    close(fd_);
    unlink(path_.c_str());
    rmdir(folder_.c_str());
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return path_; }
  void set(const std::uint8_t* data, std::size_t size) const {
    if (ftruncate(fd_, 0) != 0 || pwrite(fd_, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  }

private:
  std::string folder_ = std::filesystem::temp_directory_path() / "brdfplot-fuzz-XXXXXX";
  std::string path_;
  int fd_ = -1;
};

/// Runs a reader; an error has to be what a user can read.
template <class Read>
void try_to(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    const std::string_view what = error.what();
    if (what.empty() || what.size() > 20000 || what.find('\n') != std::string_view::npos) std::abort();
  }
}

/// Gives a file with these bytes to a reader of files.
template <class Read>
int try_file(const std::uint8_t* data, std::size_t size, const Read& read) {
  static const ScratchFile file;
  file.set(data, size);
  try_to([&] { read(file.path()); });
  return 0;
}

} // namespace brdfplot::fuzz
