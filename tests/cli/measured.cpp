// Measured data through the command line: written, read back, and broken.
#include "cli/program.hpp"

#include <bit>
#include <cstdint>
#include <limits>

using namespace test;

namespace {

/// Three numbers of cells, and values one after another.
std::string merl(const std::array<std::int32_t, 3>& sides, const std::vector<double>& values) {
  std::string bytes;
  const auto append = [&](auto number) {
    const auto raw = std::bit_cast<std::array<char, sizeof(number)>>(number);
    bytes.append(raw.data(), raw.size());
  };
  for (const std::int32_t side : sides) append(side);
  for (const double value : values) append(value);
  return bytes;
}

const std::string material = R"({"terms": [{"type": "merl", "file": "table.binary"}]})";
const std::string rows = "theta_o,theta_i,phi_i\n0.5,0.6,1\n30deg,0.2,3\n";
const std::string read_it = "brdfplot eval m.json -q brdf -i rows.csv";

} // namespace

TEST_CASE("convert writes what the term merl reads") {
  const Folder folder;
  folder.write("gold.json", R"({"distribution": {"type": "ggx", "alpha": 0.5},
                                "fresnel": {"type": "schlick", "f0": [1, 0.7, 0.3]}})");
  fs::create_directory(folder.path() / "sub");
  folder.write("sub/m.json", R"({"terms": [{"type": "merl", "file": "../table.binary"}]})");
  // The centre of cell (9, 20, 60) of the table: theta_h = (9.5/90)^2 pi/2, theta_d = 20.5deg, phi_d = 60.5deg.
  folder.write("figure.json", R"({"id": "f", "kind": "lines", "title": "t", "caption": "c", "channel": "g",
    "x": {"variable": "phi_d", "from": "60.5deg", "to": "80.5deg", "samples": 2}, "y": {"label": "y"},
    "at": {"theta_h": 0.017501509, "theta_d": "20.5deg"},
    "panels": [{"series": [{"label": "a", "quantity": "brdf", "material": {"$ref": "gold.json"}},
                           {"label": "b", "quantity": "brdf", "material": {"$ref": "sub/m.json"}}]}]})");
  CHECK(run(folder, "brdfplot convert gold.json -o table.binary --threads 2").code == 0);
  CHECK(fs::file_size(folder.path() / "table.binary") == 34992012);
  CHECK(folder.list() == std::vector<std::string>{"figure.json", "gold.json", "sub", "table.binary"});
  CHECK(check_output(folder, "brdfplot validate sub/m.json") == "sub/m.json: ok (material)\n");
  REQUIRE(run(folder, "brdfplot plot figure.json -o .").code == 0);
  std::istringstream csv(folder.read("f.csv"));
  std::vector<double> values;
  for (std::string line; std::getline(csv, line);)
    if (line.find(",a,") != std::string::npos || line.find(",b,") != std::string::npos)
      values.push_back(std::stod(line.substr(line.rfind(',') + 1)));
  REQUIRE(values.size() == 4);
  CHECK(values[2] == doctest::Approx(values[0]).epsilon(1e-6));
  CHECK(values[3] == doctest::Approx(values[1]).epsilon(1e-6));
  // The same bytes on one thread, and on stdout.
  const std::string table = folder.read("table.binary");
  CHECK(run(folder, "brdfplot convert gold.json -o - --threads 1").out == table);
}

TEST_CASE("convert says what it cannot write") {
  const Folder folder;
  check_error(folder, "brdfplot convert", 2, {"convert: needs MATERIAL.json"});
  check_error(folder, "brdfplot convert configs/materials/ggx.json", 2, {"convert: needs -o FILE.binary"});
  check_error(folder, "brdfplot convert configs/materials/ggx.json -o x.bsdf", 2,
              {"-o: found \"x.bsdf\"; accepted: a name that ends in .binary (MERL)"});
  check_error(folder, "brdfplot convert configs/materials/rough_gold.json -o x.binary", 2,
              {"configs/materials/rough_gold.json: found the term \"mirror\", which is not isotropic"});
  check_error(folder, "brdfplot convert configs/materials/ggx.json -o none/x.binary", 3,
              {"none/x.binary: cannot write"});
  CHECK(folder.list().empty());
}

