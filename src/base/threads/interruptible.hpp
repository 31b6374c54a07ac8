/// \file
/// Work that cannot look at the flag of Ctrl-C itself: a transform or a sort of a library.
#pragma once

#include "base/threads/interrupt.hpp"

#include <chrono>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

namespace brdfplot {

/// What `work` returns, which runs on a thread of its own while this one waits. After Ctrl-C nobody waits for it any
/// more: it is left to itself, and its result is dropped. So it may use only what it holds, not references.
/// \throws Interrupted, and what `work` throws
template <class Work>
std::invoke_result_t<Work&> interruptible(Work work) {
  using Result = std::invoke_result_t<Work&>;
  const auto task = std::make_shared<std::packaged_task<Result()>>(std::move(work));
  std::future<Result> result = task->get_future();
  try {
    std::thread([task] { (*task)(); }).detach();
  } catch (const std::system_error&) {
    (*task)(); // there are no more threads
  }
  while (result.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) throw_if_interrupted();
  return result.get();
}

} // namespace brdfplot
