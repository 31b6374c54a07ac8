#include "cli/program.hpp"

using namespace test;

namespace {

const std::string rough = R"({"name": "rough", "distribution": {"type": "ggx", "alpha": 0.5}})";
const std::string gold = R"({"name": "gold", "distribution": {"type": "ggx", "alpha": 0.2},
  "fresnel": {"type": "conductor", "eta": [0.14, 0.38, 1.44], "k": [3.98, 2.39, 1.6]}})";

void write_materials(const Folder& folder) {
  folder.write("rough.json", rough);
  folder.write("gold.json", gold);
}

/// The labels of the series of a CSV, each once, in their order.
std::vector<std::string> series_of(const std::string& csv) {
  std::vector<std::string> labels;
  for (const auto& row : cells(csv))
    if (row[1] != "series" && std::ranges::find(labels, row[1]) == labels.end()) labels.push_back(row[1]);
  return labels;
}

} // namespace

TEST_CASE("figures are laid out for paper, whatever the format") {
  const Folder folder;
  write_materials(folder);
  const std::string draw = "brdfplot plot rough.json -q g1 ";
  check_output(folder, draw + "--width 84mm -o a.svg");
  const std::string svg = folder.read("a.svg");
  // The numbers at the axes have 12 units, which are 8 points of 25.4/72 mm.
  CHECK(svg.find(" width=\"84mm\" ") != std::string::npos);
  CHECK(svg.find(" viewBox=\"0 0 357.17 ") != std::string::npos);
  check_output(folder, draw + "--width acm --font-size 6pt -o b.svg --no-title");
  CHECK(folder.read("b.svg").find(" width=\"84.7mm\" ") != std::string::npos);
  CHECK(folder.read("b.svg").find(" viewBox=\"0 0 480.19 ") != std::string::npos);
  CHECK(svg.find("bp-title") != std::string::npos);
  CHECK(folder.read("b.svg").find("bp-title") == std::string::npos);
  check_output(folder, draw + "--width nature-page -o folder");
  CHECK(folder.read("folder/rough_g1.svg").find(" width=\"183mm\" ") != std::string::npos);
  check_output(folder, draw + "--width 84mm -o a.pdf");
  CHECK(folder.read("a.pdf").find("/FontFile") != std::string::npos); // of every font, one is enough to see
}

TEST_CASE("one line draws a quantity of a material: lobes and curves, in every format") {
  const Folder folder;
  write_materials(folder);
  CHECK(check_output(folder, "brdfplot plot rough.json -q brdf --at theta_o=60deg -o lobe.svg") == "");
  CHECK(folder.read("lobe.svg").find("rough") != std::string::npos);
  check_output(folder, "brdfplot plot rough.json -q brdf --at theta_o=60deg -o lobe.png");
  CHECK(folder.read("lobe.png").starts_with("\x89PNG"));
  check_output(folder, "brdfplot plot rough.json -q brdf --at theta_o=60deg -o lobe.pdf --width 84mm");
  CHECK(folder.read("lobe.pdf").starts_with("%PDF"));
  CHECK(folder.read("lobe.pdf").find("MediaBox [ 0 0 238.11") != std::string::npos); // 84 mm in points
  check_output(folder, "brdfplot plot rough.json -q g1 -o g1.csv");
  CHECK(folder.read("g1.csv").starts_with("panel,series,theta_o,value\n,,0,1\n"));
  CHECK(check_output(folder, "brdfplot plot rough.json -q g1 -o -").find("<svg") != std::string::npos);
  check_output(folder, "brdfplot plot rough.json -q g1,d -o two");
  CHECK(folder.list("two") == std::vector<std::string>{"rough_g1.csv", "rough_g1.svg"});
  CHECK(folder.read("two/rough_g1.csv").starts_with("panel,series,theta_o,theta_m,value\n"));
}

TEST_CASE("the values of a quick figure are those of eval") {
  const Folder folder;
  write_materials(folder);
  check_output(
      folder, "brdfplot plot rough.json -q brdf_cos --at theta_o=45deg --at theta_i=-30deg --x alpha=0.2:0.8 -o a.csv");
  const auto rows = cells(folder.read("a.csv"));
  folder.write("points.csv", "theta_o,theta_i\n45deg,-30deg\n");
  folder.write("soft.json", R"({"distribution": {"type": "ggx", "alpha": 0.2}})");
  const auto expected = cells(check_output(folder, "brdfplot eval soft.json -q brdf_cos -i points.csv"));
  CHECK(rows[1][2] == "0.2");
  CHECK(rows[1][3] == expected[1].back());
}

TEST_CASE("series of a quick figure: values, models, materials and channels") {
  const Folder folder;
  write_materials(folder);
  const auto labels = [&](const std::string& flags) {
    check_output(folder, "brdfplot plot " + flags + " -o a.csv");
    return series_of(folder.read("a.csv"));
  };
  CHECK(labels("rough.json -q g1 --over alpha=0.1,0.3") == std::vector<std::string>{"α = 0.1", "α = 0.3"});
  CHECK(labels("rough.json -q g1 --vs masking=v_cavity") == std::vector<std::string>{"rough", "masking = v_cavity"});
  CHECK(labels("rough.json -q g1 --vs gold.json") == std::vector<std::string>{"rough", "gold"});
  labels("rough.json -q brdf --vs gold.json"); // labels with a comma are quoted
  for (const char* label : {"\n,rough,", "\n,\"gold, r\",", "\n,\"gold, g\",", "\n,\"gold, b\","})
    CHECK(folder.read("a.csv").find(label) != std::string::npos);
  CHECK(labels("gold.json -q brdf --channel luminance") == std::vector<std::string>{""});
  CHECK(labels(R"(-m '{"distribution": {"type": "beckmann", "alpha": 1}}' -q lambda)") == std::vector<std::string>{""});
  CHECK(labels("gold.json -q fresnel") == std::vector<std::string>{"r", "g", "b"});
}

