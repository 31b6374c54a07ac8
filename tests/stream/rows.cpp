#include "stream/rows.hpp"

#include "base/errors.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

using namespace brdfplot;

namespace {

/// A file with a text, for as long as it is needed.
class TextFile {
public:
  explicit TextFile(const std::string& text) {
    std::string pattern = (std::filesystem::temp_directory_path() / "brdfplot-rows-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    folder_ = pattern;
    std::ofstream(name(), std::ios::binary) << text;
  }
  ~TextFile() { std::filesystem::remove_all(folder_); }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  std::string name() const { return (folder_ / "rows.csv").string(); }

private:
  std::filesystem::path folder_;
};

std::vector<std::string> fields_of(const std::string& text) {
  std::vector<std::string> fields;
  for (FieldScanner scanner(text); !scanner.at_end();) {
    fields.emplace_back(scanner.next());
    if (scanner.row_ended()) fields.emplace_back(scanner.cut() ? "|cut" : "|");
  }
  return fields;
}

} // namespace

TEST_CASE("fields of rows") {
  using Fields = std::vector<std::string>;
  CHECK(fields_of("a,b\nc\r\n") == Fields{"a", "b", "|", "c", "|"});
  CHECK(fields_of(",\n\n") == Fields{"", "", "|", "", "|"});
  CHECK(fields_of("\"a,\"\"\n\",b\n") == Fields{"\"a,\"\"\n\"", "b", "|"});
  CHECK(fields_of("a\"b,c\n") == Fields{"a\"b", "c", "|"}); // a quote within a field is a character
  CHECK(fields_of("\"a\"b,c\n") == Fields{"\"a\"b", "c", "|"});
  CHECK(fields_of("a,b") == Fields{"a", "b", "|cut"});
  CHECK(fields_of("\"a,b\n") == Fields{"\"a,b\n", "|cut"});
  CHECK(fields_of("\"a\"") == Fields{"\"a\"", "|cut"});
}

TEST_CASE("fields that are numbers") {
  const std::string text = "1.5,-2e-320\n80deg,+1, 1,inf,1e999,\"7\n\"\n4\r\n5";
  FieldScanner scanner(text);
  double number = 0;
  CHECK(scanner.next_number(number));
  CHECK(number == 1.5);
  CHECK_FALSE(scanner.row_ended());
  CHECK(scanner.next_number(number));
  CHECK(number == -2e-320);
  CHECK(scanner.row_ended());
  CHECK(scanner.lines() == 1);
  for (const char* other : {"80deg", "+1", " 1", "inf", "1e999", "\"7\n\"", "4", "5"}) {
    CHECK_FALSE(scanner.next_number(number));
    CHECK(number == -2e-320);
    CHECK(scanner.next() == other);
  }
  CHECK(scanner.lines() == 4);
  CHECK(scanner.at_end());
  CHECK_FALSE(scanner.next_number(number));
}

TEST_CASE("fields without their quotes") {
  CHECK(unquoted(" a b\t") == "a b");
  CHECK(unquoted("\"a \"\"b\"\"\"") == "a \"b\"");
  CHECK(unquoted("\"\"") == "");
  CHECK(unquoted("\"") == "\"");
  CHECK(unquoted("") == "");
}

TEST_CASE("blocks are cut at the ends of rows, whatever their size") {
  const std::string header = "\xEF\xBB\xBF\r\n\"a\n\",b\r\n";
  const std::string rows = "1,2\r\n\n\"x\n\"\"\n\",3\n4,5";
  const TextFile file(header + rows);
  for (std::size_t size = 1; size < 40; ++size) {
    InputFile in(file.name());
    FileRows source(in);
    RowReader reader(source, size);
    CHECK(reader.header() == "\"a\n\",b");
    CHECK(reader.header_line() == 2);
    std::string all;
    std::size_t line = 4;
    for (RowBlock block; reader.next(block);) {
      CHECK(block.text.ends_with('\n'));
      CHECK(block.first_line == line);
      CHECK(std::string("1\n\"4").find(block.text.front()) != std::string::npos); // where a row starts
      line += static_cast<std::size_t>(std::ranges::count(block.text, '\n'));
      all += block.text;
    }
    CHECK(all == rows + "\n");
  }
}

TEST_CASE("a row that never ends is an error before memory is") {
  const TextFile file("a\n1\n\"" + std::string(std::size_t{17} << 20, 'x'));
  InputFile in(file.name());
  FileRows source(in);
  RowReader reader(source, std::size_t{1} << 20);
  CHECK(reader.header() == "a");
  RowBlock block;
  CHECK(reader.next(block));
  CHECK(block.text == "1\n");
  CHECK_THROWS_WITH_AS(reader.next(block),
                       (file.name() + ":3: a row of more than 16 MiB; is a quote not closed?").c_str(), InputError);
}

TEST_CASE("an empty file") {
  const TextFile file("");
  InputFile in(file.name());
  FileRows source(in);
  RowReader reader(source, 10);
  CHECK(reader.header() == "");
  RowBlock block;
  CHECK_FALSE(reader.next(block));
}
