#include "base/memory.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <limits>

namespace brdfplot {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number behind `key` in a file of the kernel; of a file that is one number, or the word "max", `key` is empty.
double number_in(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string word; key.empty() || file >> word;) {
    if (!key.empty() && word != key) continue;
    double value = 0;
    return file >> value ? value : unlimited;
  }
  return unlimited;
}

std::string gigabytes(double bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f GB", bytes * 1e-9);
  return text.data();
}

} // namespace

double available_memory() {
  const double of_machine = 1024 * number_in("/proc/meminfo", "MemAvailable:");
  const double most = number_in("/sys/fs/cgroup/memory.max", "");
  if (most == unlimited) return of_machine;
  return std::min(of_machine, most - number_in("/sys/fs/cgroup/memory.current", ""));
}

void require_memory(double bytes, const std::string& what) {
  const double available = available_memory();
  if (bytes > available)
    throw FileError("memory", what + " takes about " + gigabytes(bytes) + "; available: " + gigabytes(available));
}

} // namespace brdfplot
