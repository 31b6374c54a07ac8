#include "config/json_file.hpp"
#include "config/load.hpp"
#include "temp_files.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace {

using namespace brdfplot;
using config::Json;
using test::contains;
using test::error_of;
using test::TempFolder;

constexpr const char* good_figure = R"({"id": "f", "kind": "lines", "title": "", "caption": "", "x": {"variable":
  "theta_m", "from": 0, "to": 1}, "panels": [{"series": [{"quantity": "d"}]}], )";

} // namespace

TEST_CASE("references: anywhere, relative to the file in which they stand") {
  const TempFolder folder;
  folder.write("numbers.json", R"({"list": [1, {"two": 2}], "a/b": {"~": 3}})");
  folder.write("deep/link.json", R"({"to": {"$ref": "../numbers.json#/list/1/two"}, "own": {"$ref": "#/other"},
                                     "other": {"$ref": "below/more.json"}})");
  folder.write("deep/below/more.json", R"({"$schema": "x", "up": {"$ref": "../../numbers.json#/a~1b/~0"}})");
  const auto path = folder.write("main.json", R"({
    "plain": {"$ref": "numbers.json#/list/0"}, "array": [0, {"$ref": "deep/link.json#/to"}],
    "nested": {"$ref": "deep/link.json#/own"}, "here": {"$ref": "#/array"}, "hash": {"$ref": "numbers.json#"}})");
  const config::JsonFile file(path);
  CHECK(file.root()["plain"] == 1);
  CHECK(file.root()["array"] == Json::parse("[0, 2]"));
  CHECK(file.root()["here"] == Json::parse("[0, 2]"));
  CHECK(file.root()["nested"] == Json::parse(R"({"up": 3})"));
  CHECK(file.root()["hash"]["list"][1]["two"] == 2);

  CHECK(folder.relative(file.where("")) == "main.json: /");
  CHECK(folder.relative(file.where("/array/0")) == "main.json: /array/0");
  CHECK(folder.relative(file.where("/array/1")) == "deep/../numbers.json: /list/1/two");
  CHECK(folder.relative(file.where("/hash/list/1")) == "numbers.json: /list/1");
  CHECK(folder.relative(file.where("/hash")) == "numbers.json: /");
  CHECK(folder.relative(file.where("/nested")) == "deep/below/more.json: /");
  CHECK(folder.relative(file.where("/nested/up")) == "deep/below/../../numbers.json: /a~1b/~0");
  CHECK(folder.relative(file.where("/plainer")) == "main.json: /plainer");
  CHECK(folder.relative(file.file("/nested/x")) == "deep/below/more.json");
}

