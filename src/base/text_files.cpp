#include "base/text_files.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <deque>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace brdfplot {

namespace {

/// A signal may be delivered to another thread than the one that waits, so waiting looks at the flag this often.
constexpr int patience_ms = 100;

/// What a pipe that is ready to be written takes at least, without waiting (PIPE_BUF of Linux).
constexpr std::size_t pipe_chunk = 4096;

std::string reason(int error) { return std::generic_category().message(error); }

bool is_regular(int fd) {
  struct stat status {};
  return fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
}

/// Waits a little; whether `fd` is ready (or broken, of which the next call tells).
bool is_ready(int fd, short event) {
  throw_if_interrupted();
  struct pollfd request {
    fd, event, 0
  };
  const int count = poll(&request, 1, patience_ms);
  return count > 0 || (count < 0 && errno != EINTR);
}

} // namespace

InputFile::InputFile(const std::string& path) : name_(path) {
  fd_ = path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd_ < 0) throw FileError(echo(name_, shown_path), "cannot read: " + reason(errno));
  waits_ = !is_regular(fd_);
}

InputFile::~InputFile() {
  if (fd_ > STDERR_FILENO) close(fd_);
}

bool InputFile::wait() const {
  while (!stopped_ && !is_ready(fd_, POLLIN)) {
  }
  return !stopped_;
}

std::size_t InputFile::read(char* to, std::size_t size) {
  while (true) {
    throw_if_interrupted();
    if (waits_ && !wait()) return 0;
    const ssize_t count = ::read(fd_, to, size);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR && errno != EAGAIN) throw FileError(name_, "cannot read: " + reason(errno));
  }
}

void InputFile::seek(std::uint64_t position) {
  if (lseek(fd_, static_cast<off_t>(position), SEEK_SET) < 0) throw FileError(name_, "cannot read: " + reason(errno));
}

OutputFile::OutputFile(const std::string& path) : name_(path) {
  if (path == "-") {
    fd_ = STDOUT_FILENO;
    waits_ = !is_regular(fd_);
    return;
  }
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    fd_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd_ < 0) fail(errno);
    waits_ = true;
    return;
  }
  std::error_code error;
  target_ = exists ? std::filesystem::canonical(path, error).string() : path;
  if (error) fail(error.value());
  open_temporary();
}

void OutputFile::open_temporary() {
  static std::atomic<unsigned> counter{0};
  do {
    temporary_ = target_ + "." + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".tmp";
    fd_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (fd_ < 0 && errno == EEXIST);
  if (fd_ >= 0) return;
  temporary_.clear();
  fail(errno);
}

OutputFile::~OutputFile() {
  if (fd_ > STDERR_FILENO) close(fd_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::fail(int error) const {
  if (error == EPIPE && fd_ == STDOUT_FILENO)
    throw ClosedPipe(echo(name_, shown_path), "cannot write: " + reason(error));
  throw FileError(echo(name_, shown_path), "cannot write: " + reason(error));
}

void OutputFile::write(std::string_view text) {
  while (!text.empty()) {
    throw_if_interrupted();
    if (waits_ && !is_ready(fd_, POLLOUT)) continue;
    const std::size_t size = waits_ ? std::min(text.size(), pipe_chunk) : text.size();
    const ssize_t count = ::write(fd_, text.data(), size);
    if (count >= 0)
      text.remove_prefix(static_cast<std::size_t>(count));
    else if (errno != EINTR && errno != EAGAIN)
      fail(errno);
  }
}

void OutputFile::commit() {
  finish();
  publish();
}

void OutputFile::finish() {
  throw_if_interrupted();
  if (target_.empty()) {
    // Closing is when a network file system tells of a failure; stdout itself stays open for whoever writes next.
    const int copy = dup(fd_);
    if (copy < 0 || close(copy) != 0) fail(errno);
    return;
  }
  if (fsync(fd_) != 0) fail(errno);
  const int fd = fd_;
  fd_ = -1;
  if (close(fd) != 0) fail(errno);
}

void OutputFile::publish() {
  if (target_.empty()) return;
  if (rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

std::string read_text_file(const std::string& path, std::size_t most) {
  InputFile file(path);
  std::string text;
  for (std::size_t size = 0;;) {
    const std::size_t step = std::max<std::size_t>(4096, size);
    text.resize(size + step);
    const std::size_t count = file.read(text.data() + size, step);
    text.resize(size += count);
    if (size > most)
      throw InputError(echo(path, shown_path), "has more than " + std::to_string(most) + " bytes; accepted: fewer");
    if (count == 0) return text;
  }
}

void write_text_file(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

void write_text_files(const std::vector<NamedText>& files) {
  std::deque<OutputFile> written;
  for (const auto& [path, text] : files) {
    written.emplace_back(path).write(text);
    written.back().finish();
  }
  for (std::size_t k = 0; k < written.size(); ++k) {
    try {
      written[k].publish();
    } catch (const FileError& error) {
      if (k == 0) throw;
      throw FileError(error.what(), std::to_string(k) + " of the " + std::to_string(written.size()) +
                                        " files are new, the others are as they were");
    }
  }
}

void create_folders(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error && !std::filesystem::is_directory(path, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw FileError(echo(path, shown_path), "cannot create the folder: " + reason(error.value()));
}

void remove_file(const std::string& path) {
  if (unlink(path.c_str()) != 0) throw FileError(path, "cannot remove: " + reason(errno));
}

} // namespace brdfplot
