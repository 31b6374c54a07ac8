#include "cli/program.hpp"

#include <nlohmann/json.hpp>

using namespace test;
using Json = nlohmann::json;

TEST_CASE("pareto: a table with a line for every method, times and fronts") {
  const Folder folder;
  const std::string out = check_output(folder, "brdfplot pareto fresnel_dielectric");
  for (const char* part : {"fresnel_dielectric: ", "schlick_1994", "+0.0357", "kernel",
                           "front by cost, relative: ", "front by time, absolute: ", "Times: "})
    CHECK(out.find(part) != std::string::npos);
  CHECK(folder.list().empty());
}

TEST_CASE("pareto: files, and the same bytes without times for any number of threads") {
  const Folder folder;
  for (const char* threads : {"1", "3"})
    check_output(folder, std::string("brdfplot pareto lambda_ggx fresnel_conductor --no-times -o out") + threads +
                             " --threads " + threads);
  const std::vector<std::string> files = {"fresnel_conductor_cost.svg", "index.html", "lambda_ggx_cost.svg",
                                          "pareto.csv", "pareto.json"};
  CHECK(folder.list("out1") == files);
  for (const auto& file : files) {
    CAPTURE(file);
    CHECK(folder.read("out1/" + file) == folder.read("out3/" + file));
  }
  const std::string svg = folder.read("out1/lambda_ggx_cost.svg");
  for (const char* name : {">rewritten<", ">karis_2013<", ">front<"}) CHECK(svg.find(name) != std::string::npos);
  CHECK(svg.find("avx") == std::string::npos); // another machine has others
  check_output(folder, "brdfplot pareto lambda_ggx -o out");
  CHECK(folder.list("out") == std::vector<std::string>{"index.html", "lambda_ggx_cost.svg", "lambda_ggx_time.svg",
                                                       "pareto.csv", "pareto.json", "times.csv"});
}

TEST_CASE("pareto: JSON has operations, errors with their inputs, and who is better") {
  const Folder folder;
  const Json json = Json::parse(check_output(folder, "brdfplot pareto lambda_beckmann --json"));
  CHECK(json["machine"]["processor"].get<std::string>() != "");
  const Json& problem = json["problems"].at(0);
  CHECK(problem["name"] == "lambda_beckmann");
  CHECK(problem["reference"] == "kernel");
  bool walter = false;
  for (const Json& method : problem["methods"]) {
    CHECK(method["time"]["least_ns"].get<double>() > 0);
    if (method["name"] != "walter_2007") continue;
    walter = true;
    CHECK(method["operations"]["divisions"] == 1);
    CHECK(method["errors"]["above"]["error"].get<double>() == doctest::Approx(0.00311).epsilon(2e-3));
    CHECK(method["errors"]["above"]["at"]["a"].get<double>() == doctest::Approx(1.338).epsilon(1e-3));
    CHECK(method["front_by_cost"]["relative"]["dominated_by"] == "walter_kernel_float");
  }
  CHECK(walter);
}

TEST_CASE("pareto: of a material its integrals, with whether their estimates hold") {
  const Folder folder;
  const std::string out =
      check_output(folder, "brdfplot pareto albedo lambda configs/materials/beckmann.json --no-times");
  for (const char* part : {"albedo: Albedo of Beckmann", "lambda: Smith's Lambda of Beckmann", "quadrature_1e-9",
                           "fit_1e-4", "bounds the error in 12 of 12 directions"})
    CHECK(out.find(part) != std::string::npos);
  CHECK(out.find("furnace") == std::string::npos);
}

TEST_CASE("pareto: what is wrong is said in a line") {
  const Folder folder;
  check_error(
      folder, "brdfplot pareto lambda_gxg", 2,
      {"pareto: ", "unknown quantity \"lambda_gxg\"", "did you mean \"lambda_ggx\"?", "accepted: lambda_beckmann"});
  check_error(folder, "brdfplot pareto missing.json", 3, {"missing.json"});
  check_error(folder, "brdfplot pareto configs/materials/ggx.json configs/materials/beckmann.json", 2,
              {"second material", "accepted: one"});
  folder.write("wrong.json", R"({"distribution": {"type": "ggx", "alpha": -1}})");
  check_error(folder, "brdfplot pareto wrong.json", 2, {"wrong.json: /distribution/alpha", "-1"});
  folder.write("file", "");
  check_error(folder, "brdfplot pareto g2 --no-times -o file", 3, {"file"});
}
