/// A material as JSON, with -m or without, wherever a file of one is taken.
#include "cli/program.hpp"

using namespace test;

namespace {

const std::string json = R"({"name": "own", "distribution": {"type": "ggx", "alpha": 0.5}})";

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

} // namespace

TEST_CASE("a material as JSON is what its file is, for every command that takes one") {
  const Folder folder;
  folder.write("own.json", json);
  folder.write("in.csv", "theta_o\n0.5\n");
  folder.write("other.json", R"({"name": "other", "distribution": {"type": "beckmann", "alpha": 0.5}})");
  for (const char* command :
       {"eval MATERIAL -q g1,d --grid theta_o=0:1:0.5 --grid theta_m=0.2", "sample MATERIAL -i in.csv -n 3",
        "check MATERIAL", "check MATERIAL --csv", "check --sampling -n 1000 MATERIAL", "fit MATERIAL --tolerance 1e-2",
        "bake MATERIAL --over cos_theta_o=0.1:1 --error 0.1 --json", "compare other.json MATERIAL",
        "compare MATERIAL other.json", "pareto MATERIAL lambda --no-times", "stress MATERIAL", "validate MATERIAL",
        "plot MATERIAL -q g1 -o -"}) {
    std::string with_file = "brdfplot " + std::string(command), with_flag = with_file, as_argument = with_file;
    replace_all(with_file, "MATERIAL", "own.json");
    replace_all(with_flag, "MATERIAL", "-m '" + json + "'");
    replace_all(as_argument, "MATERIAL", "'" + json + "'");
    Outcome expected = run(folder, with_file);
    replace_all(expected.out, "own.json", "-m"); // as what is wrong is told of it
    INFO(with_flag);
    for (const std::string& line : {with_flag, as_argument}) {
      const Outcome found = run(folder, line);
      CHECK(found.code == expected.code);
      CHECK(found.code == 0);
      CHECK(found.out == expected.out);
    }
  }
  check_output(folder, "brdfplot convert -m '" + json + "' -o a.binary");
  check_output(folder, "brdfplot convert own.json -o b.binary");
  CHECK(folder.read("a.binary") == folder.read("b.binary"));
}

TEST_CASE("a material as JSON that is wrong is told of as -m") {
  const Folder folder;
  check_error(folder, R"(brdfplot eval -m '{"distribution": {"type": "gxg"}}' -q g1)", 2,
              {"-m: /distribution", "\"gxg\"", "did you mean"});
  check_error(folder, R"(brdfplot fit -m '{"distribution": ')", 2, {"-m:1:", "unexpected end"});
  check_error(folder, R"(brdfplot check -m '{"panels": []}')", 2, {"-m: /: found a figure", "accepted: a material"});
  check_error(folder, "brdfplot eval -m missing.json -q g1", 3, {"missing.json: cannot read"});
}
