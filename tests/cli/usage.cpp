#include "cli/program.hpp"
#include "version.hpp"

using namespace test;

namespace {

const std::vector<std::string> commands = {"eval",     "plot",    "fit",  "pareto", "report",  "sample",
                                           "simulate", "convert", "list", "schema", "validate"};

/// The line below "Example:".
std::string example_of(const std::string& help) {
  const auto at = help.rfind("Example:\n  ");
  REQUIRE(at != std::string::npos);
  std::string line = help.substr(at + 11);
  while (line.ends_with('\n')) line.pop_back();
  return line;
}

} // namespace

TEST_CASE("version and help") {
  const Folder folder;
  const std::string version = "brdfplot " + std::string(brdfplot::version) + "\n";
  CHECK(check_output(folder, "brdfplot --version") == version);
  CHECK(check_output(folder, "brdfplot eval --version") == version);
  const std::string help = check_output(folder, "brdfplot --help");
  for (const auto& command : commands) {
    CHECK(help.find("\n  " + command + " ") != std::string::npos);
    const std::string own = check_output(folder, "brdfplot " + command + " --help");
    CHECK(own == check_output(folder, "brdfplot --help " + command));
    CHECK(own.find("brdfplot " + command) != std::string::npos);
  }
  for (const char* flag : {"--threads", "--quiet", "--progress", "--color", "--version", "--help"})
    CHECK(help.find(flag) != std::string::npos);
}

TEST_CASE("the help of a command says what it cannot do without") {
  const Folder folder;
  // "plot: needs FIGURE.json, or ..." and "eval: needs MATERIAL.json": the usage names it too.
  for (const auto& command : commands) {
    if (command == "pareto") continue; // needs nothing, and would measure every problem
    const Outcome bare = run(folder, "brdfplot " + command + " < /dev/null");
    const auto at = bare.err.find(command + ": needs ");
    const std::string help = check_output(folder, "brdfplot " + command + " -h");
    const auto first = help.find("Usage: brdfplot " + command + " ");
    REQUIRE(first != std::string::npos);
    const std::string usage = help.substr(first, help.find("\n\n", first) - first);
    INFO(usage);
    if (at == std::string::npos) continue; // nothing is needed, or a file that is there by default
    const std::string needs = bare.err.substr(at + command.size() + 8);
    INFO(needs);
    CHECK(usage.find(needs.substr(0, needs.find_first_of(",.:; "))) != std::string::npos);
  }
  for (const auto& [command, needed] :
       std::vector<std::pair<std::string, std::string>>{{"eval", "MATERIAL.json -q Q[,Q...] [OPTIONS]"},
                                                        {"plot", "-q Q[,Q...] -o DIR|FILE [OPTIONS]"},
                                                        {"bake", "(-o TABLE | --json)"},
                                                        {"report", "-o DIR"},
                                                        {"convert", "-o FILE.binary"}})
    CHECK(check_output(folder, "brdfplot help " + command).find(needed) != std::string::npos);
}

TEST_CASE("the example of every help works as printed") {
  const Folder folder;
  for (const auto& command : commands) {
    const std::string help = check_output(folder, "brdfplot " + command + " --help");
    const std::string example = example_of(help);
    INFO(example);
    CHECK(example.find('\n') == std::string::npos);
    CHECK(example.starts_with("brdfplot " + command));
    // The whole report of the paper is another test's.
    if (command != "report") CHECK(run(folder, example).code == 0);
  }
  CHECK(run(folder, example_of(check_output(folder, "brdfplot --help"))).code == 0);
}

TEST_CASE("what is misspelt names the nearest") {
  const Folder folder;
  check_error(folder, "brdfplot", 2,
              {"no command", "accepted: eval, plot, check, fit, report, sample, compare, bake, pareto, stress, advise, "
                             "simulate, convert, list, help, schema, validate"});
  check_error(folder, "brdfplot evla", 2, {"unknown command \"evla\"", "did you mean \"eval\"?", "accepted: eval"});
  check_error(folder, "brdfplot eval --toleranse 1", 2, {"\"--toleranse\"", "did you mean \"--tolerance\"?"});
  check_error(folder, "brdfplot eval --toleranse=1", 2, {"\"--toleranse\"", "did you mean \"--tolerance\"?"});
  check_error(folder, "brdfplot --thread 2 list", 2, {"\"--thread\"", "did you mean \"--threads\"?"});
  check_error(folder, "brdfplot list --thread 2", 2, {"\"--thread\"", "did you mean \"--threads\"?"});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q lamda", 2,
              {"-q: ", "\"lamda\"", "did you mean \"lambda\"?", "accepted: lambda, p22"});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q lambda,", 2, {"-q: ", "unknown quantity \"\""});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q d,g1,d", 2, {"-q: ", "\"d\"", "twice"});
  check_error(folder, "brdfplot schema materiel", 2, {"\"materiel\"", "did you mean \"material\"?"});
  check_error(folder, "brdfplot list fresnell", 2, {"\"fresnell\"", "did you mean \"fresnel\"?"});
}

