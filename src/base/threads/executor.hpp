/// \file
/// Batches of work on a thread of their own, one after the other, while their owner sees to other things.
#pragma once

#include "base/kept.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace brdfplot {

/// Computes pieces, on as many threads as it likes, and calls done(k, numbers) from any of them when the k-th is ready,
/// which throws Interrupted when nobody waits for it any more.
using Done = std::function<void(std::size_t, Numbers)>;
using Compute = std::function<void(std::span<const Numbers> pieces, const Done& done)>;

/// Why something could not be computed, as it goes through a message.
struct Failure {
  int code = 0;
  std::string text{};

  /// Of the exception that is being handled.
  static Failure current();
  [[noreturn]] void raise() const;
};

class Executor {
public:
  struct Event {
    enum class Kind : unsigned char { piece, finished, failed };
    Kind kind = Kind::finished;
    std::size_t batch = 0;
    std::size_t piece = 0; ///< of the batch
    Numbers numbers{};
    Failure failure{};
  };

  /// \throws Error when the system gives no thread
  explicit Executor(const Compute& compute);
  /// Ends what runs at its next piece; its events are dropped.
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  void add(std::size_t batch, std::vector<Numbers> pieces);
  /// What has happened; waits until there is something, no longer than this.
  std::vector<Event> events(std::chrono::milliseconds longest);

private:
  struct Batch {
    std::size_t number = 0;
    std::vector<Numbers> pieces{};
  };

  void run();
  void compute(const Batch& batch);
  void tell(Event event);

  const Compute& compute_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Batch> batches_;
  std::vector<Event> events_;
  std::atomic<bool> ending_ = false;
  std::jthread thread_;
};

} // namespace brdfplot
