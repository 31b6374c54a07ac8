#include "config/json_file.hpp"
#include "config/load.hpp"
#include "temp_files.hpp"

#include <vector>

namespace {

using namespace brdfplot;
using test::contains;
using test::error_of;
using test::TempFolder;

struct SyntaxCase {
  std::string name;
  std::string text;
  std::string line_column;
  std::string what; ///< part of the message
};

} // namespace

TEST_CASE("syntax errors name line and column, counted in characters") {
  const std::vector<SyntaxCase> cases = {
      {"empty", "", "1:1", "end of input"},
      {"blank", "  \n\n ", "3:2", "end of input"},
      {"brace", "{", "1:2", "end of input"},
      {"first line", "{x: 1}", "1:2", "object key"},
      {"comment", "// a material\n{}", "1:1", "invalid literal"},
      {"single quotes", "{'a': 1}", "1:2", "object key"},
      {"trailing comma in object", "{\n  \"a\": 1,\n}", "3:1", "'}'"},
      {"trailing comma in array", "{\"a\": [1, 2,]}", "1:13", "']'"},
      {"missing colon", "{\"a\" 1}", "1:6", "':'"},
      {"missing comma", "{\"a\": 1\n \"b\": 2}", "2:4", "string literal"},
      {"literal", "{\n  \"a\": nul}", "2:11", "invalid literal"},
      {"leading zero", "{\"a\": 01}", "1:8", "number literal"},
      {"truncated in a value", "{\n\"a\": 1", "2:7", "end of input"},
      {"truncated after a line end", "{\n\"a\": 1\n", "3:1", "end of input"},
      {"truncated in a string", "{\"a\": \"bc", "1:10", "missing closing quote"},
      {"line end in a string", "{\"a\": \"b\nc\"}", "1:9", "control character"},
      {"after the end", "{}\n}", "2:1", "'}'"},
      {"last line", "{\n\"a\": 1\n]", "3:1", "']'"},
      {"NaN", "{\"a\": NaN}", "1:7", "invalid literal"},
      {"ill-formed UTF-8", "{\"a\": \"\xff\"}", "1:8", "UTF-8"},
      {"not a byte but a character is a column", "{\"θ_o\": \"α\", ]}", "1:14", "']'"},
      {"byte-order mark", "\xEF\xBB\xBF{\"a\": ]}", "1:7", "']'"},
      {"byte-order mark, second line", "\xEF\xBB\xBF{\n\"a\": ]}", "2:6", "']'"},
      {"CR LF", "{\r\n\"a\": ]\r\n}", "2:6", "']'"},
      {"too large", "{\n  \"a\": 1e999\n}", "2:12", "the number 1e999 is too large"},
      {"too large and negative", "[-1e999]", "1:7", "the number -1e999 is too large"},
  };
  const TempFolder folder;
  for (const auto& one : cases) {
    CAPTURE(one.name);
    const auto path = folder.write("file.json", one.text);
    const std::string error = error_of(folder, 2, [&] { config::validate(path); });
    CHECK(error.substr(0, error.find(": ")) == "file.json:" + one.line_column);
    CHECK_MESSAGE(contains(error, one.what), error);
    CHECK(error.size() < 300);
  }
}

TEST_CASE("a byte-order mark and CR LF are no errors") {
  const TempFolder folder;
  const auto path =
      folder.write("m.json", "\xEF\xBB\xBF{\r\n\"distribution\": {\"type\": \"ggx\", \"alpha\": 1}\r\n}\r\n");
  CHECK(config::load_material(path).terms.at(0).distribution.type == "ggx");
}

TEST_CASE("an endless token does not make an endless message") {
  const TempFolder folder;
  const auto path = folder.write("m.json", "{\"a\": \"" + std::string(100000, 'x'));
  const std::string error = error_of(folder, 2, [&] { config::validate(path); });
  CHECK(contains(error, "m.json:1:100008: "));
  CHECK(error.size() < 300);
}

TEST_CASE("a zero byte does not end a file") {
  using namespace std::string_literals;
  const TempFolder folder;
  for (const std::string& behind : {""s, " "s, "{\"b"s, "\0"s}) {
    const auto path = folder.write("m.json", "{\"a\": 1}\n \0"s + behind);
    CHECK(error_of(folder, 2, [&] { config::JsonFile file(path); }) ==
          "m.json:2:2: a zero byte; accepted: nothing behind the value");
  }
  const auto path = folder.write("m.json", "{\"a\": \0}"s);
  CHECK(contains(error_of(folder, 2, [&] { config::JsonFile file(path); }), "m.json:1:"));
}

TEST_CASE("keys that stand twice are told with their pointer") {
  const TempFolder folder;
  const auto error = [&](const std::string& text) {
    const auto path = folder.write("m.json", text);
    return error_of(folder, 2, [&] { config::JsonFile file(path); });
  };
  CHECK(error("{\"a\": 1, \"a\": 1}") == "m.json: /a: the key \"a\" stands twice in one object");
  CHECK(contains(error("{\"a\": [{}, {\"b\": [1, [2]], \"c\": {\"d\": 1, \"d\": 2}}]}"), "m.json: /a/1/c/d: "));
  CHECK(contains(error("{\"a/b\": {\"~\": 1, \"~\": 2}}"), "m.json: /a~1b/~0: "));
  CHECK(contains(error("{\"a\\nb\": 1, \"a\\nb\": 2}"), "m.json: /a\\nb: the key \"a\\nb\""));
  CHECK(error("{\"a\": {\"b\": 1}, \"b\": {\"b\": 2}}").empty());
  CHECK(error("[{\"b\": 1}, {\"b\": 2}]").empty());
}

TEST_CASE("files nested without end are refused, not run into") {
  const TempFolder folder;
  for (const std::string& open : {std::string("["), std::string("{\"a\":")}) {
    std::string deep;
    for (int k = 0; k < 200000; ++k) deep += open;
    const auto path = folder.write("m.json", deep);
    CHECK(contains(error_of(folder, 2, [&] { config::validate(path); }), "m.json: values are nested more than"));
  }
}

TEST_CASE("files that cannot be read") {
  const TempFolder folder;
  for (const auto& load : std::vector<void (*)(const std::string&)>{
           [](const std::string& path) { config::load_material(path); },
           [](const std::string& path) { config::load_figure(path); },
           [](const std::string& path) { config::load_report(path); },
           [](const std::string& path) { config::validate(path); },
       }) {
    CHECK(contains(error_of(folder, 3, [&] { load(folder.path("none.json")); }), "none.json: cannot read: "));
    CHECK(contains(error_of(folder, 3, [&] { load(folder.path("")); }), "cannot read: "));
  }
}
