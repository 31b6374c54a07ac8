#include "cli/program.hpp"

using namespace test;

namespace {

/// Some hundred thousand rays on a small surface; `rays` of them for every direction.
std::string scene(const std::string& rays = "2e4") {
  return R"({"surface": {"type": "gaussian", "alpha": 0.6, "samples": 64, "correlation_length": 4},
  "measures": [{"type": "g1", "theta_o": ["30deg", "75deg"], "rays": )" +
         rays + R"(}, {"type": "bounces", "theta_o": 1.3, "bounces": 4, "rays": )" + rays + "}]}";
}

} // namespace

TEST_CASE("every scene in configs can be simulated") {
  const Folder folder;
  for (const auto& entry : fs::directory_iterator(folder.path() / "configs" / "scenes")) {
    if (entry.path().extension() != ".json") continue;
    if (read_file(entry.path()).find("\"surface\"") == std::string::npos) continue; // for advise
    const std::string file = "configs/scenes/" + entry.path().filename().string();
    const std::string out = check_output(folder, "brdfplot simulate " + file);
    CHECK(out.starts_with("# surface\n\n| realisation | alpha_x "));
    CHECK(out.find("nan") == std::string::npos);
    CHECK(out.find("Partial") == std::string::npos);
  }
}

TEST_CASE("a scene becomes tables and CSV, with standard errors") {
  const Folder folder;
  folder.write("s.json", scene());
  CHECK(check_output(folder, "brdfplot simulate s.json -o out/deep") == "");
  CHECK(folder.list("out/deep") ==
        std::vector<std::string>{"bounces.csv", "bounces.md", "g1.csv", "g1.md", "surface.csv", "surface.md"});
  const std::string csv = folder.read("out/deep/g1.csv");
  CHECK(csv.starts_with("theta_o,phi_o,g1,g1_stderr,g1_by_area,g1_by_area_stderr,projected_area,"
                        "projected_area_stderr,smith\n0.5235987755982988,0,"));
  CHECK(std::ranges::count(csv, '\n') == 3);
  CHECK(number(csv, 1, 2) < number(csv, 1, 8));
  CHECK(number(csv, 1, 3) > 0);
  CHECK(folder.read("out/deep/g1.md").find(" ± ") != std::string::npos);
  CHECK(check_output(folder, "brdfplot simulate s.json").find(folder.read("out/deep/g1.md")) != std::string::npos);
}

TEST_CASE("simulations are the same bytes on any number of threads") {
  const Folder folder;
  folder.write("s.json", scene());
  for (const char* threads : {"1", "2", "7"})
    check_output(folder, "brdfplot simulate s.json -o out" + std::string(threads) + " --threads " + threads);
  for (const auto& name : folder.list("out1")) {
    CHECK(folder.read("out1/" + name) == folder.read("out2/" + name));
    CHECK(folder.read("out1/" + name) == folder.read("out7/" + name));
  }
}

TEST_CASE("progress of a simulation, with the rates of rays at its end") {
  const Folder folder;
  folder.write("s.json", scene());
  const Outcome outcome = run(folder, "brdfplot simulate s.json --progress always");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.find("1536/1536, ") != std::string::npos); // 8 surfaces of 64 tiles, three directions
  CHECK(outcome.err.find("\ncoherent rays: 0.") != std::string::npos);
  CHECK(std::ranges::count(outcome.err, '\n') <= 102);
}

TEST_CASE("Ctrl-C ends a simulation with what was traced, marked as such") {
  const Folder folder;
  fs::create_directory(folder.path() / "out");
  folder.write("out/g1.csv", "as it was");
  folder.write("s.json", scene("3e8"));
  Process process(folder, "exec brdfplot simulate s.json -o out --progress always");
  wait_for([&] { return folder.read(".err").find("left") != std::string::npos; });
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(outcome.code == 130);
  CHECK(folder.read("out/g1.csv") == "as it was");
  CHECK(folder.read("out/g1.partial.md").find("Partial: stopped after ") != std::string::npos);
  const std::string csv = folder.read("out/g1.partial.csv");
  CHECK(csv.starts_with("theta_o,"));
  CHECK(number(csv, 0, 2) > 0.9);
}

TEST_CASE("scenes that are wrong") {
  const Folder folder;
  check_error(folder, "brdfplot simulate", 2, {"simulate: needs SCENE.json"});
  check_error(folder, "brdfplot simulate gone.json", 3, {"gone.json: cannot read"});
  folder.write("map.json", R"({"surface": {"type": "height_map", "file": "gone.png", "height": 1},
    "measures": [{"type": "g1", "theta_o": 1}]})");
  check_error(folder, "brdfplot simulate map.json", 3, {"gone.png: cannot read"});
  folder.write("map.json", R"({"surface": {"type": "height_map", "file": "map.json", "height": 1},
    "measures": [{"type": "g1", "theta_o": 1}]})");
  check_error(folder, "brdfplot simulate map.json", 2, {"map.json: is neither a PNG nor a PFM"});
}
