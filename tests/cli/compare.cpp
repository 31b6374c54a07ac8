#include "cli/program.hpp"

#include <nlohmann/json.hpp>

using namespace test;

TEST_CASE("compare: a table, JSON and a folder") {
  const Folder folder;
  folder.write("a.json", R"({"name": "half", "terms": [{"type": "lambert", "albedo": 0.5}]})");
  folder.write("b.json", R"({"name": "quarter", "terms": [{"type": "lambert", "albedo": 0.25}]})");
  const std::string text = check_output(folder, "brdfplot compare a.json b.json");
  CHECK(text.starts_with("quarter against half\n"));
  CHECK(text.find("light               50 %") != std::string::npos);
  CHECK(text.find("albedo at 85deg     0.5 and 0.25") != std::string::npos);
  const auto json = nlohmann::json::parse(check_output(folder, "brdfplot compare a.json b.json b.json --json"));
  CHECK(json["a"] == "half");
  REQUIRE(json["materials"].size() == 2);
  CHECK(json["materials"][1]["name"] == "quarter (2)");
  CHECK(json["materials"][0]["rms"]["value"].get<double>() == doctest::Approx(0.5));
  CHECK(check_output(folder, "brdfplot compare a.json b.json -o out") == text);
  CHECK(folder.list("out") == std::vector<std::string>{"compare.csv", "compare.json", "difference.csv",
                                                       "difference.svg", "index.html", "lobes.csv", "lobes.svg",
                                                       "spheres.csv", "spheres.svg"});
  CHECK(folder.read("out/compare.csv").starts_with("material,quantity,theta_o,channel,a,b,value,standard_error\n"));
}

TEST_CASE("compare: parameters fitted to the first") {
  const Folder folder;
  folder.write("a.json", R"({"name": "A", "distribution": {"type": "ggx", "alpha": 0.4}})");
  folder.write("b.json", R"({"name": "B", "distribution": {"type": "ggx", "alpha": 0.2}})");
  const auto json = nlohmann::json::parse(check_output(folder, "brdfplot compare a.json b.json --refit alpha --json"));
  const double alpha = json["materials"][0]["material"]["terms"][0]["distribution"]["alpha"].get<double>();
  CHECK(alpha == doctest::Approx(0.4).epsilon(0.01));
}

TEST_CASE("compare: what is wrong") {
  const Folder folder;
  folder.write("a.json", R"({"distribution": {"type": "ggx", "alpha": 0.4}})");
  check_error(folder, "brdfplot compare a.json", 2, {"A.json B.json"});
  check_error(folder, "brdfplot compare a.json missing.json", 3, {"missing.json"});
  check_error(folder, "brdfplot compare a.json a.json --refit albedo", 2, {"--refit", "\"albedo\"", "accepted: alpha"});
}
