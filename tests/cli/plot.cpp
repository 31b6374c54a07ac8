#include "cli/program.hpp"

using namespace test;

namespace {

/// A figure of one curve, which integrates when `quantity` says so.
std::string figure(const std::string& id, const std::string& quantity = "lambda", const std::string& type = "ggx",
                   const std::string& tolerance = "1e-7") {
  return R"({"id": ")" + id + R"(", "kind": "lines", "title": "A curve", "caption": "One.", "tolerance": )" +
         tolerance + R"(,
  "x": {"variable": "theta_o", "from": 0.1, "to": "80deg"}, "y": {"label": "y"},
  "material": {"distribution": {"type": ")" +
         type + R"(", "alpha": 1}},
  "panels": [{"series": [{"label": "curve", "quantity": ")" +
         quantity + R"("}]}]})";
}

} // namespace

TEST_CASE("a figure becomes an SVG and a CSV") {
  const Folder folder;
  folder.write("a.json", figure("one"));
  folder.write("b.json", figure("two", "albedo"));
  CHECK(check_output(folder, "brdfplot plot a.json b.json -o out/deep") == "");
  CHECK(folder.list("out/deep") == std::vector<std::string>{"one.csv", "one.svg", "two.csv", "two.svg"});
  const std::string csv = folder.read("out/deep/one.csv");
  CHECK(csv.starts_with("panel,series,theta_o,"));
  CHECK(std::ranges::count(csv, '\n') > 10);
  CHECK(folder.read("out/deep/one.svg").find("<svg") != std::string::npos);
  CHECK(folder.read("out/deep/one.svg").find("</svg>") != std::string::npos);
}

TEST_CASE("figures are the same bytes on any number of threads") {
  const Folder folder;
  folder.write("a.json", figure("one"));
  folder.write("b.json", figure("two", "albedo"));
  folder.write("c.json", figure("three", "g1"));
  for (const char* threads : {"1", "2", "7"})
    check_output(folder, "brdfplot plot a.json b.json c.json -o out" + std::string(threads) + " --threads " + threads);
  for (const auto& name : folder.list("out1")) {
    CHECK(folder.read("out1/" + name) == folder.read("out2/" + name));
    CHECK(folder.read("out1/" + name) == folder.read("out7/" + name));
  }
}

TEST_CASE("spheres are pictures within the SVG, the same on any number of threads") {
  const Folder folder;
  folder.write("a.json", R"({"id": "balls", "kind": "spheres", "title": "Balls", "caption": "Two.", "columns": 2,
  "material": {"distribution": {"type": "ggx", "alpha": 0.5}},
  "sphere": {"pixels": 64, "lights": [{"type": "sphere", "theta": 0.7, "phi": 2, "radius": "10deg", "radiance": 9}]},
  "panels": [{"title": "α = {alpha}", "sphere": {}, "for_each": {"variable": "alpha", "values": [0.2, 0.6]}}]})");
  for (const char* threads : {"1", "3"})
    CHECK(check_output(folder, "brdfplot plot a.json -o out" + std::string(threads) + " --threads " + threads) == "");
  const std::string svg = folder.read("out1/balls.svg"), csv = folder.read("out1/balls.csv");
  CHECK(svg == folder.read("out3/balls.svg"));
  CHECK(csv == folder.read("out3/balls.csv"));
  CHECK(csv.starts_with("panel,series,position,radiance\nα = 0.2,radiance,-0.99,0\n"));
  CHECK(csv.find("α = 0.2,above_white,,0.0") != std::string::npos);
  CHECK(std::ranges::count(csv, '\n') == 1 + 2 * 100 + 1);
  std::size_t pictures = 0;
  for (auto at = svg.find("href=\"data:image/png;base64,iVBORw0KGgo"); at != std::string::npos;
       at = svg.find("href=\"data:image/png;base64,iVBORw0KGgo", at + 1))
    ++pictures;
  CHECK(pictures == 2);
}

TEST_CASE("progress") {
  const Folder folder;
  folder.write("a.json", figure("one"));
  const Outcome outcome = run(folder, "brdfplot plot a.json -o out --progress always");
  CHECK(outcome.code == 0);
  CHECK(outcome.out == "");
  CHECK(outcome.err.starts_with("1/1, "));
  for (const char* flags : {"", "--progress never", "--progress auto", "--quiet"})
    CHECK(check_output(folder, "brdfplot plot a.json -o out " + std::string(flags)) == "");
}

