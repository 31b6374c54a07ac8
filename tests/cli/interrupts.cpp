/// Ctrl-C is answered within a second, whatever a command is at.
#include "cli/program.hpp"

#include <sys/stat.h>

using namespace test;

namespace {

/// Interrupted after half a second of work for much longer.
void check_interrupted(const Folder& folder, const std::string& command) {
  INFO(command);
  Process process(folder, "exec brdfplot " + command);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const auto began = std::chrono::steady_clock::now();
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::milliseconds(sanitized ? 15000 : 1500));
  CHECK(outcome.code == 130);
  CHECK(outcome.err == "brdfplot: error: interrupted\n");
}

std::string values(int count) {
  std::string out;
  for (int k = 0; k < count; ++k) out += (k > 0 ? "," : "") + std::to_string(0.1 + 0.001 * k);
  return out;
}

/// Of seconds of work.
std::string figure(const std::string& quantity, const std::string& distribution) {
  return R"({"id": "f", "kind": "lines", "title": "T", "caption": "C", "columns": 8,
    "x": {"variable": "theta_o", "from": 0, "to": 1.5}, "material": {"distribution": {"type": ")" +
         distribution + R"(", "alpha": 0.5}},
    "panels": [{"title": "{alpha}", "series": [{"label": "{alpha}", "quantity": ")" +
         quantity + R"("}], "for_each": {"variable": "alpha", "values": [)" + values(1000) + "]}}]}";
}

std::string scene(const std::string& surface) {
  return R"({"surface": {)" + surface + R"(}, "measures": [{"type": "g1", "theta_o": ["60deg"], "rays": 1e10}]})";
}

} // namespace

TEST_CASE("figures and reports, interrupted") {
  const Folder folder;
  folder.write("albedo.json", figure("albedo", "phong"));
  folder.write("g1.json", figure("g1", "ward"));
  check_interrupted(folder, "plot albedo.json -o out --cache ''");
  check_interrupted(folder, "plot g1.json -o out --cache ''");
  check_interrupted(folder, "report -o out --cache ''");
}

TEST_CASE("checks and fits, interrupted") {
  const Folder folder;
  check_interrupted(folder, "check");
  check_interrupted(folder, "fit configs/materials/student_t.json --tolerance 1e-6");
}

TEST_CASE("integrals of many rows, interrupted") {
  const Folder folder;
  std::string rows = "theta_o\n";
  for (int k = 0; k < 200000; ++k) rows += std::to_string(1e-6 * k) + "\n";
  folder.write("rows.csv", rows);
  check_interrupted(folder, "eval configs/materials/ggx.json -q albedo -i rows.csv -o out.csv");
  CHECK(folder.list() == std::vector<std::string>{"rows.csv"});
}

TEST_CASE("a surface that is being made, and rays on one, interrupted") {
  const Folder folder;
  folder.write("large.json", scene(R"("type": "ggx", "alpha": 0.5, "samples": 2048)"));
  check_interrupted(folder, "simulate large.json");
  folder.write("small.json", scene(R"("type": "gaussian", "alpha": 0.5, "samples": 64)"));
  Process process(folder, "exec brdfplot simulate small.json -o out");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  process.signal(SIGINT);
  CHECK(process.wait().code == 130);
}

TEST_CASE("reading what never ends, interrupted") {
  const Folder folder;
  REQUIRE(mkfifo((folder.path() / "pipe.json").c_str(), 0600) == 0);
  check_interrupted(folder, "validate pipe.json 0<>pipe.json");
}