TEST_CASE("a quick figure is saved as the figure file that it stands for") {
  const Folder folder;
  write_materials(folder);
  fs::create_directories(folder.path() / "kept");
  check_output(
      folder,
      "brdfplot plot rough.json -q brdf --over alpha=0.2,0.4 --vs gold.json -o direct.svg --save kept/figure.json");
  CHECK(folder.read("kept/figure.json").find("\"../rough.json\"") != std::string::npos);
  check_output(folder, "brdfplot plot kept/figure.json -o again.svg");
  CHECK(folder.read("again.svg") == folder.read("direct.svg"));
  CHECK(check_output(folder, "brdfplot validate kept/figure.json").find("figure") != std::string::npos);
}

TEST_CASE("several quantities are panels, each of its own kind") {
  const Folder folder;
  write_materials(folder);
  check_output(folder, "brdfplot plot rough.json -q g1,brdf,albedo --at theta_o=60deg -o a.csv --save a.json");
  const std::string saved = folder.read("a.json");
  CHECK(saved.find("\"kind\": \"lines\"") != std::string::npos);
  CHECK(saved.find("\"kind\": \"polar\"") != std::string::npos);
  const auto rows = cells(folder.read("a.csv"));
  CHECK(rows[0] == std::vector<std::string>{"panel", "series", "theta_o", "theta_i", "value"});
  // G1 and the albedo go over theta_o, which is fixed for the lobe alone.
  check_output(folder, "brdfplot plot rough.json -q g1 -o g1.csv");
  check_output(folder, "brdfplot plot rough.json -q brdf --at theta_o=60deg -o brdf.csv");
  const auto values = [&](const std::string& panel) {
    std::vector<std::string> out;
    for (const auto& row : rows)
      if (row[0] == panel) out.push_back(row[2] + row[3] + " " + row[4]);
    return out;
  };
  for (const auto& [panel, file] : {std::pair{"G_1", "g1.csv"}, {"ρ", "brdf.csv"}}) {
    std::vector<std::string> alone;
    for (const auto& row : cells(folder.read(file)))
      if (row[0] != "panel") alone.push_back(row[2] + " " + row[3]);
    CHECK(values(panel) == alone);
  }
  CHECK(values("albedo").size() > 10);
  check_output(folder, "brdfplot plot a.json -o b.csv");
  CHECK(folder.read("b.csv") == folder.read("a.csv"));
}

TEST_CASE("wrong words of a quick figure") {
  const Folder folder;
  write_materials(folder);
  check_error(folder, "brdfplot plot rough.json -q bdrf -o a.svg", 2, {"-q", "\"bdrf\"", "did you mean \"brdf\""});
  check_error(folder, "brdfplot plot rough.json -q brdf --at theta_o -o a.svg", 2,
              {"--at", "\"theta_o\"", "VARIABLE=VALUE"});
  check_error(folder, "brdfplot plot rough.json -q g2 --at theta_o=1 --at theta_i=1 -o a.svg", 2,
              {"nothing is left to sweep for g2"});
  check_error(folder, "brdfplot plot rough.json -q g1 --at alhpa=1 -o a.svg", 2, {"alhpa"});
  check_error(folder, "brdfplot plot rough.json -q g1 --x theta_o=1 -o a.svg", 2, {"--x", "VARIABLE=FROM:TO"});
  check_error(folder, "brdfplot plot rough.json -q g1 --width 84mm -o a.csv", 2, {"--width", "FILE.svg, .png or .pdf"});
  check_error(folder, "brdfplot plot rough.json -q g1 --no-title --save a.json", 2, {"--no-title", "FILE.svg"});
  check_error(folder, "brdfplot plot rough.json -q g1 --width wide -o a.png", 2, {"--width", "\"wide\"", "ieee"});
  check_error(folder, "brdfplot plot rough.json -q g1 --font-size 9pt -o a.png", 2, {"--font-size", "--width"});
  check_error(folder, "brdfplot plot rough.json -q g1 --width acm --font-size 0pt -o a.png", 2,
              {"--font-size", "\"0pt\""});
  check_error(folder, "brdfplot plot rough.json -q brdf --channel red -o a.svg", 2,
              {"--channel", "\"red\"", "accepted: r, g, b, luminance, rgb"});
  check_error(folder, "brdfplot plot rough.json -o a.svg", 2, {"rough.json", "-q"});
  check_error(folder, "brdfplot plot -q g1 -o a.svg", 2, {"a material is missing"});
  check_error(folder, R"(brdfplot plot -m '{"distribution": {"type": "gxg"}}' -q g1 -o a.svg)", 2,
              {"-m: /distribution", "gxg"});
  check_error(folder, "PATH=/nowhere \"$(command -v brdfplot)\" plot rough.json -q g1 -o a.png", 3,
              {"a.png: rsvg-convert was not found"});
  CHECK(!folder.has("a.svg"));
  CHECK(!folder.has("a.png"));
}
