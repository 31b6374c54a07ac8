#include "cli/program.hpp"

#include <sys/stat.h>

using namespace test;

namespace {

const std::string eval = "brdfplot eval configs/materials/rough_gold.json ";

/// 40 000 rows in 1.6 MB: seven blocks of closed forms.
std::string many_rows() {
  std::string csv = "id,theta_o,phi_o,theta_i,phi_i\n";
  unsigned state = 1;
  const auto next = [&](unsigned range) { return std::to_string((state = state * 1664525U + 1013904223U) % range); };
  for (int row = 0; row < 40000; ++row)
    csv += "row " + std::to_string(row) + ",0." + next(1000000) + ",1." + next(1000000) + ",0." + next(1000000) + "," +
           next(6) + "." + next(100000) + "\n";
  return csv;
}

} // namespace

TEST_CASE("the number of threads changes no byte") {
  const Folder folder;
  folder.write("in.csv", many_rows());
  const std::string closed = eval + "-q brdf,g2,lambda -i in.csv -o out.csv --threads ";
  check_output(folder, closed + "1");
  const std::string one = folder.read("out.csv");
  CHECK(std::ranges::count(one, '\n') == 40001);
  for (const char* threads : {"2", "7"}) {
    check_output(folder, closed + threads);
    CHECK(folder.read("out.csv") == one);
  }
  CHECK(check_output(folder, "cat in.csv | " + eval + "-q brdf,g2,lambda --threads 3") == one);
}

TEST_CASE("quantities asked for together have the values of each asked for alone") {
  const Folder folder;
  folder.write("in.csv", "theta_o,theta_i,phi_i,theta_m\n0.3,0.4,2,0.1\n1.2,1.5,0,0.3\n0,0,0,0\n1.5,1.6,1,0\n");
  // g1 is that of the normal, g2 and the BRDF are those of the half vector.
  const std::vector<std::string> names = {"g1", "g2", "brdf", "fresnel", "brdf_cos", "d"};
  const auto ask = [&](const std::string& list) {
    return cells(check_output(folder, eval + "-q " + list + " -i in.csv"));
  };
  const auto together = ask("g1,g2,brdf,fresnel,brdf_cos,d");
  std::size_t column = 4;
  for (const std::string& name : names) {
    const auto alone = ask(name);
    REQUIRE(alone.size() == together.size());
    for (std::size_t k = 4; k < alone[0].size(); ++k, ++column)
      for (std::size_t row = 0; row < alone.size(); ++row) CHECK(together[row][column] == alone[row][k]);
  }
  CHECK(column == together[0].size());
}

TEST_CASE("the number of threads changes no byte of integrals") {
  const Folder folder;
  const std::string some = many_rows().substr(0, 4200);
  folder.write("in.csv", some.substr(0, some.rfind('\n') + 1));
  const std::string integrals =
      "brdfplot eval configs/materials/ggx.json -q visible_norm,g1,albedo -i in.csv --threads ";
  const std::string one = check_output(folder, integrals + "1");
  CHECK(std::ranges::count(one, '\n') > 100);
  for (const char* threads : {"2", "7"}) CHECK(check_output(folder, integrals + threads) == one);
}

TEST_CASE("rows do not depend on their neighbours") {
  const Folder folder;
  folder.write("in.csv", "theta_o\n0.3\n0.3\n0.7\n0.3\n");
  const auto rows = cells(check_output(folder, "brdfplot eval configs/materials/ggx.json -q albedo,lambda -i in.csv"));
  CHECK(rows.at(1) == rows.at(2));
  CHECK(rows.at(1) == rows.at(4));
  CHECK(rows.at(1) != rows.at(3));
}

TEST_CASE("memory does not grow with the rows") {
  const Folder folder;
  const auto kilobytes = [&](const std::string& rows) {
    const Outcome outcome =
        run(folder, "{ echo theta_o,theta_i; yes 0.3,0.4 | head -n " + rows + "; } | " + eval + "-q brdf > out.csv");
    CHECK(outcome.code == 0);
    return outcome.kilobytes;
  };
  const long few = kilobytes("100000");
  const long many = kilobytes("2000000");
  CHECK(std::ranges::count(folder.read("out.csv"), '\n') == 2000001);
  MESSAGE(few << " kB for 1e5 rows, " << many << " kB for 2e6");
  if (sanitized) return; // a sanitizer keeps what is freed for a while
  CHECK(many - few < 20 * 1024);
  CHECK(many < 100 * 1024);
}

