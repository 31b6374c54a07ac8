/// \file
/// Results of simulations, remembered: in memory, and in files for the next time.
#pragma once

#include "simulation/statistics.hpp"

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::simulation {

/// To be raised whenever a simulation gives other numbers than it gave before: older files are then not found.
inline constexpr int results_version = 2;

/// What one simulation measured, by name of the output.
using Result = std::map<std::string, Estimates>;

/// Remembers results by what defines them. Safe to use from several threads.
class Store {
public:
  /// In memory alone.
  Store() = default;
  /// In files too, in `folder`, which is made when something is to be kept.
  explicit Store(std::string folder) : folder_(std::move(folder)) {}

  /// The result that `key` (a text that defines it completely) stands for: from memory, from its file, or computed.
  /// What is wrong with a file (an older version, half a file, another key of the same hash) makes it as if it were not
  /// there. A file that cannot be written is not kept, silently: the next time it takes as long as this time. Who asks
  /// for what another thread computes waits for it.
  std::shared_ptr<const Result> get(const std::string& key, const std::function<Result()>& compute);

  /// The file of a key.
  std::string path(const std::string& key) const;

private:
  using Shared = std::shared_ptr<const Result>;
  Shared make(const std::string& key, const std::function<Result()>& compute) const;
  std::optional<Result> read(const std::string& key) const;
  void write(const std::string& key, const Result& result) const;

  std::string folder_;
  std::mutex mutex_;
  std::map<std::string, std::shared_future<Shared>> known_;
};

/// Where results are kept between runs: $XDG_CACHE_HOME/brdfplot, or ~/.cache/brdfplot; empty when neither is known.
std::string default_store_folder();

/// A result as the text of its file, and back; nothing when the text is not whole or not of this key.
std::string to_text(const std::string& key, const Result& result);
std::optional<Result> from_text(const std::string& key, const std::string& text);

} // namespace brdfplot::simulation
