#include "base/threads/executor.hpp"

#include "base/errors.hpp"
#include "base/threads/interrupt.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <vector>

using namespace brdfplot;

TEST_CASE("an executor that goes ends its own batch at the next piece, and interrupts nobody else") {
  std::atomic<int> pieces = 0;
  std::atomic<bool> ended = false;
  const Compute endless = [&](std::span<const Numbers>, const Done& done) {
    try {
      for (;;) {
        done(0, {});
        ++pieces;
      }
    } catch (const Interrupted&) {
      CHECK(!interrupted());
      ended = true;
      throw;
    }
  };
  {
    Executor executor(endless);
    executor.add(0, {{1.0}});
    executor.add(1, {{2.0}});
    while (pieces < 3) std::this_thread::yield();
    CHECK(!executor.events(std::chrono::seconds(1)).empty());
    CHECK(!ended);
  }
  CHECK(ended);
}
