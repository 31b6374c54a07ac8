#include "config/load.hpp"
#include "temp_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using namespace brdfplot;
using test::contains;
using test::error_of;
using test::TempFolder;

const std::string configs = BRDFPLOT_SOURCE_DIR "/configs/";

std::vector<std::string> files_in(const std::string& directory) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(configs + directory))
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

constexpr const char* table = R"("table": {"id": "t", "title": "", "caption": "", "maskings": ["smith", "kelemen"],
  "distributions": ["ggx", {"type": "gtr", "gamma": 3}], "alpha": [0.5], "theta_o": ["45deg", 1]})";

constexpr const char* figure = R"({"id": "f", "kind": "lines", "title": "", "caption": "", "x": {"variable": "theta_m",
  "from": 0, "to": 1}, "material": {"distribution": {"type": "ggx", "alpha": 1}},
  "panels": [{"series": [{"quantity": "d"}]}]})";

} // namespace

TEST_CASE("every file in configs loads and is what its folder says") {
  const TempFolder folder;
  for (const auto& [directory, kind] : std::vector<std::pair<std::string, std::string>>{
           {"materials", "material"}, {"figures", "figure"}, {"reports", "report"}, {"scenes", "scene"}}) {
    const auto files = files_in(directory);
    CHECK(!files.empty());
    for (const auto& file : files) {
      const std::string found = config::validate(file);
      CHECK_MESSAGE((found == kind || (kind == "scene" && found == "advice")), file);
    }
  }
  for (const auto& file : files_in("materials")) CHECK(!config::load_material(file).name.empty());
  for (const auto& file : files_in("figures")) {
    const auto loaded = config::load_figure(file);
    CHECK(loaded.figure.id == std::filesystem::path(file).stem().string());
    CHECK(!loaded.figure.panels.empty());
    CHECK(nlohmann::json::parse(loaded.json).is_object());
  }
}

TEST_CASE("reports: figures and tables in order, figures relative to the manifest") {
  const TempFolder folder;
  folder.write("figures/f.json", figure);
  const auto path = folder.write("reports/my report.json", R"({"$schema": "x", "title": "T", "entries": [
      {"section": "one", "figure": "../figures/f.json"}, {"section": "two", )" +
                                                               std::string(table) + "}]}");
  CHECK(config::validate(path) == "report");
  const auto report = config::load_report(path);
  CHECK(report.id == "my report");
  CHECK(report.title == "T");
  CHECK(report.introduction.empty());
  REQUIRE(report.entries.size() == 2);
  CHECK(std::get<plot::FigureDescription>(report.entries[0].what).id == "f");
  CHECK(report.entries[0].json == figure);
  CHECK(report.entries[1].section == "two");
  const auto& description = std::get<PropertyTableDescription>(report.entries[1].what);
  CHECK(description.maskings == std::vector<std::string>{"smith", "kelemen"});
  REQUIRE(description.distributions.size() == 2);
  CHECK(description.distributions[0].type == "ggx");
  CHECK(description.distributions[1].values.number("gamma") == 3);
  CHECK(description.theta_o == std::vector<double>{45.0 / 180 * 3.14159265358979323846, 1});
  CHECK(description.tolerance == 1e-6);
  CHECK(nlohmann::json::parse(report.entries[1].json)["id"] == "t");
}

TEST_CASE("reports: an entry that stands in another file names its figure relative to that file") {
  const TempFolder folder;
  folder.write("parts/f.json", figure);
  folder.write("parts/entries.json", R"([{"section": "one", "figure": "f.json"}])");
  const auto path = folder.write("report.json", R"({"title": "T", "entries": {"$ref": "parts/entries.json"}})");
  CHECK(config::load_report(path).entries.size() == 1);
}

