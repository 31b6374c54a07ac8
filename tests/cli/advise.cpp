#include "cli/program.hpp"

#include <nlohmann/json.hpp>

using namespace test;

namespace {

/// Gold under a key light and a rim light; `more` are further keys.
std::string scene(const std::string& tolerance, const std::string& more = "") {
  return R"({"name": "small", "materials": [{"material": {"name": "Rough Gold", "terms": [{"name": "gold", "type": "mirror",
    "distribution": {"type": "ggx", "alpha": 0.4},
    "fresnel": {"type": "conductor", "eta": [0.143, 0.374, 1.442], "k": [3.983, 2.385, 1.603]}}]}}],
    "lights": [{"theta": "45deg", "irradiance": 2}, {"theta": "140deg", "phi": "20deg", "irradiance": 1}],
    "view": {"theta_o": ["0deg", "70deg"]}, "tolerance": {"delta_e": )" +
         tolerance + "}" + more + "}";
}

} // namespace

TEST_CASE("advise says the answer, why it is not less, and writes a material that can be evaluated") {
  const Folder folder;
  folder.write("s.json", scene("3"));
  const std::string out = check_output(folder, "brdfplot advise s.json -o out");
  for (const char* word : {"Rough Gold   (small)", "reaches", "answer", "tolerance 3", "proved", "verified"})
    CHECK_MESSAGE(out.find(word) != std::string::npos, word);
  CHECK(folder.read("out/advice.txt") == out);
  CHECK(folder.has("out/rough_gold.json"));
  CHECK(folder.read("out/rough_gold_ladder.svg").find("answer") != std::string::npos);
  CHECK(folder.read("out/rough_gold_models.csv")
            .starts_with("cost,error,p95,worst,light,verified,within,answer,model\n"));
  check_output(folder, "brdfplot validate out/rough_gold.json");
  check_output(folder, "brdfplot eval out/rough_gold.json -q brdf -i configs/points/pairs.csv");
}

TEST_CASE("advise --json has the answer, and a smaller tolerance is not cheaper") {
  const Folder folder;
  double before = 0;
  for (const char* tolerance : {"20", "5", "1", "0.01"}) {
    folder.write("s.json", scene(tolerance));
    const auto json = nlohmann::json::parse(check_output(folder, "brdfplot advise s.json --json"));
    const auto& material = json.at("materials").at(0);
    CHECK(material.at("within") == true);
    CHECK(material.at("answer").at("verified").at("error").get<double>() <= json.at("tolerance").get<double>());
    const auto cost = material.at("answer").at("cost").get<double>();
    CHECK(cost >= before);
    before = cost;
  }
}

TEST_CASE("targets: single precision is an answer of a processor that begins in double") {
  const Folder folder;
  for (const char* target : {"double", "double_simd", "float_simd"}) {
    folder.write("s.json", scene("5", R"(, "target": ")" + std::string(target) + "\""));
    const auto json = nlohmann::json::parse(check_output(folder, "brdfplot advise s.json --json"));
    CHECK(json.at("target") == target);
    const auto& answer = json.at("materials").at(0).at("answer");
    const bool begins_double = std::string(target).starts_with("double");
    CHECK((answer.at("model").dump().find("numbers: single precision (was double)") != std::string::npos) ==
          begins_double);
  }
  const std::string out = check_output(folder, "brdfplot advise s.json");
  for (const char* word : {"estimated multiply-adds of a lane in double", "at worst"})
    CHECK_MESSAGE(out.find(word) != std::string::npos, word);
}

TEST_CASE("a budget that cannot be met ends with 1 and the nearest that can be") {
  const Folder folder;
  folder.write("s.json", scene("1", R"(, "budget": 30)"));
  const Outcome outcome = run(folder, "brdfplot advise s.json");
  CHECK(outcome.code == 1);
  CHECK(outcome.out.find("30: not met") != std::string::npos);
  CHECK(outcome.err.starts_with("brdfplot: error: Rough Gold: no model does; asked: cost 30 with an error of 1; the "
                                "cheapest within the tolerance: cost "));
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
}

TEST_CASE("advise writes the same bytes on any number of threads") {
  const Folder folder;
  folder.write("s.json", scene("2"));
  for (const char* threads : {"1", "3"})
    check_output(folder, "brdfplot advise s.json -o out" + std::string(threads) + " --threads " + threads);
  for (const auto& name : folder.list("out1")) CHECK(folder.read("out1/" + name) == folder.read("out3/" + name));
}

TEST_CASE("scenes that advise does not take") {
  const Folder folder;
  check_error(folder, "brdfplot advise configs/scenes/gaussian.json", 2, {"found a scene (brdfplot simulate)"});
  check_error(folder, "brdfplot simulate configs/scenes/car_paint.json", 2, {"(brdfplot advise)"});
  check_error(folder, "brdfplot advise", 2, {"SCENE.json"});
  folder.write("s.json", scene("2", R"(, "goal": "shader")"));
  check_error(folder, "brdfplot advise s.json", 2, {"s.json: /goal", "unknown key \"goal\""});
  folder.write("s.json", scene("2", R"(, "target": "gpu")"));
  check_error(folder, "brdfplot advise s.json", 2,
              {"s.json: /target", "unknown value \"gpu\"", "shader", "double", "double_simd", "float", "float_simd"});
  folder.write("s.json", scene("0"));
  check_error(folder, "brdfplot advise s.json", 2, {"s.json: /tolerance/delta_e", "found 0"});
}