TEST_CASE("the first estimate of the time left knows that long tasks come first") {
  const Folder folder;
  // One simulation of a million paths, and then six of a few: by their number the rest would take six times as long.
  const auto series = [](const std::string& alpha, const std::string& paths) {
    return R"({"quantity": "brdf_cos", "label": ")" + alpha + R"(", "at": {"alpha": )" + alpha +
           R"(}, "simulate": {"source": "surface", "paths": )" + paths +
           R"(, "realisations": 2, "cells": 64, "samples": 9}})";
  };
  std::string all = series("0.5", "1000000");
  for (const char* alpha : {"0.6", "0.7", "0.8", "0.9", "1.0", "1.1"}) all += ", " + series(alpha, "2000");
  folder.write("a.json", R"({"id": "a", "kind": "polar", "title": "T", "caption": "C",
    "material": {"distribution": {"type": "beckmann", "alpha": 0.5}}, "at": {"theta_o": 1},
    "x": {"variable": "theta_i", "from": "-90deg", "to": "90deg"}, "panels": [{"series": [)" +
                             all + "]}]}");
  const auto began = std::chrono::steady_clock::now();
  const Outcome outcome = run(folder, "brdfplot plot a.json -o out --progress always --threads 1 --cache ''");
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const auto left = outcome.err.find(" s left");
  REQUIRE(left != std::string::npos);
  CHECK(outcome.err.starts_with("1/8, "));
  const auto comma = outcome.err.rfind(", ", left);
  CHECK(std::stod(outcome.err.substr(comma + 2, left - comma - 2)) < seconds);
}

TEST_CASE("figures that fail leave the folder as it was") {
  const Folder folder;
  fs::create_directory(folder.path() / "out");
  folder.write("out/one.csv", "as it was");
  folder.write("a.json", figure("one"));
  folder.write("same.json", figure("one"));
  check_error(folder, "brdfplot plot a.json same.json -o out", 2, {"same.json: /id: found \"one\"", "a.json"});
  folder.write("typo.json", figure("two", "lamda"));
  check_error(folder, "brdfplot plot a.json typo.json -o out", 2, {"typo.json: /panels/0/series/0", "\"lamda\""});
  folder.write("missing.json", figure("two", "brdf"));
  check_error(folder, "brdfplot plot a.json missing.json -o out", 2, {"omega_i"});
  // No rule is that accurate where a shape ends with a jump.
  folder.write("fine.json", figure("two", "furnace", R"(custom", "shape": "t2 < 1 ? 1 : 0)", "1e-13"));
  check_error(folder, "brdfplot plot a.json fine.json -o out", 4,
              {"brdfplot: error: two, ", "series \"curve\": furnace: reached an error estimate of ", "(asked: 1e-13)"});
  CHECK(folder.list("out") == std::vector<std::string>{"one.csv"});
  CHECK(folder.read("out/one.csv") == "as it was");
}

TEST_CASE("the last guard: what is no number in a figure is exit code 4, with the place") {
  const Folder folder;
  const auto masked = [](const std::string& text) {
    std::string out = text;
    const std::string material = R"("material": {)";
    out.insert(out.find(material) + material.size(),
               R"("masking": {"type": "custom", "lambda": "theta > 1 ? -1 : 0"}, )");
    return out;
  };
  fs::create_directory(folder.path() / "out");
  folder.write("g1.json", masked(figure("one", "g1")));
  check_error(folder, "brdfplot plot g1.json -o out", 4, {"one, panel 1, series \"curve\": \"g1\": found inf"});
  folder.write("furnace.json", masked(figure("one", "furnace")));
  check_error(folder, "brdfplot plot furnace.json -o out", 4, {"one, panel 1, series \"curve\": furnace: "});
  std::string ratio = figure("one");
  const std::string quantity = R"("quantity": "lambda")";
  const std::string difference = R"({"difference": [{"quantity": "g1"}, {"quantity": "g1"}]})";
  ratio.replace(ratio.find(quantity), quantity.size(), R"("ratio": [)" + difference + ", " + difference + "]");
  folder.write("ratio.json", ratio);
  check_error(folder, "brdfplot plot ratio.json -o out", 4,
              {"one, panel 1, series \"curve\": found ", "nan at theta_o = 0.1; accepted: a finite number"});
  CHECK(folder.list("out").empty());
}

TEST_CASE("Ctrl-C while figures are computed") {
  const Folder folder;
  fs::create_directory(folder.path() / "out");
  Process process(folder, "exec brdfplot plot configs/figures/fig1*.json -o out --threads 1");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(outcome.code == 130);
  CHECK(folder.list("out").empty());
}

TEST_CASE("simulated results are kept, and what is wrong with them does no harm") {
  const Folder folder;
  std::string text = figure("one", "albedo");
  text.replace(text.find(R"("quantity")"), 0, R"("simulate": {"source": "smith_walk", "paths": 640, "samples": 3}, )");
  folder.write("a.json", text);
  CHECK(check_output(folder, "brdfplot plot a.json -o first --cache kept --threads 1") == "");
  const auto kept = folder.list("kept/v2");
  CHECK(kept.size() == 3);
  CHECK(folder.read("first/one.csv").starts_with("panel,series,theta_o,value,value_stderr\n"));
  // A result that was changed with its checksum would be believed; one that was only cut is not.
  folder.write("kept/v2/" + kept[0], "brdfplot simulation 2");
  for (const char* cache : {"kept", "kept", "other", "''", "a.json"}) {
    CHECK(check_output(folder, "brdfplot plot a.json -o again --threads 3 --cache " + std::string(cache)) == "");
    CHECK(folder.read("again/one.csv") == folder.read("first/one.csv"));
    CHECK(folder.read("again/one.svg") == folder.read("first/one.svg"));
  }
  CHECK(folder.list("other/v2") == kept);
}