TEST_CASE("reports: errors") {
  const TempFolder folder;
  folder.write("f.json", figure);
  folder.write("broken.json", "{\n]");
  folder.write("wrong.json", R"({"id": "f", "kind": "pie"})");
  const auto entry = [](const std::string& rest) {
    return R"({"title": "T", "entries": [{"section": "s", )" + rest + "}]}";
  };
  const auto with_table = [&](const std::string& from, const std::string& to) {
    std::string text = table;
    text.replace(text.find(from), from.size(), to);
    return entry(text);
  };
  struct Case {
    std::string text, error;
  };
  const std::vector<Case> cases = {
      {R"({"title": "T", "entries": []})", "r.json: /entries: found 0 items, accepted: an array of 1 to 1000 items"},
      {R"({"entries": [1]})", "r.json: /entries/0: found 1"},
      {R"({"entries": [{"section": "s", "figure": "f.json"}]})", "r.json: /: \"title\" is missing"},
      {entry(R"("figur": "f.json")"), "r.json: /entries/0/figur: unknown key \"figur\"; did you mean \"figure\"?"},
      {entry(R"("figure": "f.json", )" + std::string(table)),
       "r.json: /entries/0: found figure with table; accepted: either figure, or table"},
      {R"({"title": "T", "entries": [{"section": "s"}]})", "r.json: /entries/0: found none of figure, table"},
      {entry(R"("figure": "broken.json")"), "broken.json:2:1: "},
      {entry(R"("figure": "wrong.json")"), "wrong.json: /kind: unknown value \"pie\""},
      {with_table("\"t\"", "\"../t\""), "r.json: /entries/0/table/id: found \"../t\""},
      {with_table("\"smith\"", "\"smiht\""), "/entries/0/table/maskings/0: unknown value \"smiht\"; did you mean"},
      {with_table("0.5", "0"), "r.json: /entries/0/table/alpha/0: found 0, accepted: a number > 0"},
      {with_table("\"45deg\"", "\"45º\""), "r.json: /entries/0/table/theta_o/0: found \"45º\""},
      {with_table("\"ggx\"", "\"ggx\", \"gtr\""), "/entries/0/table/distributions/1: \"gtr\" with alpha alone: "},
      {with_table("\"smith\"", "\"smith\", \"custom\""), "/entries/0/table/maskings/1: \"custom\" lacks"},
      {R"({"title": "T", "entries": [{"section": "s", "figure": "f.json"}, {"section": "s", "figure": "f.json"}]})",
       "r.json: /entries/1: the id \"f\" stands twice"},
  };
  for (const auto& one : cases) {
    CAPTURE(one.text);
    const auto path = folder.write("r.json", one.text);
    const std::string error = error_of(folder, 2, [&] { config::validate(path); });
    CHECK_MESSAGE(contains(error, one.error), error);
  }
  const auto path = folder.write("r.json", entry(R"("figure": "none.json")"));
  CHECK(contains(error_of(folder, 3, [&] { config::load_report(path); }), "none.json: cannot read: "));
}

TEST_CASE("schemas: one for each kind") {
  CHECK(config::kinds() == std::vector<std::string>{"material", "figure", "report", "scene", "advice"});
  for (const auto& kind : config::kinds()) {
    const auto text = config::schema(kind);
    CHECK(text.back() == '\n');
    const auto schema = nlohmann::json::parse(text);
    CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
    CHECK(schema["title"] == "brdfplot " + kind);
    // A material is written in two ways.
    const std::vector<nlohmann::json> shapes =
        kind == "material" ? std::vector{schema["then"], schema["else"]} : std::vector{schema};
    for (const auto& shape : shapes) CHECK(shape["additionalProperties"] == false);
  }
  const TempFolder folder;
  CHECK(contains(error_of(folder, 2, [] { config::schema("figur"); }), "\"figur\"; did you mean \"figure\"?"));
}

