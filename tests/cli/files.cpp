#include "cli/program.hpp"

#include <sys/stat.h>

using namespace test;

namespace {

const std::string eval = "brdfplot eval configs/materials/ggx.json -q g1 -i configs/points/theta_o.csv ";

} // namespace

TEST_CASE("files that cannot be read") {
  const Folder folder;
  fs::create_directory(folder.path() / "dir");
  check_error(folder, "brdfplot eval nope.json -q d", 3, {"nope.json: cannot read: No such file or directory"});
  check_error(folder, "brdfplot eval dir -q d", 3, {"dir: cannot read: Is a directory"});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q d -i nope.csv", 3,
              {"nope.csv: cannot read: No such file or directory"});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q d -i dir", 3, {"dir: cannot read: Is a directory"});
  check_error(folder, "brdfplot plot nope.json -o out", 3, {"nope.json: cannot read: "});
  check_error(folder, "brdfplot report nope.json -o out", 3, {"nope.json: cannot read: "});
  check_error(folder, "brdfplot validate nope.json", 3, {"nope.json: cannot read: "});
  check_error(folder, "brdfplot validate dir", 3, {"dir: cannot read: Is a directory"});
  CHECK(folder.list() == std::vector<std::string>{"dir"});
}

TEST_CASE("files that cannot be written") {
  const Folder folder;
  fs::create_directory(folder.path() / "dir");
  folder.write("file", "as it was");
  check_error(folder, eval + "-o dir", 3, {"dir: cannot write: Is a directory"});
  check_error(folder, eval + "-o file/out.csv", 3, {"file/out.csv: cannot write: Not a directory"});
  check_error(folder, eval + "-o nope/out.csv", 3, {"nope/out.csv: cannot write: No such file or directory"});
  check_error(folder, eval + "-o /proc/out.csv", 3, {"/proc/out.csv: cannot write: "});
  check_error(folder, "brdfplot plot configs/figures/fig15_shear.json -o file", 3, {"file: "});
  check_error(folder, "brdfplot plot configs/figures/fig15_shear.json -o file/x", 3, {"file/x: "});
  check_error(folder, "brdfplot report -o file", 3, {"file: "});
  CHECK(folder.list() == std::vector<std::string>{"dir", "file"});
  CHECK(folder.read("file") == "as it was");
  CHECK(folder.list("dir").empty());
}

TEST_CASE("a failure leaves the old output as it was") {
  const Folder folder;
  folder.write("out.csv", "as it was");
  folder.write("in.csv", "theta_o\n0\n0.5\nx\n");
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q g1 -i in.csv -o out.csv", 2, {"in.csv:4: "});
  CHECK(folder.read("out.csv") == "as it was");
  CHECK(folder.list() == std::vector<std::string>{"in.csv", "out.csv"});
}

TEST_CASE("an output replaces what was there") {
  const Folder folder;
  const std::string expected = check_output(folder, eval);
  folder.write("out.csv", std::string(100000, 'x'));
  check_output(folder, eval + "-o out.csv");
  CHECK(folder.read("out.csv") == expected);
  SUBCASE("through a link") {
    fs::create_symlink("out.csv", folder.path() / "link.csv");
    folder.write("out.csv", "old");
    check_output(folder, eval + "-o link.csv");
    CHECK(fs::is_symlink(folder.path() / "link.csv"));
    CHECK(folder.read("out.csv") == expected);
  }
  SUBCASE("its own input") {
    folder.write("io.csv", "theta_o\n0\n");
    check_output(folder, "brdfplot eval configs/materials/ggx.json -q g1 -i io.csv -o io.csv");
    CHECK(folder.read("io.csv") == "theta_o,g1\n0,1\n");
  }
  SUBCASE("a device, which stays one") {
    check_output(folder, eval + "-o /dev/null");
    CHECK(fs::is_character_file("/dev/null"));
    CHECK(check_output(folder, eval + "-o /dev/stdout") == expected);
  }
  SUBCASE("with the permissions of the umask") {
    check_output(folder, "umask 027; " + eval + "-o new.csv");
    struct stat status {};
    REQUIRE(stat((folder.path() / "new.csv").c_str(), &status) == 0);
    CHECK((status.st_mode & 0777U) == 0640U);
  }
}
