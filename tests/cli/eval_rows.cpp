#include "cli/program.hpp"

using namespace test;

namespace {

/// What `eval` of the GGX of roughness 1 makes of a CSV.
Outcome eval(const Folder& folder, const std::string& csv, const std::string& quantities) {
  folder.write("ggx.json", R"({"distribution": {"type": "ggx", "alpha": 1}})");
  folder.write("in.csv", csv);
  return run(folder, "brdfplot eval ggx.json -q " + quantities + " -i in.csv");
}

void check_rows(const std::string& csv, const std::string& quantities, const std::string& expected) {
  const Folder folder;
  const Outcome outcome = eval(folder, csv, quantities);
  INFO(csv);
  CHECK(outcome.code == 0);
  CHECK(outcome.err == "");
  CHECK(outcome.out == expected);
}

/// Every row above the wrong one is written, the rest is not.
void check_row_error(const std::string& csv, const std::string& quantities, const std::vector<std::string>& parts,
                     const std::string& written_before = "") {
  const Folder folder;
  const Outcome outcome = eval(folder, csv, quantities);
  INFO(csv);
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK(outcome.out == written_before);
  for (const auto& part : parts) CHECK(outcome.err.find(part) != std::string::npos);
}

} // namespace

TEST_CASE("input columns stay as they are, quantities follow in their order") {
  check_rows("theta_o\n0\n", "lambda,g1", "theta_o,lambda,g1\n0,0,1\n");
  check_rows("id,theta_o,note\n7, 0.0 ,x\n8,0e5,\n", "g1,lambda",
             "id,theta_o,note,g1,lambda\n7, 0.0 ,x,1,0\n8,0e5,,1,0\n");
  check_rows("phi_o,theta_o\n3,0\n", "g1", "phi_o,theta_o,g1\n3,0,1\n");
  check_rows("x_o,z_o,y_o\n0,0.001,0\n", "g1", "x_o,z_o,y_o,g1\n0,0.001,0,1\n");
  check_rows("theta_o\n0deg\n0rad\n+0\n-0\n", "g1", "theta_o,g1\n0deg,1\n0rad,1\n+0,1\n-0,1\n");
}

TEST_CASE("line ends, marks, blank lines and quotes") {
  const std::string expected = "theta_o,a,lambda\n0,x,0\n0,y,0\n";
  check_rows("theta_o,a\r\n0,x\r\n0,y\r\n", "lambda", expected);
  check_rows("theta_o,a\n0,x\n0,y", "lambda", expected);
  check_rows("theta_o,a\r\n0,x\r\n0,y\r", "lambda", expected);
  check_rows("\xEF\xBB\xBFtheta_o,a\n0,x\n0,y\n", "lambda", expected);
  check_rows("\n\ntheta_o,a\n\n0,x\n \n\r\n0,y\n\n\n", "lambda", expected);
  check_rows("\"theta_o\",\"a \"\"b\"\",c\"\n\"0\",\"1,\n2\"\n0,\"\"\n", "lambda",
             "\"theta_o\",\"a \"\"b\"\",c\",lambda\n\"0\",\"1,\n2\",0\n0,\"\",0\n");
  check_rows("theta_o,a\n0,\n0,", "lambda", "theta_o,a,lambda\n0,,0\n0,,0\n");
  check_rows("theta_o,a\n0,5\" pipe\n0,y\n", "lambda", "theta_o,a,lambda\n0,5\" pipe,0\n0,y,0\n");
}

TEST_CASE("a header alone is no rows") {
  check_rows("theta_o\n", "lambda", "theta_o,lambda\n");
  check_rows("theta_o", "lambda", "theta_o,lambda\n");
  check_rows("theta_o\n\n \n", "albedo", "theta_o,albedo\n");
  check_row_error("", "lambda", {"in.csv:1: ", "no header"});
  check_row_error("\xEF\xBB\xBF", "lambda", {"in.csv:1: ", "no header"});
  check_row_error("\n\n", "lambda", {"no header"});
}