TEST_CASE("a reader of stdout that goes away ends every command without a word") {
  const Folder folder;
  folder.write("in.csv", many_rows());
  const Outcome outcome = run(folder, "{ " + eval + "-q brdf -i in.csv; echo $? > code; } | head -n 1");
  CHECK(std::ranges::count(outcome.out, '\n') == 1);
  CHECK(outcome.err == "");
  CHECK(folder.read("code") == "0\n");

  folder.write("few.csv", "theta_o,theta_i\n0.3,0.4\n");
  folder.write("o.csv", "theta_o,phi_o\n0.3,0\n");
  folder.write("m.json", R"({"distribution": {"type": "ggx", "alpha": 0.5}, "masking": {"type": "kelemen"},
    "claims": ["eq36"]})");
  const std::string gold = "configs/materials/rough_gold.json";
  // Nobody reads before the first byte is written: the reader ends at once.
  for (const auto& [command, code] :
       std::vector<std::pair<std::string, int>>{{eval + "-q brdf -i few.csv", 0},
                                                {"eval " + gold + " -q g1 --grid theta_o=0:80deg:20deg", 0},
                                                {"sample " + gold + " -i o.csv -n 3", 0},
                                                {"check " + gold + " --tolerance 1e-3", 0},
                                                {"check m.json --tolerance 1e-3", 1},
                                                {"plot " + gold + " -q g1 -o -", 0},
                                                {"list ggx", 0},
                                                {"schema report", 0},
                                                {"validate " + gold, 0},
                                                {"help plot", 0},
                                                {"--version", 0}}) {
    const std::string all = command.starts_with("brdfplot") ? command : "brdfplot " + command;
    INFO(all);
    const Outcome gone = run(folder, "{ sleep 0.1; " + all + " < few.csv; echo $? > code; } | true");
    CHECK(gone.err == (code == 1 ? "brdfplot: error: m.json: /claims/0: \"eq36\" does not hold\n" : ""));
    CHECK(folder.read("code") == std::to_string(code) + "\n");
  }
  // A pipe that is not stdout is a file that could not be written.
  REQUIRE(mkfifo((folder.path() / "fifo").c_str(), 0600) == 0);
  const Outcome file = run(folder, "true < fifo & " + eval + "-q brdf -i in.csv -o fifo");
  CHECK(file.code == 3);
  CHECK(file.err == "brdfplot: error: fifo: cannot write: Broken pipe\n");
}

TEST_CASE("a full disk is an error") {
  const Folder folder;
  for (const char* command :
       {"brdfplot eval configs/materials/ggx.json -q g1 -i configs/points/theta_o.csv > /dev/full",
        "brdfplot list > /dev/full", "brdfplot schema figure > /dev/full", "brdfplot --help > /dev/full",
        "brdfplot --version > /dev/full", "brdfplot validate configs/materials/ggx.json > /dev/full"})
    check_error(folder, command, 3, {"-: cannot write: No space left on device"});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q g1 -i configs/points/theta_o.csv -o /dev/full", 3,
              {"/dev/full: cannot write: No space left on device"});
}

TEST_CASE("closed standard streams") {
  const Folder folder;
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q g1 <&-", 3, {"-: cannot read: "});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q g1 -i configs/points/theta_o.csv >&-", 3,
              {"-: cannot write: "});
  // Without stderr there is nobody to tell; what is written may not go astray.
  folder.write("in.csv", "theta_o\nx\n");
  const Outcome outcome = run(folder, "brdfplot eval configs/materials/ggx.json -q g1 -i in.csv -o out.csv 2>&-");
  CHECK(outcome.code == 2);
  CHECK(folder.list() == std::vector<std::string>{"in.csv"});
  CHECK(folder.read("in.csv") == "theta_o\nx\n");
}

TEST_CASE("Ctrl-C while waiting for rows") {
  const Folder folder;
  folder.write("out.csv", "as it was");
  for (const int number : {SIGINT, SIGTERM}) {
    Process process(folder, "exec brdfplot eval configs/materials/ggx.json -q g1 -o out.csv");
    process.type("theta_o\n0.1\n");
    wait_for([&] { return folder.list().size() == 2; }); // out.csv and the temporary file
    process.signal(number);
    const Outcome outcome = process.wait();
    CHECK(outcome.code == 130);
    CHECK(outcome.err == "brdfplot: error: interrupted\n");
  }
  CHECK(folder.list() == std::vector<std::string>{"out.csv"});
  CHECK(folder.read("out.csv") == "as it was");
}

TEST_CASE("Ctrl-C in the middle of integrals") {
  const Folder folder;
  folder.write("in.csv", many_rows());
  for (const char* threads : {"1", "4"}) {
    Process process(folder, "exec brdfplot --threads " + std::string(threads) +
                                " eval configs/materials/rough_gold.json -q albedo -i in.csv -o out.csv");
    wait_for([&] { return folder.list().size() == 2; });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    process.signal(SIGINT);
    CHECK(process.wait().code == 130);
    CHECK(folder.list() == std::vector<std::string>{"in.csv"});
  }
}

TEST_CASE("Ctrl-C while nobody reads what is written") {
  const Folder folder;
  folder.write("in.csv", many_rows());
  const std::string fifo = (folder.path() / "fifo").string();
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  const int reader = open(fifo.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  REQUIRE(reader >= 0);
  Process process(folder, "exec brdfplot eval configs/materials/ggx.json -q g1 -i in.csv > fifo");
  std::this_thread::sleep_for(std::chrono::milliseconds(500)); // the pipe is full now
  process.signal(SIGINT);
  CHECK(process.wait().code == 130);
  close(reader);
}
