/// \file
/// Reading and writing of files. What is written appears under its final name only when it is complete.
///
/// `-` names stdin or stdout where a class says so. Every failure is a FileError with the file as WHERE; waiting for a
/// pipe or a terminal ends with Interrupted when the user presses Ctrl-C.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace brdfplot {

/// The whole of a file. \throws InputError when it has more bytes than `most`.
std::string read_text_file(const std::string& path, std::size_t most = std::size_t{1} << 40);

/// Writes a file at once (see OutputFile).
void write_text_file(const std::string& path, std::string_view text);

/// A file with what it is to hold.
struct NamedText {
  std::string path;
  std::string text;
};

/// Writes several files that belong together: all of them beside their places first, then they are renamed, in their
/// order. What fails or is interrupted before that leaves all of the old ones; should a renaming fail, the error says
/// how many are new.
void write_text_files(const std::vector<NamedText>& files);

/// Creates a folder and those above it, where they are missing.
void create_folders(const std::string& path);

/// Deletes a file.
void remove_file(const std::string& path);

/// Bytes of a file, or of stdin (`-`).
class InputFile {
public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& name() const { return name_; }
  /// Reads what there is, up to `size` bytes, and waits only when there is nothing. 0 at the end.
  std::size_t read(char* to, std::size_t size);
  /// Goes on reading at this byte of a regular file.
  void seek(std::uint64_t position);
  /// From now on there is nothing more to read: ends the read in which another thread may be waiting.
  void stop() { stopped_ = true; }

private:
  /// False when stopped.
  bool wait() const;

  std::atomic<bool> stopped_{false};
  std::string name_;
  int fd_ = -1;
  bool waits_ = false; ///< a pipe or a terminal
};

/// A file being written, or stdout (`-`). A regular file is written beside its place, under a temporary name;
/// commit() flushes it to the disk and renames it, as finish() and publish() do one after the other. Without them the
/// destructor removes it, and what stood in the place before stays. Links are followed; what is no regular file (a
/// device, a pipe) is written to as it is.
class OutputFile {
public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& name() const { return name_; }
  void write(std::string_view text);
  void commit();
  /// Flushes it to the disk: what a disk tells of late is told here.
  void finish();
  /// Renames it after finish().
  void publish();

private:
  void open_temporary();
  [[noreturn]] void fail(int error) const;

  std::string name_;
  std::string target_;    ///< of the rename; empty: written in place
  std::string temporary_; ///< exists; empty: none
  int fd_ = -1;
  bool waits_ = false;
};

} // namespace brdfplot
