#include "cli/program.hpp"

#include <nlohmann/json.hpp>

using namespace test;

namespace {

void write_materials(const Folder& folder) {
  folder.write("right.json", R"({"distribution": {"type": "ggx", "alpha_x": 0.2, "alpha_y": 0.6},
    "masking": {"type": "custom", "lambda": "(sqrt(1 + alpha^2 * tan_theta^2) - 1) / 2"},
    "claims": ["physically_based", "stretch_invariance"]})");
  folder.write("wrong.json", R"({"distribution": {"type": "ggx", "alpha_x": 0.2, "alpha_y": 0.6},
    "masking": {"type": "custom", "lambda": "(sqrt(1 + alpha_x * alpha_y * tan_theta^2) - 1) / 2"},
    "claims": ["reciprocity", "physically_based"]})");
}

} // namespace

TEST_CASE("check: a claim that holds, and one that does not") {
  const Folder folder;
  write_materials(folder);
  const std::string good = check_output(folder, "brdfplot check right.json");
  CHECK(good.find("right: ggx (alpha_x 0.2; alpha_y 0.6), masking custom\n") == 0);
  CHECK(good.find("✓ Eq. 37") != std::string::npos);
  CHECK(good.find("✓ claimed: physically_based") != std::string::npos);
  CHECK(good.find("✗") == std::string::npos);
  const auto bad = run(folder, "brdfplot check right.json wrong.json");
  CHECK(bad.code == 1);
  CHECK(bad.err == "brdfplot: error: wrong.json: /claims/1: \"physically_based\" does not hold\n");
  CHECK(bad.out.find("✓ claimed: reciprocity\n  ✗ claimed: physically_based\n") != std::string::npos);
  CHECK(bad.out.find("theta_o = 89deg, phi_o = 90deg") != std::string::npos);
}

TEST_CASE("check: a masking function that is Smith's at another convention of roughness is told") {
  const Folder folder;
  const auto material = [&](const std::string& alpha) {
    return R"({"distribution": {"type": "ggx", "alpha": 0.3}, "masking": {"type": "custom",
      "lambda": "(sqrt(1 + )" +
           alpha + R"( * tan_theta^2) - 1) / 2"}})";
  };
  folder.write("right.json", material("alpha^2"));
  folder.write("squared.json", material("alpha^4"));
  folder.write("root.json", material("alpha"));
  folder.write("other.json", material("alpha^3"));
  const auto told = [&](const std::string& file) { return run(folder, "brdfplot check " + file).out; };
  CHECK(told("squared.json").find("  ! G1 is Smith's with alpha^2 in the place of alpha\n") != std::string::npos);
  CHECK(told("root.json").find("  ! G1 is Smith's with sqrt(alpha) in the place of alpha\n") != std::string::npos);
  CHECK(told("right.json").find("  !") == std::string::npos);
  CHECK(told("other.json").find("  !") == std::string::npos);
  const auto json = nlohmann::json::parse(run(folder, "brdfplot check root.json --json").out);
  CHECK(json["rows"][0]["mistake"] == "G1 is Smith's with sqrt(alpha) in the place of alpha");
}

TEST_CASE("check: what is of a microsurface does not apply to a BRDF that is a fit") {
  const Folder folder;
  const std::string text = check_output(folder, "brdfplot check configs/materials/oren_nayar.json");
  for (const char* title : {"Eq. 14", "Eq. 18", "Eq. 36", "Eq. 37", "D normalized", "G1 in [0, 1]", "G1 = 1 at normal"})
    CHECK(text.find("  - " + std::string(title)) != std::string::npos);
  CHECK(text.find("does not apply: the BRDF has no microsurface") != std::string::npos);
  CHECK(text.find("  ✓ reciprocal") != std::string::npos);
  CHECK(text.find("  ✗ energy <= 1         0.017") != std::string::npos);
  CHECK(text.find("  - physically based") != std::string::npos);
  const auto json =
      nlohmann::json::parse(check_output(folder, "brdfplot check --json configs/materials/oren_nayar.json"));
  CHECK(json["rows"][0]["eq14"]["verdict"] == "does not apply");
  CHECK(json["rows"][0]["physically_based"] == false);
  folder.write("m.json", R"({"distribution": {"type": "oren_nayar", "sigma": 0.5}, "masking": {"type": "v_cavity"},
    "facet": "oren_nayar", "claims": ["physically_based"]})");
  const Outcome claimed = run(folder, "brdfplot check m.json");
  CHECK(claimed.code == 1);
  CHECK(claimed.err == "brdfplot: error: m.json: /claims/0: \"physically_based\" does not apply\n");
}