TEST_CASE("references: errors stand where the value stands") {
  const TempFolder folder;
  folder.write("parts/rough.json", R"({"wide": {"type": "ggx", "alpha": -1}, "name": 3})");
  folder.write("parts/whole.json", R"({"distribution": {"type": "ggx", "alpha": 1}, "masking": {"type": "smiht"}})");
  folder.write("parts/pair.json",
               R"({"distribution": {"type": "ggx", "alpha": 1}, "masking": {"type": "v_cavity"},
                   "shadowing": {"type": "height_correlated"}})");
  const auto error = [&](const std::string& text) {
    const auto path = folder.write("main.json", text);
    return error_of(folder, 2, [&] { config::validate(path); });
  };
  CHECK(contains(error(R"({"distribution": {"$ref": "parts/rough.json#/wide"}})"),
                 "parts/rough.json: /wide/alpha: found -1"));
  CHECK(contains(error(R"({"$ref": "parts/whole.json"})"), "parts/whole.json: /masking/type: "));
  CHECK(contains(error(R"({"$ref": "parts/pair.json"})"), "parts/pair.json: /shadowing/type: "));
  CHECK(contains(error(R"({"distribution": {"type": {"$ref": "parts/rough.json#/name"}}})"),
                 "parts/rough.json: /name: found 3"));
  CHECK(contains(error(good_figure + std::string(R"("material": {"$ref": "parts/whole.json"}})")),
                 "parts/whole.json: /masking/type: "));
  CHECK(
      contains(error(good_figure + std::string(R"("materials": {"m": {"$ref": "parts/pair.json"}}, "material": "m"})")),
               "parts/pair.json: /shadowing/type: "));
}

TEST_CASE("references: a material takes its name from the file in which it stands") {
  const TempFolder folder;
  folder.write("parts/silk.json", R"({"$schema": "x", "distribution": {"type": "ggx", "alpha": 1}})");
  const auto path = folder.write("main.json", good_figure + std::string(R"("material": {"$ref": "parts/silk.json"}})"));
  CHECK(config::load_figure(path).figure.panels[0].series[0].value.term.material.name == "silk");
  CHECK(config::load_material(folder.write("own.json", R"({"$ref": "parts/silk.json"})")).name == "silk");
}

TEST_CASE("references: what leads nowhere, to itself, or is none") {
  struct Case {
    std::string text, error;
  };
  const std::vector<Case> cases = {
      {R"({"a": {"$ref": "#/b"}})", "main.json: /a: there is nothing at \"/b\" in main.json"},
      {R"({"a": [1, {"$ref": "#/a/7"}]})", "main.json: /a/1: there is nothing at \"/a/7\" in main.json"},
      {R"({"a": [1, {"$ref": "#/a/-"}]})", "main.json: /a/1: there is nothing at \"/a/-\" in main.json"},
      {R"({"a": [1, {"$ref": "#/a/01"}]})", "main.json: /a/1: there is nothing at \"/a/01\" in main.json"},
      {R"({"a": [{"$ref": "#/a/99999999999999999999999999"}]})", "main.json: /a/0: there is nothing at "},
      {R"({"a": {"$ref": "#/b/c"}, "b": 1})", "main.json: /a: there is nothing at \"/b/c\""},
      {R"({"a": {"$ref": "#b"}})", "main.json: /a: \"b\" is not a JSON pointer; accepted: \"\" or \"/key/...\""},
      {R"({"a": {"$ref": "#/~2"}})", "main.json: /a: \"/~2\" is not a JSON pointer"},
      {R"({"a": {"$ref": 1}})", "main.json: /a: a reference is {\"$ref\": \"FILE#/pointer\"} and nothing else"},
      {R"({"a": {"$ref": "#/b", "c": 1}, "b": 1})", "main.json: /a: a reference is "},
      {R"({"$ref": null})", "main.json: /: a reference is "},
      {R"({"a": {"$ref": "#/a"}})", "main.json: /a: the reference \"#/a\" leads back to itself"},
      {R"({"a": {"b": {"$ref": "#/a"}}})", "leads back to itself"},
      {R"({"a": {"$ref": "#"}})", "leads back to itself"},
      {R"({"a": {"$ref": "main.json"}})", "leads back to itself"},
      {R"({"a": {"$ref": "./main.json#/a"}})", "leads back to itself"},
      {R"({"a": {"$ref": "sub/../main.json#/a"}})", "leads back to itself"},
      {R"({"a": {"$ref": "#/b"}, "b": {"$ref": "#/c"}, "c": [{"$ref": "#/a"}]})", "leads back to itself"},
      {R"({"a": {"$ref": "sub/back.json"}})",
       "sub/../main.json: /a: the reference \"sub/back.json\" leads back to itself"},
      {R"({"a": {"$ref": "sub/broken.json#/x"}})", "sub/broken.json:2:3: "},
      {R"({"a": {"$ref": "sub/lost.json"}})", "sub/lost.json: /0: there is nothing at \"/y\" in sub/back.json"},
      {R"({"a\nb": {"$ref": "#/c\nd"}})", "main.json: /a\\nb: there is nothing at \"/c\\nd\""},
  };
  const TempFolder folder;
  folder.write("sub/back.json", R"({"x": {"$ref": "../main.json#/a"}})");
  folder.write("sub/broken.json", "{\n  ]");
  folder.write("sub/lost.json", R"([{"$ref": "back.json#/y"}])");
  for (const auto& one : cases) {
    CAPTURE(one.text);
    const auto path = folder.write("main.json", one.text);
    const std::string error = error_of(folder, 2, [&] { config::JsonFile file(path); });
    CHECK_MESSAGE(contains(error, one.error), error);
  }
}

TEST_CASE("references: files that are not there, or are folders") {
  const TempFolder folder;
  folder.write("sub/lost.json", R"([{"$ref": "none.json"}])");
  const auto error = [&](const std::string& text) {
    const auto path = folder.write("main.json", text);
    return error_of(folder, 3, [&] { config::JsonFile file(path); });
  };
  CHECK(contains(error(R"({"a": {"$ref": "none.json#/x"}})"), "main.json: /a: none.json: cannot read: "));
  CHECK(contains(error(R"({"a": {"$ref": "sub"}})"), "main.json: /a: sub: cannot read: "));
  CHECK(contains(error(R"({"a": {"$ref": "sub/lost.json"}})"), "sub/lost.json: /0: sub/none.json: cannot read: "));
}

TEST_CASE("references: long chains and doubling ones end in an error") {
  const TempFolder folder;
  std::string chain = "{", doubling = "{";
  for (int k = 0; k < 300; ++k)
    chain += "\"a" + std::to_string(k) + R"(": {"$ref": "#/a)" + std::to_string(k + 1) + "\"},";
  chain += R"("a300": 1})";
  for (int k = 0; k < 14; ++k) {
    const std::string next = R"({"$ref": "#/a)" + std::to_string(k + 1) + "\"}";
    doubling += "\"a" + std::to_string(k) + "\": [" + next + "," + next + "],";
  }
  doubling += R"("a14": 1})";
  const auto error = [&](const std::string& text) {
    const auto path = folder.write("main.json", text);
    return error_of(folder, 2, [&] { config::JsonFile file(path); });
  };
  CHECK(contains(error(chain), "more than 256 references lead to each other"));
  CHECK(contains(error(doubling), "there are more than 10000 references"));
}
