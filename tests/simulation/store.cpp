#include "simulation/store.hpp"

#include "base/text_files.hpp"
#include "base/threads/parallel.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>

using namespace brdfplot;
using namespace brdfplot::simulation;

namespace {

namespace fs = std::filesystem;

/// A folder that goes with the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("brdfplot-store-" + std::to_string(std::rand()));
  ~Folder() { fs::remove_all(path); }
};

const Result sample = {{"brdf_cos/1", {2, {0.1, 1e-300, 0.3, -2.5, 1.0 / 3, 0}}}, {"empty", {0, {}}}};

} // namespace

TEST_CASE("a mean has the standard error of its estimates") {
  // 1, 2, 3, 4: variance 5/3, of the mean 5/12.
  const Estimates estimates{1, {1, 2, 3, 4}};
  CHECK(estimates.at(0).value == 2.5);
  CHECK(estimates.at(0).standard_error == doctest::Approx(std::sqrt(5.0 / 12)).epsilon(1e-15));
  CHECK(sample.at("brdf_cos/1").at(1).value == doctest::Approx(-2.5 / 3));
}

TEST_CASE("results are read back to the last bit, and only when they are whole") {
  const std::string text = to_text("key\nwith lines", sample);
  CHECK(from_text("key\nwith lines", text) == sample);
  CHECK_FALSE(from_text("another key", text));
  for (std::size_t length = 0; length < text.size(); ++length)
    CHECK_FALSE(from_text("key\nwith lines", text.substr(0, length)));
  for (const std::size_t place : {std::size_t{20}, text.size() / 2, text.size() - 2}) {
    std::string changed = text;
    changed[place] = changed[place] == '1' ? '2' : '1';
    CHECK_FALSE(from_text("key\nwith lines", changed));
  }
}

TEST_CASE("a store computes once, and not again with the files of an earlier one") {
  const Folder folder;
  int computed = 0;
  const auto compute = [&] { return ++computed, sample; };
  Store first(folder.path.string());
  CHECK(*first.get("a", compute) == sample);
  CHECK(*first.get("a", compute) == sample);
  CHECK(computed == 1);
  Store second(folder.path.string());
  CHECK(*second.get("a", compute) == sample);
  CHECK(computed == 1);
  CHECK(*second.get("b", compute) == sample);
  CHECK(computed == 2);
}

TEST_CASE("a store takes no harm from broken files and folders") {
  const Folder folder;
  int computed = 0;
  const auto compute = [&] { return ++computed, sample; };
  Store(folder.path.string()).get("a", compute);
  const std::string file = Store(folder.path.string()).path("a");
  write_text_file(file, "brdfplot simulation");
  CHECK(*Store(folder.path.string()).get("a", compute) == sample);
  CHECK(computed == 2);
  CHECK(*Store(folder.path.string()).get("a", compute) == sample); // mended
  CHECK(computed == 2);
  Store nowhere((fs::path(file) / "below a file").string());
  CHECK(*nowhere.get("a", compute) == sample);
  CHECK(*nowhere.get("a", compute) == sample);
  CHECK(computed == 3);
}

TEST_CASE("what fails is not remembered, and two threads that ask for one result compute it once") {
  Store store;
  CHECK_THROWS_AS(store.get("a", []() -> Result { throw std::runtime_error("no"); }), std::runtime_error);
  std::atomic<int> computed{0};
  parallel_for(8, 4, [&](std::size_t) {
    store.get("a", [&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      return ++computed, sample;
    });
  });
  CHECK(computed == 1);
}
