// Files that a material names: relative to the file in which their name is written.
#include "brdf/evaluate.hpp"
#include "config/load.hpp"
#include "temp_files.hpp"

#include <array>
#include <bit>

using namespace brdfplot;
using test::contains;
using test::error_of;
using test::TempFolder;

namespace {

/// One cell, the same for all directions: rho = value in red.
std::string table(double value) {
  std::string bytes;
  for (const std::int32_t side : {1, 1, 1}) {
    const auto raw = std::bit_cast<std::array<char, 4>>(side);
    bytes.append(raw.data(), raw.size());
  }
  for (const double one : {1500 * value, 0.0, 0.0}) {
    const auto raw = std::bit_cast<std::array<char, 8>>(one);
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

double rho(const std::string& path) {
  const Direction o = from_angles(0.3, 0);
  return evaluate(build(config::load_material(path)), Quantity::brdf, o, o, std::nullopt);
}

} // namespace

TEST_CASE("a file of measured data is found beside the file that names it") {
  const TempFolder folder;
  folder.write("a/table.binary", table(1));
  folder.write("b/table.binary", table(2));
  const std::string own = folder.write("a/own.json", R"({"terms": [{"type": "merl", "file": "table.binary"}]})");
  const std::string up = folder.write("a/up.json", R"({"terms": [{"type": "merl", "file": "../b/table.binary"}]})");
  folder.write("b/terms.json",
               R"({"far": {"type": "merl", "name": "far", "file": "table.binary"}, "name": "table.binary"})");
  const std::string both = folder.write("a/both.json", R"({"terms": [{"$ref": "../b/terms.json#/far"},
                                                        {"type": "merl", "file": "table.binary", "weight": 10}]})");
  const std::string name =
      folder.write("a/name.json", R"({"terms": [{"type": "merl", "file": {"$ref": "../b/terms.json#/name"}}]})");
  const std::string full = folder.write("c/full.json", R"({"terms": [{"type": "merl", "file": ")" +
                                                           folder.path("a/table.binary") + R"("}]})");
  const std::string within =
      folder.write("a/within.json", R"({"terms": [{"type": "complement", "of": {"$ref": "../b/terms.json#/far"}}]})");
  CHECK(rho(own) == doctest::Approx(1));
  CHECK(rho(up) == doctest::Approx(2));
  CHECK(rho(both) == doctest::Approx(12));
  CHECK(rho(name) == doctest::Approx(2));
  CHECK(rho(full) == doctest::Approx(1));
  CHECK(contains(error_of(folder, 2, [&] { config::load_material(within); }), "/far: \"far\" is measured"));
  std::filesystem::remove(folder.path("b/table.binary"));
  folder.write("b/terms.json", R"({"far": {"type": "merl", "file": "./table.binary"}})");
  const std::string found = error_of(folder, 3, [&] { config::load_material(within); });
  CHECK_MESSAGE(contains(found, "a/../b/./table.binary: cannot read: No such file"), found);
}

TEST_CASE("a term of measured data needs a file, and nothing else") {
  const TempFolder folder;
  const auto error = [&](const std::string& term) {
    const std::string path = folder.write("m.json", R"({"terms": [)" + term + "]}");
    return error_of(folder, 2, [&] { config::load_material(path); });
  };
  CHECK(error(R"({"type": "merl"})").starts_with("m.json: /terms/0"));
  CHECK(error(R"({"type": "rgl", "file": 3})").starts_with("m.json: /terms/0/file"));
  CHECK(contains(error(R"({"type": "merl", "file": "x", "albedo": 1})"), "albedo"));
}