TEST_CASE("check --json, --csv, --markdown, -o") {
  const Folder folder;
  write_materials(folder);
  const auto ran = run(folder, "brdfplot check wrong.json --json -o out.json");
  CHECK(ran.code == 1);
  CHECK(ran.out.empty());
  const auto json = nlohmann::json::parse(folder.read("out.json"));
  REQUIRE(json.at("rows").size() == 1);
  const auto& row = json["rows"][0];
  CHECK(row.at("file") == "wrong.json");
  CHECK(row.at("distribution") == "ggx");
  CHECK(row.at("masking") == "custom");
  for (const char* equation : {"eq14", "eq18", "eq36", "eq37"}) {
    CHECK(row.at(equation).at("holds") == false);
    CHECK(row.at(equation).at("verdict") == "fails");
    CHECK(row.at(equation).at("max_residual") > 0.1);
    CHECK(row.at(equation).at("error") < 1e-7);
  }
  CHECK(row.at("physically_based") == false);
  CHECK(row.at("claims").at("reciprocity") == "holds");
  CHECK(row.at("claims").at("physically_based") == "fails");

  const auto table = cells(run(folder, "brdfplot check right.json wrong.json --csv").out);
  REQUIRE(table.size() == 3);
  CHECK(table[0][0] == "material");
  CHECK(table[1][0] == "right");
  CHECK(table[0][4] == "eq14_holds");
  CHECK(table[1][4] == "true");
  CHECK(table[2][4] == "false");
  const std::string markdown = run(folder, "brdfplot check wrong.json --markdown").out;
  CHECK(markdown.find("| wrong | custom | ggx (alpha_x 0.2; alpha_y 0.6) | ✗ ") != std::string::npos);
}

TEST_CASE("check: what cannot be told at a tolerance is exit code 4 when it is claimed") {
  const Folder folder;
  folder.write("m.json", R"({"distribution": {"type": "beckmann", "alpha": 0.5}, "claims": ["eq36"]})");
  const auto ran = run(folder, "brdfplot check m.json --tolerance 1e-17");
  CHECK(ran.code == 4);
  CHECK(ran.err == "brdfplot: error: m.json: /claims/0: \"eq36\" cannot be told at a tolerance of 1e-17\n");
  CHECK(ran.out.find("? Eq. 36") != std::string::npos);
  CHECK(run(folder, "brdfplot check m.json").code == 0);
}

TEST_CASE("check: the last guard, what is no number is told, is exit code 4, and no cell shows it") {
  const Folder folder;
  folder.write("m.json", R"({"distribution": {"type": "ggx", "alpha": 0.5},
    "masking": {"type": "custom", "lambda": "abs(theta - 50 / 180 * 3.141592653589793) < 1e-9 ? -1 : 0"}})");
  for (const char* form : {"", " --csv", " --markdown", " --json"}) {
    const auto ran = run(folder, "brdfplot check m.json" + std::string(form));
    CHECK(ran.code == 4);
    CHECK(ran.err.find("brdfplot: error: m.json: \"g1_range\": found inf, accepted: a finite residual\n") !=
          std::string::npos);
    for (const char* word : {"nan", "inf"}) CHECK(ran.out.find(word) == std::string::npos);
  }
}

TEST_CASE("check: a BRDF whose integral has no end is told at once") {
  const Folder folder;
  folder.write("m.json", R"({"facet": "diffuse", "distribution": {"type": "oren_nayar", "sigma": 0.4},
    "masking": {"type": "kelemen"}})");
  const auto ran = run(folder, "brdfplot check m.json");
  CHECK(ran.code == 4);
  CHECK(ran.err.find("\"eq37\": found inf, accepted: a finite residual\n") != std::string::npos);
  CHECK(ran.out.find("the error is inf at theta_o") != std::string::npos);
}

TEST_CASE("check: usage") {
  const Folder folder;
  write_materials(folder);
  check_error(folder, "brdfplot check nope.json", 3, {"nope.json: cannot read: "});
  check_error(folder, "brdfplot check right.json --json --csv", 2, {"accepted: one of --json, --csv, --markdown"});
  check_error(folder, "brdfplot check right.json --tolerance 0", 2, {"--tolerance: found \"0\""});
  const std::string plain = check_output(folder, "brdfplot check right.json --threads 1");
  CHECK(plain.find('\x1b') == std::string::npos);
  CHECK(check_output(folder, "brdfplot check right.json --threads 5") == plain);
  CHECK(check_output(folder, "brdfplot check right.json --color always").find("\x1b[32m✓\x1b[0m") != std::string::npos);
}
