#include "cli/program.hpp"

#include <nlohmann/json.hpp>

using namespace test;

namespace {

void check_material(const std::string& json, const std::vector<std::string>& parts) {
  const Folder folder;
  folder.write("m.json", json);
  INFO(json);
  check_error(folder, "brdfplot validate m.json", 2, parts);
  check_error(folder, "brdfplot eval m.json -q d -i configs/points/theta_o.csv", 2, parts);
}

} // namespace

TEST_CASE("materials that are wrong say where and what") {
  check_material(R"({"distribution": {"type": "ggx", "alhpa": 0.5}})",
                 {"m.json: /distribution", "\"alhpa\"", "did you mean \"alpha\"?"});
  check_material(R"({"distribtion": {"type": "ggx", "alpha": 0.5}})", {"\"distribtion\"", "\"distribution\""});
  check_material(R"({"distribution": {"type": "gxg", "alpha": 0.5}})",
                 {"m.json: /distribution", "\"gxg\"", "did you mean \"ggx\"?", "beckmann"});
  check_material(R"({"distribution": {"type": "ggx", "alpha": "rough"}})", {"m.json: /distribution/alpha: ", "rough"});
  check_material(R"({"distribution": {"type": "ggx", "alpha": [1, 2]}})", {"m.json: /distribution/alpha: "});
  check_material(R"({"distribution": {"type": "ggx", "alpha": -0.5}})",
                 {"m.json: /distribution/alpha: ", "-0.5", "a number in [1e-06, 1e+06]"});
  check_material(R"({"distribution": {"type": "ggx", "alpha_x": 0.5}})", {"m.json: /distribution", "alpha_y"});
  check_material(R"({"distribution": {"type": "ggx"}})", {"m.json: /distribution", "alpha"});
  check_material(R"({"name": "empty"})", {"m.json: ", "distribution"});
  check_material(R"({"distribution": {"type": "ggx", "alpha": 1}, "masking": {"type": "v_cavity"},
                     "shadowing": {"type": "height_correlated"}})",
                 {"m.json: /shadowing/type: ", "height_correlated"});
  check_material(R"({"distribution": {"type": "ggx", "alpha": 1}, "fresnel": {"type": "schlick", "f0": 2}})",
                 {"m.json: /fresnel/f0: ", "2", "[0, 1]"});
  check_material("{\"distribution\":\n  {\"type\": \"ggx\",, \"alpha\": 1}}\n", {"m.json:2:18: "});
  check_material("{\"distribution\":", {"m.json:1:"});
  check_material("", {"m.json:1:1: "});
  check_material("[1]", {"m.json: "});
}

TEST_CASE("validate reports every file") {
  const Folder folder;
  folder.write("bad.json", R"({"distribution": {"type": "ggx", "alpha": 0}})");
  const std::string good = "configs/materials/ggx.json";
  CHECK(check_output(folder, "brdfplot validate " + good) == good + ": ok (material)\n");
  const Outcome outcome = run(folder, "brdfplot validate bad.json " + good + " nope.json bad.json");
  CHECK(outcome.code == 3);
  CHECK(outcome.out == good + ": ok (material)\n");
  CHECK(std::ranges::count(outcome.err, '\n') == 3);
  const Outcome quiet = run(folder, "brdfplot --quiet validate bad.json " + good);
  CHECK(quiet.code == 2);
  CHECK(quiet.out == "");
  CHECK(std::ranges::count(quiet.err, '\n') == 1);
}

TEST_CASE("every schema is JSON") {
  const Folder folder;
  for (const char* kind : {"material", "figure", "report", "scene", "advice"}) {
    const auto schema = nlohmann::json::parse(check_output(folder, "brdfplot schema " + std::string(kind)));
    CHECK(schema.at("$schema").get<std::string>().find("2020-12") != std::string::npos);
    // A material is a list of terms, or one.
    if (std::string(kind) == "material") CHECK(schema.at("then").at("properties").contains("terms"));
    CHECK((std::string(kind) == "material" ? schema.at("else") : schema).contains("properties"));
  }
}

TEST_CASE("every file in configs is accepted") {
  const Folder folder;
  for (const auto& [subfolder, kind] : {std::pair{"materials", "material"}, std::pair{"figures", "figure"},
                                        std::pair{"reports", "report"}, std::pair{"scenes", "scene"}}) {
    for (const auto& entry : fs::directory_iterator(folder.path() / "configs" / subfolder)) {
      if (entry.path().extension() != ".json") continue; // a height map
      const std::string file = "configs/" + std::string(subfolder) + "/" + entry.path().filename().string();
      const std::string out = check_output(folder, "brdfplot validate " + file);
      const bool advice =
          read_file(entry.path()).find("\"lights\"") != std::string::npos && kind == std::string("scene");
      CHECK(out == file + ": ok (" + (advice ? "advice" : kind) + ")\n");
    }
  }
}

TEST_CASE("every material in configs can be evaluated") {
  const Folder folder;
  for (const auto& entry : fs::directory_iterator(folder.path() / "configs" / "materials")) {
    const std::string file = "configs/materials/" + entry.path().filename().string();
    const std::string out =
        check_output(folder, "brdfplot eval " + file + " -q brdf,brdf_cos,albedo -i configs/points/pairs.csv");
    CHECK(std::ranges::count(out, '\n') == std::ranges::count(folder.read("configs/points/pairs.csv"), '\n'));
    CHECK(out.find("nan") == std::string::npos);
    CHECK(out.find("inf") == std::string::npos);
  }
}