TEST_CASE("a broken file of measured data: one line, exit code 2, and no memory for what it says") {
  const Folder folder;
  folder.write("m.json", material);
  folder.write("rows.csv", rows);
  folder.write("table.binary", merl({2, 2, 2}, std::vector<double>(24, 1.0)));
  const Outcome good = run(folder, read_it);
  CHECK(good.code == 0);
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  const std::vector<double> few(24, 1.0);
  std::vector<double> negative = few;
  negative[0] = -1;
  std::vector<double> nan = few;
  nan[23] = std::numeric_limits<double>::quiet_NaN();
  const std::string whole = merl({2, 2, 2}, few);
  for (const std::string& bytes :
       {std::string(), whole.substr(0, 5), whole.substr(0, 12), whole.substr(0, whole.size() - 1), whole + "x",
        merl({most, most, most}, few), merl({1 << 30, 1 << 30, 16}, few), merl({90, 90, 180}, few),
        merl({-2, -2, 2}, few), merl({0, 0, 0}, {}), merl({2, 2, 2}, negative), merl({2, 2, 2}, nan),
        std::string("{\"type\": \"text\", \"file\": \"is none\"}"), std::string(1000, '\xff')}) {
    folder.write("table.binary", bytes);
    INFO(bytes.size());
    check_error(folder, read_it, 2, {"brdfplot: error: table.binary: "});
    CHECK(run(folder, read_it).kilobytes < good.kilobytes + 4000);
    check_error(folder, "brdfplot validate m.json", 2, {"table.binary: "});
  }
  // A file of 300 MB, mostly holes, whose header is of another size: nothing of it is taken.
  folder.write("table.binary", merl({90, 90, 180}, few));
  fs::resize_file(folder.path() / "table.binary", 300000000);
  check_error(folder, read_it, 2, {"in a file of 300000000 bytes"});
  CHECK(run(folder, read_it).kilobytes < good.kilobytes + 4000);
  // And one that is whole, where there is no memory for it.
  folder.write("table.binary", merl({2500, 500, 10}, {}));
  fs::resize_file(folder.path() / "table.binary", 12 + 24LL * 12500000);
  if (!sanitized) check_error(folder, "ulimit -v 250000; " + read_it, 3, {"memory: there is not enough"});
  fs::remove(folder.path() / "table.binary");
  check_error(folder, read_it, 3, {"table.binary: cannot read: No such file or directory"});
  fs::create_directory(folder.path() / "table.binary");
  check_error(folder, read_it, 3, {"table.binary: cannot read: it is no regular file"});
}

TEST_CASE("a broken tensor file: one line, exit code 2, and no memory for what it says") {
  const Folder folder;
  folder.write("m.json", R"({"terms": [{"type": "rgl", "file": "table.bsdf"}]})");
  folder.write("rows.csv", rows);
  const fs::path corpus = fs::path(BRDFPLOT_SOURCE_DIR) / "tests/fuzz/corpus/rgl";
  const auto copy = [&](const char* name) {
    fs::copy_file(corpus / name, folder.path() / "table.bsdf", fs::copy_options::overwrite_existing);
  };
  copy("smallest.bsdf");
  const Outcome good = run(folder, read_it);
  CHECK(good.code == 0);
  for (const char* name : {"cut.bsdf", "overflow.bsdf", "nan.bsdf", "zero_density.bsdf", "type.bsdf", "twice.bsdf",
                           "descending.bsdf", "jacobian.bsdf", "empty.bsdf", "magic.bsdf", "odd_arc.bsdf"}) {
    INFO(name);
    copy(name);
    check_error(folder, read_it, 2, {"brdfplot: error: table.bsdf: "});
    CHECK(run(folder, read_it).kilobytes < good.kilobytes + 4000);
  }
}

TEST_CASE("the slices of half and difference angles that come with the program") {
  const Folder folder;
  CHECK(run(folder, "brdfplot plot configs/figures/half_difference_slices.json -o .").code == 0);
  const std::string csv = folder.read("half_difference_slices.csv");
  CHECK(std::ranges::count(csv, '\n') == 1 + 4 * 60 * 60);
  folder.write("mixed.json", R"({"id": "f", "kind": "lines", "title": "t", "caption": "c",
    "x": {"variable": "theta_d", "from": 0, "to": 1}, "y": {"label": "y"}, "at": {"theta_h": 0.1, "theta_o": 0.2},
    "panels": [{"series": [{"label": "a", "quantity": "brdf", "material": {"$ref": "configs/materials/ggx.json"}}]}]})");
  check_error(folder, "brdfplot plot mixed.json -o .", 2,
              {"mixed.json: /panels/0/series/0", "found \"theta_h\" beside \"theta_o\""});
}