TEST_CASE("figures: the text that is shown of a file is its own, but for $schema") {
  const TempFolder folder;
  const std::string bare = figure;
  const std::string schema = R"("$schema" : "../a \"b\", c.json\\")";
  const auto shown = [&](const std::string& text) { return config::load_figure(folder.write("f.json", text)).json; };
  const std::size_t first = bare.find_first_not_of(" \n", bare.find('{') + 1);
  const std::size_t last = bare.find_last_not_of(" \n", bare.rfind('}') - 1) + 1;
  CHECK(shown(bare) == bare);
  CHECK(shown(bare.substr(0, first) + schema + ",\n " + bare.substr(first)) == bare);
  CHECK(shown(bare.substr(0, last) + " , " + schema + bare.substr(last)) ==
        bare.substr(0, last) + " " + bare.substr(last));
  // Nothing but the key of the outermost object.
  const std::string title =
      bare.substr(0, first) + R"("materials": {"$schema": {"distribution": {"type": "ggx", "alpha": 1}}}, )";
  CHECK(shown(title + bare.substr(first)) == title + bare.substr(first));
  CHECK(shown(title + schema + ", " + bare.substr(first)) == title + bare.substr(first));
  const std::string refers =
      bare.substr(0, first) + schema + R"(, "materials": {"$ref": "m.json"}, )" + bare.substr(first);
  folder.write("m.json", R"({"m": {"distribution": {"type": "ggx", "alpha": 1}}})");
  CHECK(!nlohmann::json::parse(shown(refers)).contains("$schema"));
}

TEST_CASE("the record of a report") {
  const config::ReportFile report{"id", "T", "", {}, "", {}, ""};
  const PropertyRow row{"",
                        "ggx",
                        "ggx",
                        "smith",
                        {{Property::eq14, {1e-9, 0, 0, 0, 0, Verdict::holds}},
                         {Property::eq36, {0.5, 0, 0, 0, 0, Verdict::fails}},
                         {Property::energy, {std::nan(""), 0, 0, 0, 0, Verdict::unknown}}}};
  const auto json = nlohmann::json::parse(
      config::report_record(report, "1.2", {{"f", "figure", {"f.svg"}, 0.25, {}}, {"t", "table", {}, 1, {row}}}, 2));
  CHECK(json["version"] == "1.2");
  CHECK(json["entries"][0]["files"][0] == "f.svg");
  CHECK(json["entries"][1]["rows"][0]["eq14"]["holds"] == true);
  CHECK(json["entries"][1]["rows"][0]["eq36"]["max_residual"] == 0.5);
  CHECK(json["entries"][1]["rows"][0]["physically_based"] == false);
  CHECK(json["entries"][1]["rows"][0]["energy"]["max_residual"].is_null());
  CHECK(json["entries"][1]["rows"][0]["energy"]["verdict"] == "unknown");
}

TEST_CASE("reports: a table of data is a CSV, as it stands") {
  const TempFolder folder;
  const std::string csv = "function,\"worst, of all\"\nf,\"x = 1, \"\"y\"\"\"\ng,2\n";
  folder.write("data/t.csv", csv);
  const auto manifest = [&](const std::string& name) {
    return folder.write("reports/r.json", R"({"title": "T", "entries": [{"section": "s", "data": {"id": "t",
      "title": "Table", "caption": "", "file": "../data/)" +
                                              name + R"("}}]})");
  };
  const auto report = config::load_report(manifest("t.csv"));
  REQUIRE(report.entries.size() == 1);
  const auto& data = std::get<config::DataTable>(report.entries[0].what);
  CHECK(data.id == "t");
  CHECK(data.csv == csv);
  const std::vector<std::vector<std::string>> cells = {
      {"function", "worst, of all"}, {"f", "x = 1, \"y\""}, {"g", "2"}};
  CHECK(data.cells == cells);

  folder.write("data/short.csv", "a,b\n1,2\n3\n");
  CHECK(contains(error_of(folder, 2, [&] { config::load_report(manifest("short.csv")); }),
                 "short.csv:3: found 1 fields, the header has 2"));
  folder.write("data/empty.csv", "a,b\n");
  CHECK(contains(error_of(folder, 2, [&] { config::load_report(manifest("empty.csv")); }), "a header line and rows"));
  CHECK_THROWS_AS(config::load_report(manifest("none.csv")), FileError);
}
