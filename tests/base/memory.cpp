#include "base/memory.hpp"

#include "config/temp_files.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace brdfplot;

TEST_CASE("memory is asked for before it is taken") {
  CHECK(available_memory() > 0);
  CHECK_NOTHROW(require_memory(0, "nothing"));
  if (!std::isfinite(available_memory())) return;
  try {
    require_memory(3e18, "a surface");
    FAIL("there cannot be as much");
  } catch (const FileError& error) {
    CHECK(test::contains(error.what(), "memory: a surface takes about 3000000000.0 GB; available: "));
  }
}
