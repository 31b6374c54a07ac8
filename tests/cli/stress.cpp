#include "cli/program.hpp"

#include <nlohmann/json.hpp>

using namespace test;

TEST_CASE("stress: a table, and the exit code as a gate") {
  const Folder folder;
  const std::string table = check_output(folder, "brdfplot stress d_ggx");
  CHECK(table.find("d_ggx/printed_float\n  infinity ") != std::string::npos);
  CHECK(table.find("kernel\n") == std::string::npos);
  CHECK(table.find("2 of 6 fail, looked for with ") != std::string::npos);
  CHECK(check_output(folder, "brdfplot stress d_ggx --threads 1") == table);
  const auto code = [&](const std::string& flags) { return run(folder, "brdfplot stress " + flags).code; };
  CHECK(code("d_ggx --fail-on infinity") == 1);
  CHECK(code("d_ggx --fail-on nan --fail-on any") == 1);
  CHECK(code("d_ggx --fail-on nan") == 0);
  CHECK(code("d_ggx/kernel --fail-on any") == 0);
  CHECK(code("d_ggx/printed_float --fail-on digits_lost") == 1);
  CHECK(folder.list().empty());
}

TEST_CASE("stress: names that there are none of") {
  const Folder folder;
  check_error(folder, "brdfplot stress d_gxg", 2,
              {"stress: found \"d_gxg\"; did you mean \"d_ggx\"? accepted:", "d_gtr"});
  check_error(folder, "brdfplot stress d_ggx/kernle", 2, {"found \"d_ggx/kernle\"; did you mean \"d_ggx/kernel\"?"});
  check_error(folder, "brdfplot stress d_ggx --fail-on nam", 2,
              {"--fail-on: unknown", "\"nam\"; did you mean \"nan\"?"});
  check_error(folder, "brdfplot stress d_ggx --json --markdown", 2, {"accepted: one of --json, --markdown"});
  check_error(folder, "brdfplot stress none.json", 3, {"none.json"});
}

TEST_CASE("stress: files, the same for any number of threads") {
  const Folder folder;
  check_output(folder, "brdfplot stress d_ggx lambda_ggx -o one --threads 1");
  check_output(folder, "brdfplot stress d_ggx lambda_ggx -o two --threads 2");
  CHECK(folder.list("one") == std::vector<std::string>{"d_ggx.csv", "d_ggx.svg", "failures.csv", "failures.json",
                                                       "lambda_ggx.csv", "lambda_ggx.svg"});
  for (const auto& name : folder.list("one")) CHECK(folder.read("one/" + name) == folder.read("two/" + name));
  const auto json = nlohmann::json::parse(folder.read("one/failures.json"));
  CHECK(json == nlohmann::json::parse(run(folder, "brdfplot stress d_ggx lambda_ggx --json").out));
  const auto& printed = json["methods"][1];
  CHECK(printed["method"] == "printed_float");
  CHECK(printed["type"] == "float");
  CHECK(printed["failures"][0]["kind"] == "infinity");
  CHECK(printed["failures"][0]["bound"] == "lower");
  CHECK(printed["failures"][0]["simplest"]["cos_theta"] == 1);
  CHECK(printed["failures"][0]["value"].is_null());
}

TEST_CASE("stress: a material") {
  const Folder folder;
  folder.write("wall.json", R"({"terms": [{"type": "oren_nayar", "albedo": 1, "sigma": 0.3}]})");
  folder.write("own.json", R"json({"distribution": {"type": "ggx", "alpha": 0.01},
    "masking": {"type": "custom", "lambda": "0.1 - 1 / (1 + a)"}})json");
  const auto wall = run(folder, "brdfplot stress wall.json --fail-on energy_above_1");
  CHECK(wall.code == 1);
  CHECK(wall.out.find("wall/albedo\n  energy_above_1 ") == 0);
  CHECK(run(folder, "brdfplot stress wall.json --fail-on nan --fail-on not_reciprocal").code == 0);
  if (sampled()) return;
  const std::string own = check_output(folder, "brdfplot stress own.json");
  CHECK(own.find("own/lambda\n  negative ") != std::string::npos);
  CHECK(own.find("own/g1\n  above_1 ") != std::string::npos);
  CHECK(run(folder, "brdfplot stress configs/materials/ggx.json --fail-on any").code == 0);
}

TEST_CASE("stress: the page on stability has the program's own figures") {
  const Folder folder;
  const std::string page = read_file(fs::path(BRDFPLOT_SOURCE_DIR) / "docs/stability.md");
  std::istringstream rows(
      check_output(folder, "brdfplot stress lambda_beckmann lambda_ggx d_ggx half_vector alpha_o --markdown"));
  std::string row;
  std::size_t count = 0;
  for (; std::getline(rows, row); ++count) {
    INFO(row);
    CHECK(page.find(row + "\n") != std::string::npos);
  }
  CHECK(count > 10);
}