TEST_CASE("rows that are no directions") {
  const std::string header = "theta_o,phi_o,lambda\n";
  for (const char* value : {"nan", "inf", "-inf", "abc", "", "1e999", "12grad", "deg", "0x10", "1 2", "1;5"})
    check_row_error("theta_o,phi_o\n0,0\n" + std::string(value) + ",0\n0,0\n", "lambda",
                    {"in.csv:3: ", "column \"theta_o\"", "found \"" + std::string(value) + "\"", "accepted: a finite"},
                    header + "0,0,0\n");
  check_row_error("theta_o,phi_o\n0\n", "lambda", {"in.csv:2: ", "found 1 field, the header has 2"}, header);
  check_row_error("theta_o,phi_o\n0,0,0\n", "lambda", {"in.csv:2: ", "found 3 fields, the header has 2"}, header);
  check_row_error("theta_o,phi_o\n0,\"0\n", "lambda", {"in.csv:2: ", "a quote is not closed"}, header);
  check_row_error("x_o,y_o,z_o\n0,-0,0\n", "lambda", {"in.csv:2: ", "(x_o, y_o, z_o) is the zero vector"},
                  "x_o,y_o,z_o,lambda\n");
  check_row_error("x_o,y_o,z_o\n0,0,80deg\n", "lambda", {"in.csv:2: ", "\"z_o\"", "found \"80deg\""},
                  "x_o,y_o,z_o,lambda\n");
}

TEST_CASE("lines are counted as an editor counts them") {
  check_row_error("\n\"a\nb\",theta_o\r\n\n\"x\ny\",0\n1,x\n", "lambda", {"in.csv:7: ", "found \"x\""},
                  "\"a\nb\",theta_o,lambda\n\"x\ny\",0,0\n");
}

TEST_CASE("the first wrong row counts, wherever the blocks end") {
  const Folder folder;
  std::string csv = "theta_o\n";
  for (int row = 0; row < 200000; ++row) csv += row == 150000 ? "first\n" : row == 190000 ? "second\n" : "0.5\n";
  for (const char* threads : {"1", "2", "7"}) {
    folder.write("in.csv", csv);
    const Outcome outcome = run(folder, "brdfplot --threads " + std::string(threads) +
                                            " eval configs/materials/ggx.json -q lambda -i in.csv");
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("in.csv:150002: ") != std::string::npos);
    CHECK(std::ranges::count(outcome.out, '\n') == 150001);
  }
}

TEST_CASE("headers that do not do") {
  check_row_error("theta_o,theta_o\n", "lambda", {"in.csv:1: ", "column \"theta_o\" is there twice"});
  check_row_error("theta_o,a,a\n", "lambda", {"in.csv:1: ", "\"a\" is there twice"});
  check_row_error("theta_o,x_o,y_o,z_o\n", "lambda", {"in.csv:1: ", "\"theta_o\" and \"x_o\""});
  check_row_error("phi_o\n", "lambda", {"in.csv:1: ", "\"phi_o\" without \"theta_o\""});
  check_row_error("x_o,z_o\n", "lambda", {"in.csv:1: ", "\"y_o\" is missing"});
  check_row_error("theta_o,lambda\n", "lambda", {"in.csv:1: ", "column \"lambda\" is there already"});
  check_row_error("theta_o\n0\n", "lambda,brdf", {"in.csv:1: ", "\"brdf\" needs omega_i"});
  check_row_error("theta_i\n0\n", "brdf", {"in.csv:1: ", "\"brdf\" needs omega_o"});
  check_row_error("theta_i\n0\n", "albedo", {"in.csv:1: ", "\"albedo\" needs omega_o"});
  check_row_error("theta_o\n0\n", "d", {"in.csv:1: ", "\"d\" needs omega_m"});
  check_row_error("\n\nTheta_o\n0\n", "lambda", {"in.csv:3: ", "\"lambda\" needs omega_o"});
}

TEST_CASE("standard input and output") {
  const Folder folder;
  const std::string expected = "theta_o,g1\n0,1\n";
  const std::string eval = "brdfplot eval configs/materials/ggx.json -q g1";
  CHECK(check_output(folder, "printf 'theta_o\\n0\\n' | " + eval) == expected);
  CHECK(check_output(folder, "printf 'theta_o\\n0\\n' | " + eval + " -i - -o -") == expected);
  CHECK(check_output(folder, "printf 'theta_o\\n0\\n' | " + eval + " -o out.csv") == "");
  CHECK(folder.read("out.csv") == expected);
  const Outcome wrong = run(folder, "printf 'theta_o\\nx\\n' | " + eval);
  CHECK(wrong.err.starts_with("brdfplot: error: -:2: "));
}

TEST_CASE("results come as the rows do") {
  const Folder folder;
  for (const char* quantity : {"g1", "visible_norm"}) {
    Process process(folder, "exec brdfplot --threads 3 eval configs/materials/ggx.json -q " + std::string(quantity));
    process.type("theta_o\n0\n");
    wait_for([&] { return std::ranges::count(folder.read(".out"), '\n') == 2; });
    process.type("0\n0");
    wait_for([&] { return std::ranges::count(folder.read(".out"), '\n') == 3; });
    // A row that is wrong is told at once, though another thread waits for more.
    process.type("x\n");
    const Outcome outcome = process.wait();
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("-:4: ") != std::string::npos);
  }
}
