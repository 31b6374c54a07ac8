/// \file
/// A cache of objects that are expensive to make, such as tables of Lambda: figures build the same material many times.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <string>
#include <utility>

namespace brdfplot {

/// The T that `make` gives for `key`, out of the last `most` that were made. T is cheap to copy; `make` must depend on
/// the key alone. Any number of threads.
template <class T, std::size_t most = 64, class Make>
T remembered(const std::string& key, const Make& make) {
  static std::mutex mutex;
  static std::deque<std::pair<std::string, T>> recent;
  {
    const std::lock_guard lock(mutex);
    for (const auto& [known, value] : recent)
      if (known == key) return value;
  }
  T made = make(); // not under the lock: two threads may make the same, which costs time only
  const std::lock_guard lock(mutex);
  recent.emplace_front(key, made);
  if (recent.size() > most) recent.pop_back();
  return made;
}

} // namespace brdfplot
