#include "base/threads/parallel.hpp"

#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace brdfplot {

int hardware_threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void run_on_threads(int threads, const std::function<void()>& work) {
  std::vector<std::jthread> others;
  try {
    for (int k = 1; k < threads; ++k) others.emplace_back(std::cref(work));
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do all the work.
  } catch (const std::bad_alloc&) {
    // Nor does it for want of memory.
  }
  work();
}

void parallel_for(std::size_t n, int threads, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::size_t failed = n;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t index = next++; index < n; index = next++) {
      try {
        throw_if_interrupted();
        body(index);
      } catch (...) {
        next = n;
        const std::lock_guard lock(mutex);
        if (index < failed) {
          failed = index;
          failure = std::current_exception();
        }
      }
    }
  };
  run_on_threads(static_cast<int>(std::min(n, static_cast<std::size_t>(std::max(threads, 1)))), work);
  throw_if_interrupted();
  if (failure) std::rethrow_exception(failure);
}

} // namespace brdfplot