TEST_CASE("the instruction set that BRDFPLOT_ISA asks for") {
  const Folder folder;
  const std::string eval =
      "brdfplot eval configs/materials/ggx.json -q lambda -i configs/points/theta_o.csv --precision single";
  CHECK(check_output(folder, "BRDFPLOT_ISA=baseline " + eval).starts_with("theta_o,lambda\n"));
  check_error(folder, "BRDFPLOT_ISA=sse9 " + eval, 2,
              {"BRDFPLOT_ISA: found \"sse9\"", "accepted on this machine: baseline"});
  check_error(folder, "BRDFPLOT_ISA= brdfplot list", 2, {"BRDFPLOT_ISA: found \"\""});
}

TEST_CASE("wrong values and numbers of arguments") {
  const Folder folder;
  for (const char* value : {"0", "-1", "x", "1.5", "99999999999"})
    check_error(folder, "brdfplot list --threads=" + std::string(value), 2, {"--threads: ", "a whole number >= 1"});
  check_error(folder, "brdfplot list --threads", 2, {"--threads: needs a value"});
  check_error(folder, "brdfplot list --threads 1 --threads 2", 2, {"--threads: is given more than once"});
  check_error(folder, "brdfplot list --color alway", 2, {"--color: ", "did you mean \"always\"?"});
  check_error(folder, "brdfplot list --progress sometimes", 2, {"--progress: ", "accepted: auto, always, never"});
  check_error(folder, "brdfplot eval", 2, {"eval: needs MATERIAL.json"});
  check_error(folder, "brdfplot eval configs/materials/ggx.json", 2, {"eval: needs -q"});
  check_error(folder, "brdfplot plot -o x", 2, {"plot: needs FIGURE.json"});
  check_error(folder, "brdfplot plot configs/figures/fig15_shear.json", 2, {"plot: needs -o DIR"});
  check_error(folder, "brdfplot report", 2, {"report: needs -o DIR"});
  check_error(folder, "brdfplot schema", 2, {"schema: needs KIND"});
  check_error(folder, "brdfplot schema material figure", 2, {"\"figure\"", "one argument too many for schema"});
  check_error(folder, "brdfplot validate", 2, {"validate: needs FILE"});
  for (const char* value : {"0", "-1", "nan", "inf", "x"})
    check_error(folder, "brdfplot eval configs/materials/ggx.json -q albedo --tolerance=" + std::string(value), 2,
                {"--tolerance: ", "a number > 0"});
  CHECK(folder.list().empty());
}

TEST_CASE("global flags stand before and after the command") {
  const Folder folder;
  const std::string rest = "eval configs/materials/ggx.json -q lambda -i configs/points/theta_o.csv";
  const std::string expected = check_output(folder, "brdfplot " + rest);
  CHECK_FALSE(expected.empty());
  for (const char* flags : {"--threads 1", "--threads=2", "--quiet", "--progress never", "--color always"}) {
    CHECK(check_output(folder, "brdfplot " + std::string(flags) + " " + rest) == expected);
    CHECK(check_output(folder, "brdfplot " + rest + " " + flags) == expected);
  }
  CHECK(check_output(folder, "brdfplot --quiet validate configs/materials/ggx.json") == "");
  CHECK(check_output(folder, "brdfplot validate configs/materials/ggx.json --quiet") == "");
}

TEST_CASE("an argument may be called like a command") {
  const Folder folder;
  check_output(folder, "brdfplot schema report");
  check_error(folder, "brdfplot validate eval", 3, {"eval: cannot read"});
}

TEST_CASE("colour where it is asked for") {
  const Folder folder;
  CHECK(run(folder, "brdfplot x").err.find('\x1b') == std::string::npos); // not a terminal
  CHECK(run(folder, "brdfplot --color never x").err.find('\x1b') == std::string::npos);
  const std::string coloured = run(folder, "brdfplot --color always x").err;
  CHECK(coloured.starts_with("brdfplot: \x1b["));
  CHECK(coloured.find("error:\x1b[0m command line: unknown command") != std::string::npos);
}

