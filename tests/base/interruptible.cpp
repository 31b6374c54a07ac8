#include "base/threads/interruptible.hpp"

#include "base/errors.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <csignal>
#include <memory>
#include <stdexcept>

using namespace brdfplot;

TEST_CASE("what runs by itself returns its result, or throws") {
  CHECK(interruptible([] { return 7; }) == 7);
  CHECK_THROWS_AS(interruptible([]() -> int { throw std::out_of_range("x"); }), std::out_of_range);
}

TEST_CASE("Ctrl-C ends the waiting, not the work") {
  install_interrupt_handler();
  const auto stop = std::make_shared<std::atomic<bool>>(false);
  const auto ended = std::make_shared<std::atomic<bool>>(false);
  std::raise(SIGINT);
  CHECK_THROWS_AS(interruptible([stop, ended] {
                    while (!*stop) std::this_thread::yield();
                    *ended = true;
                    return 1;
                  }),
                  Interrupted);
  forget_interrupt();
  std::signal(SIGINT, SIG_DFL);
  CHECK(!*ended);
  *stop = true;
  while (!*ended) std::this_thread::yield();
}
