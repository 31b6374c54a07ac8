#include "base/threads/executor.hpp"

#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"

#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace brdfplot {

namespace {

/// What has no exit code of its own.
constexpr int of_memory = -1, of_the_program = -2;

} // namespace

Failure Failure::current() {
  try {
    throw;
  } catch (const Error& error) {
    return {error.exit_code(), error.what()};
  } catch (const std::bad_alloc&) {
    return {of_memory};
  } catch (const std::exception& error) {
    return {of_the_program, error.what()};
  } catch (...) {
    return {of_the_program, "an exception of no known type"};
  }
}

void Failure::raise() const {
  if (code == of_memory) throw std::bad_alloc();
  if (code == of_the_program) throw std::runtime_error(text);
  throw Error(code, "", text);
}

Executor::Executor(const Compute& compute) : compute_(compute) {
  try {
    thread_ = std::jthread([this] { run(); });
  } catch (const std::system_error&) {
    throw Error(3, "threads", "the system gives no more");
  }
}

Executor::~Executor() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
}

void Executor::add(std::size_t batch, std::vector<Numbers> pieces) {
  {
    const std::lock_guard lock(mutex_);
    batches_.push_back({batch, std::move(pieces)});
  }
  changed_.notify_all();
}

std::vector<Executor::Event> Executor::events(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest, [&] { return !events_.empty(); });
  return std::exchange(events_, {});
}

void Executor::tell(Event event) {
  {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
  }
  changed_.notify_all();
}

void Executor::compute(const Batch& batch) {
  try {
    compute_(batch.pieces, [&](std::size_t piece, Numbers numbers) {
      if (ending_) throw Interrupted();
      tell({Event::Kind::piece, batch.number, piece, std::move(numbers)});
    });
    if (!interrupted()) tell({Event::Kind::finished, batch.number});
  } catch (const Interrupted&) { // NOLINT(bugprone-empty-catch): nobody waits, or who does looks at the flag too
  } catch (...) {
    tell({Event::Kind::failed, batch.number, 0, {}, Failure::current()});
  }
}

void Executor::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return ending_ || !batches_.empty(); });
    if (ending_) return;
    const Batch batch = std::move(batches_.front());
    batches_.pop_front();
    lock.unlock();
    compute(batch);
    lock.lock();
  }
}

} // namespace brdfplot
