/// Floods: files that are far more than anybody needs are told so at once, by their number and the limit.
#include "config/load.hpp"
#include "temp_files.hpp"

#include <chrono>

namespace {

using namespace brdfplot;
using test::contains;
using test::error_of;
using test::TempFolder;

const std::string ggx = R"({"type": "ggx", "alpha": 0.5})";

std::string repeated(const std::string& item, int count) {
  std::string out = item;
  for (int k = 1; k < count; ++k) out += "," + item;
  return out;
}

std::string figure(const std::string& panels, const std::string& more = "") {
  return R"({"id": "f", "kind": "lines", "title": "T", "caption": "C", "x": {"variable": "theta_o", "from": 0, "to": 1},
    "material": {"distribution": )" +
         ggx + "}, " + more + R"("panels": [)" + panels + "]}";
}

std::string each(const std::string& values) {
  return R"("for_each": {"variable": "alpha", "values": [)" + values + "]}";
}

/// What is said of a text, which has to be short and come soon.
std::string said_of(const std::string& text) {
  const TempFolder folder;
  const std::string path = folder.write("a.json", text);
  const auto began = std::chrono::steady_clock::now();
  const std::string error = error_of(folder, 2, [&] { config::validate(path); });
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(5)); // some 0.2 s, of a machine that is idle
  CHECK(error.size() < 1000);
  return error;
}

} // namespace

TEST_CASE("of a long value an error shows the beginning, and how long it is") {
  const std::string start(60, 'g');
  const std::string name = said_of(R"({"distribution": {"type": ")" + std::string(1000000, 'g') + R"(", "alpha": 1}})");
  CHECK(contains(name, "a.json: /distribution/type: unknown type \"" + start + "… (1000000 bytes)\""));
  const std::string key = said_of(R"({"distribution": {"type": "ggx", ")" + std::string(1000000, 'g') + R"(": 1}})");
  CHECK(contains(key, "unknown key \"" + start + "… (1000000 bytes)\""));
  std::string letters;
  for (int k = 0; k < 500000; ++k) letters += "é";
  const std::string text = said_of(R"({"distribution": {"type": "ggx", "alpha": ")" + letters + R"("}})");
  CHECK(contains(text, "é… (1000000 bytes)\", accepted: a number in [1e-06, 1e+06]"));
  const std::string formula =
      said_of(R"({"distribution": {"type": "custom", "alpha": 1, "shape": ")" + std::string(5000, '(') + R"("}})");
  CHECK(contains(formula, "… (5000 bytes)"));
}

TEST_CASE("too many values in a file") {
  CHECK(said_of(R"({"distribution": [)" + repeated("1.5", 1000000) + "]}") ==
        "a.json: /distribution: more than 10000 items in one array; accepted: at most as many");
  std::string keys;
  for (int k = 0; k < 200000; ++k) keys += ", \"key" + std::to_string(k) + "\": 1";
  CHECK(said_of(R"({"distribution": )" + ggx + keys + "}") ==
        "a.json: /: more than 1000 keys in one object; accepted: at most as many");
  CHECK(said_of("[" + repeated("[" + repeated("1", 9999) + "]", 200) + "]") ==
        "a.json: /100: more than 1000000 values in one file; accepted: at most as many");
  CHECK(contains(said_of(std::string(1000000, '[')), "nested more than 256 deep"));
  std::string nested;
  for (int k = 0; k < 200000; ++k) nested += R"({"a":)";
  CHECK(contains(said_of(nested), "nested more than 256 deep"));
}

TEST_CASE("references that multiply what they lead to") {
  const TempFolder folder;
  folder.write("b.json", "[" + repeated("1", 9999) + "]");
  const std::string path = folder.write("a.json", "[" + repeated(R"({"$ref": "b.json"})", 5000) + "]");
  CHECK(error_of(folder, 2, [&] { config::validate(path); }) ==
        "a.json: more than 1000000 values where references are followed");
}

TEST_CASE("figures that are too much to draw") {
  const std::string series = R"({"quantity": "g1"})";
  CHECK(said_of(figure(R"({"series": [)" + repeated(series, 10000) + "]}")) ==
        "a.json: /panels/0/series: found 10000 items, accepted: an array of 1 to 1000 items, each a series");
  CHECK(contains(said_of(figure(repeated(R"({"series": [{"quantity": "g1"}]})", 10000))),
                 "a.json: /panels: found 10000 items, accepted: an array of 1 to 1000 items"));
  const std::string values = repeated("0.5", 600);
  CHECK(said_of(figure(R"({"series": [{"quantity": "g1", )" + each(values) + R"(}, {"quantity": "g1", )" +
                       each(values) + "}]}")) ==
        "a.json: /panels/0/series/1: 1200 series; accepted: at most 1000 in one figure");
  CHECK(said_of(figure(R"({"series": [{"quantity": "g1"}, {"quantity": "d", "at": {"theta_m": 0}}], )" + each(values) +
                       "}")) == "a.json: /panels/0/series/1: 1200 series; accepted: at most 1000 in one figure");
  const std::string loops =
      R"("for_each": [)" + repeated(R"({"variable": "alpha", "values": [)" + values + "]}", 8) + "]";
  CHECK(said_of(figure(R"({"series": [{"quantity": "g1"}], )" + loops + "}")) ==
        "a.json: /panels/0: 1.679616e+22 panels; accepted: at most 1000 in one figure");
  CHECK(said_of(figure(R"({"x": {"samples": 100000}, "series": [{"quantity": "g1", )" + each(values) + "}]}")) ==
        "a.json: /panels/0/series/0: 60000000 points; accepted: at most 10000000 in one figure");
  CHECK(said_of(figure(R"({"series": [{"quantity": "albedo", "simulate": {"source": "smith_walk", "samples": 1000}, )" +
                       each(values) + "}]}")) ==
        "a.json: /panels/0/series/0: 600000 simulated points; accepted: at most 100000 in one figure");
}

TEST_CASE("spheres that are too much to draw") {
  const auto spheres = [](const std::string& panels) {
    return R"({"id": "f", "kind": "spheres", "title": "T", "caption": "C", "material": {"distribution": )" + ggx +
           R"(}, "sphere": {"pixels": 512, "lights": [{"type": "environment", "radiance": 1}]}, "panels": [)" + panels +
           "]}";
  };
  CHECK(said_of(spheres(R"({"sphere": {}, )" + each(repeated("0.5", 600)) + "}")) ==
        "a.json: /panels/0: 157286400 pixels; accepted: at most 10000000 in one figure");
  CHECK(said_of(spheres(repeated(R"({"sphere": {"pixels": 2048}})", 3))) ==
        "a.json: /panels/2: 12582912 pixels; accepted: at most 10000000 in one figure");
}

TEST_CASE("tables that are too much to measure") {
  const auto table = [](int count) {
    return R"({"title": "T", "entries": [{"section": "S", "table": {"id": "p", "title": "P", "caption": "C", "maskings": [)" +
           repeated("\"smith\"", count) + R"(], "distributions": [)" + repeated("\"ggx\"", count) + R"(], "alpha": [)" +
           repeated("0.5", count) + R"(], "theta_o": [1]}}]})";
  };
  CHECK(contains(said_of(table(101)), "a.json: /entries/0/table/maskings: found 101 items"));
  CHECK(said_of(table(30)) == "a.json: /entries/0/table: 27000 materials; accepted: at most 20000 in one table");
}