TEST_CASE("list: everything in short, a section or a name in full") {
  const Folder folder;
  const std::string all = check_output(folder, "brdfplot list");
  for (const char* word : {"beckmann", "ggx", "phong", "gtr", "smith_rational", "v_cavity", "height_correlated",
                           "conductor", "weak_furnace", "velvet_cloth", "bounces", "brdfplot list NAME"})
    CHECK(all.find(word) != std::string::npos);
  CHECK(all.find("a number in") == std::string::npos);
  for (const char* section : {"distributions", "masking", "shadowing", "fresnel", "terms", "quantities", "surfaces",
                              "measures", "profiles"}) {
    const std::string part = check_output(folder, "brdfplot list " + std::string(section));
    CHECK(all.find(part.substr(0, part.find('\n'))) != std::string::npos);
  }
  for (const auto& [name, words] :
       std::vector<std::pair<std::string, std::string>>{{"ggx", "a number in [1e-06, 1e+06]"},
                                                        {"schlick", "default 5"},
                                                        {"height_correlated", "Heitz 2014, Eq. 99; "},
                                                        {"albedo", "needs omega_o"}}) {
    const std::string one = check_output(folder, "brdfplot list " + name);
    CHECK_MESSAGE(one.find(words) != std::string::npos, one);
  }
  // One name, two models.
  const std::string both = check_output(folder, "brdfplot list kelemen");
  CHECK(both.find("Masking functions") != std::string::npos);
  CHECK(both.find("Terms of a BRDF") != std::string::npos);
  std::istringstream lines(all + check_output(folder, "brdfplot list terms"));
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
}

TEST_CASE("help and version in the words that people try") {
  const Folder folder;
  CHECK(check_output(folder, "brdfplot -V") == check_output(folder, "brdfplot --version"));
  CHECK(check_output(folder, "brdfplot help") == check_output(folder, "brdfplot --help"));
  CHECK(check_output(folder, "brdfplot help plot") == check_output(folder, "brdfplot plot --help"));
  check_error(folder, "brdfplot help plott", 2, {"\"plott\"", "did you mean \"plot\"?"});
  CHECK(run(folder, "brdfplot list | head -n 1").err.empty());
}

TEST_CASE("names as other programs have them") {
  const Folder folder;
  const auto error_of = [&](const std::string& material, const std::string& wanted) {
    folder.write("m.json", material);
    check_error(folder, "brdfplot validate m.json", 2, {"did you mean \"" + wanted + "\"?"});
  };
  error_of(R"({"distribution": {"type": "GGX", "alpha": 0.3}})", "ggx");
  error_of(R"({"distribution": {"type": "smith-ggx", "alpha": 0.3}})", "ggx");
  error_of(R"({"distribution": {"type": "ggx", "alphaX": 0.3, "alpha_y": 0.2}})", "alpha_x");
  error_of(R"({"distribution": {"type": "ggx", "alpha": 0.3}, "fresnel": {"type": "dielectric", "ior": 1.5}})", "eta");
  error_of(R"({"distribution": {"type": "Trowbridge-Reitz", "alpha": 0.3}})", "ggx");
}

TEST_CASE("files of the wrong kind, and headers without what is asked for") {
  const Folder folder;
  check_error(folder, "brdfplot eval configs/figures/felt.json -q g1 -i configs/points/theta_o.csv", 2,
              {"felt.json: /: found a figure (brdfplot plot), accepted: a material"});
  check_error(folder, "brdfplot plot configs/materials/ggx.json -o out", 2,
              {"found a material", "plot -q", "a figure"});
  check_error(folder, "brdfplot simulate configs/materials/ggx.json", 2, {"found a material", "accepted: a scene"});
  check_error(folder, "brdfplot report configs/scenes/gaussian.json -o out", 2, {"found a scene (brdfplot simulate)"});
  check_error(folder, "printf 'theta,angle\n1,2\n' | brdfplot eval configs/materials/ggx.json -q g1", 2,
              {"needs omega_o", "found: theta, angle"});
}

TEST_CASE("degrees without their unit are computed as radians, with a warning") {
  const Folder folder;
  const std::string eval = "brdfplot eval configs/materials/ggx.json -q g1";
  const Outcome plain = run(folder, "printf 'theta_o\n60\n61\n' | " + eval);
  CHECK(plain.code == 0);
  CHECK(plain.err == "brdfplot: warning: -:1: theta_o = 60 rad is more than a full circle; 60deg?\n");
  CHECK(run(folder, "printf 'theta_o\n60\n' | " + eval + " --quiet").err.empty());
  CHECK(run(folder, "printf 'theta_o\n60deg\n1.2\n' | " + eval).err.empty());
  CHECK(check_output(folder, "printf 'theta_o\n60°\n' | " + eval + " | tail -n 1 | cut -d, -f2") ==
        check_output(folder, "printf 'theta_o\n60deg\n' | " + eval + " | tail -n 1 | cut -d, -f2"));
  const Outcome figure = run(folder, "brdfplot plot configs/materials/ggx.json -q brdf --at theta_o=45 -o a.svg");
  CHECK(figure.code == 0);
  CHECK(figure.err.find("warning: plot: /panels/0/at/theta_o: theta_o = 45 rad is more than a full circle; 45deg?") !=
        std::string::npos);
}
