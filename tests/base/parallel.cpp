#include "base/threads/parallel.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

using namespace brdfplot;

TEST_CASE("every index once, on any number of threads") {
  for (const int threads : {-1, 0, 1, 2, 7, 1000}) {
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{100}}) {
      std::vector<std::atomic<int>> calls(n);
      parallel_for(n, threads, [&](std::size_t index) { ++calls[index]; });
      for (const auto& count : calls) CHECK(count == 1);
    }
  }
}

TEST_CASE("the exception of the smallest index is the one") {
  for (const int threads : {1, 2, 7}) {
    for (int repetition = 0; repetition < 50; ++repetition) {
      const auto body = [](std::size_t index) {
        if (index % 10 == 3) throw std::runtime_error(std::to_string(index));
      };
      CHECK_THROWS_WITH(parallel_for(100, threads, body), "3");
    }
  }
}

TEST_CASE("nothing starts after an exception") {
  std::atomic<int> calls{0};
  CHECK_THROWS(parallel_for(1000, 1, [&](std::size_t) {
    ++calls;
    throw std::runtime_error("");
  }));
  CHECK(calls == 1);
}
