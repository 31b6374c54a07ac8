/// \file
/// Measured data, read once a process: a figure builds the same material many times.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>

namespace brdfplot {

/// What `read` makes of the file at `path`. It is shared, and kept as long as the program runs; a file that has
/// changed, in its length or its time, is read again. Any number of threads. \throws what `read` does
template <class Data, class Read>
std::shared_ptr<const Data> measured_file(const std::string& path, const Read& read) {
  struct Kept {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    std::shared_ptr<const Data> data;
  };
  static std::mutex mutex;
  static std::map<std::string, Kept> all;
  std::error_code error; // of a file that is not there the reader tells
  const auto time = std::filesystem::last_write_time(path, error);
  const auto size = error ? 0 : std::filesystem::file_size(path, error);
  const std::lock_guard lock(mutex);
  Kept& kept = all[path];
  if (!kept.data || kept.time != time || kept.size != size) {
    kept.data = nullptr; // not twice in memory
    kept = {time, size, std::make_shared<const Data>(read(path))};
  }
  return kept.data;
}

} // namespace brdfplot
