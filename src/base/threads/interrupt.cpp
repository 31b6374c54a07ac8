#include "base/threads/interrupt.hpp"

#include "base/errors.hpp"

#include <atomic>
#include <csignal>

namespace brdfplot {

namespace {

std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait for a lock");

extern "C" void set_flag(int) { flag.store(true, std::memory_order_relaxed); }

} // namespace

void install_interrupt_handler() {
  struct sigaction action {};
  action.sa_handler = set_flag;
  // No SA_RESTART: a call that waits for input returns, and its caller looks at the flag.
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  // nohup sets SIGHUP to be ignored, and means it.
  struct sigaction inherited {};
  if (sigaction(SIGHUP, nullptr, &inherited) == 0 && inherited.sa_handler != SIG_IGN)
    sigaction(SIGHUP, &action, nullptr);
}

bool interrupted() { return flag.load(std::memory_order_relaxed); }

void forget_interrupt() { flag.store(false, std::memory_order_relaxed); }

void throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

} // namespace brdfplot
