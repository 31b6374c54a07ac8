#include "base/text_files.hpp"

#include "base/errors.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

using namespace brdfplot;

namespace {

namespace fs = std::filesystem;

class Folder {
public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "brdfplot-files-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  auto count() const { return std::distance(fs::directory_iterator(path_), fs::directory_iterator()); }

private:
  fs::path path_;
};

} // namespace

TEST_CASE("what is written is read again") {
  const Folder folder;
  std::string text(200000, 'x');
  text += std::string("\0\r\n", 3);
  write_text_file(folder / "a", text);
  CHECK(read_text_file(folder / "a") == text);
  write_text_file(folder / "a", "");
  CHECK(read_text_file(folder / "a") == "");
  CHECK(folder.count() == 1);
}

TEST_CASE("without commit nothing happened") {
  const Folder folder;
  write_text_file(folder / "a", "as it was");
  {
    OutputFile out(folder / "a");
    out.write("half of it");
    CHECK(folder.count() == 2);
    CHECK(read_text_file(folder / "a") == "as it was");
  }
  CHECK(folder.count() == 1);
  CHECK(read_text_file(folder / "a") == "as it was");
}

TEST_CASE("two writers of one file do not disturb each other") {
  const Folder folder;
  OutputFile first(folder / "a");
  OutputFile second(folder / "a");
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  CHECK(read_text_file(folder / "a") == "first");
  CHECK(folder.count() == 1);
}

TEST_CASE("files and folders that cannot be") {
  const Folder folder;
  write_text_file(folder / "file", "");
  CHECK_THROWS_AS(read_text_file(folder / "nope"), FileError);
  CHECK_THROWS_AS(read_text_file(folder / "."), FileError);
  CHECK_THROWS_AS(write_text_file(folder / ".", ""), FileError);
  CHECK_THROWS_AS(write_text_file(folder / "file/x", ""), FileError);
  CHECK_THROWS_AS(write_text_file("/dev/full", "x"), FileError);
  CHECK_THROWS_AS(create_folders(folder / "file"), FileError);
  CHECK_THROWS_AS(create_folders(folder / "file/x"), FileError);
  CHECK_THROWS_AS(remove_file(folder / "nope"), FileError);
  create_folders(folder / "a/b");
  create_folders(folder / "a/b");
  CHECK(fs::is_directory(folder / "a/b"));
  remove_file(folder / "file");
  CHECK(folder.count() == 1);
}

TEST_CASE("files that belong together are all written, or none is") {
  const Folder folder;
  write_text_file(folder / "a", "old");
  fs::create_directory(folder / "b");
  CHECK_THROWS_AS(write_text_files({{folder / "a", "new"}, {folder / "b", "new"}}), FileError);
  CHECK(read_text_file(folder / "a") == "old");
  CHECK(folder.count() == 2);
  fs::remove(folder / "b");
  write_text_files({{folder / "a", "new"}, {folder / "b", "new"}});
  CHECK(read_text_file(folder / "a") == "new");
  CHECK(read_text_file(folder / "b") == "new");
  CHECK(folder.count() == 2);
}

TEST_CASE("a file that is too large is not read") {
  const Folder folder;
  write_text_file(folder / "a", std::string(1000, 'x'));
  CHECK(read_text_file(folder / "a", 1000).size() == 1000);
  CHECK_THROWS_AS(read_text_file(folder / "a", 999), InputError);
  CHECK_THROWS_AS(read_text_file("/dev/zero", 1 << 20), InputError);
}
