#include "cli/program.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

using namespace test;

namespace {

const std::string manifest = R"({
  "title": "Two things", "introduction": "They are small.",
  "entries": [
    {"section": "Curves", "figure": "curve.json"},
    {"section": "Tables", "table": {"id": "properties", "title": "Properties^{2}", "caption": "Up to 10^{-6}.",
      "maskings": ["smith", "implicit"], "distributions": ["beckmann", "ggx"], "alpha": [0.3], "theta_o": ["60deg"]}},
    {"section": "Tables", "data": {"id": "measured", "title": "Measured", "caption": "Elsewhere.", "file": "data.csv"}}
  ]})";

const std::string curve =
    R"({"id": "curve", "kind": "lines", "title": "A curve", "caption": "One. It begins at {first}.",
  "numbers": {"first": {"series": "GGX", "x": 0.1, "digits": 3}},
  "x": {"variable": "theta_o", "from": 0.1, "to": 1.5}, "y": {"label": "y"},
  "material": {"distribution": {"type": "ggx", "alpha": 0.5}},
  "panels": [{"series": [{"label": "GGX", "quantity": "g1"}]}]})";

void write_report(const Folder& folder) {
  folder.write("report.json", manifest);
  folder.write("curve.json", curve);
  folder.write("data.csv", "function,error\nf,0.5\n");
}

/// Makes a report of the source tree in out/; in a sampled run without the figures `left_out`, which take longest and
/// whose data are not looked at.
void make_report(const Folder& folder, const std::string& name, const std::vector<std::string>& left_out) {
  std::string manifest_path = "configs/reports/" + name + ".json";
  if (sampled()) {
    auto report = nlohmann::ordered_json::parse(folder.read(manifest_path));
    auto kept = nlohmann::ordered_json::array();
    std::size_t found = 0;
    for (auto& entry : report.at("entries")) {
      const fs::path figure = entry.value("figure", "");
      if (std::ranges::find(left_out, figure.stem().string()) != left_out.end())
        ++found;
      else if (!figure.empty()) {
        entry["figure"] = ("configs/reports" / figure).lexically_normal().string();
        kept.push_back(entry);
      }
    }
    REQUIRE(found == left_out.size());
    report["entries"] = kept;
    manifest_path = "sample.json";
    folder.write(manifest_path, report.dump());
  }
  check_output(folder, "brdfplot report " + manifest_path + " -o out --quiet");
}

} // namespace

TEST_CASE("the folder of a report") {
  const Folder folder;
  write_report(folder);
  CHECK(check_output(folder, "brdfplot report report.json -o out") == "");
  CHECK(folder.list("out") == std::vector<std::string>{"figures", "index.html", "report.json", "tables"});
  CHECK(folder.list("out/figures") == std::vector<std::string>{"curve.csv", "curve.json", "curve.svg"});
  CHECK(folder.list("out/tables") == std::vector<std::string>{"measured.csv", "measured.json", "measured.md",
                                                              "properties.csv", "properties.json", "properties.md"});
  CHECK(folder.read("out/tables/measured.csv") == folder.read("data.csv"));
  CHECK(folder.read("out/tables/measured.md") ==
        "# Measured\n\nElsewhere.\n\n| function | error |\n| --- | --- |\n| f | 0.5 |\n");

  const auto rows = cells(folder.read("out/tables/properties.csv"));
  REQUIRE(rows.size() == 5);
  const std::vector<std::string> header(rows[0].begin(), rows[0].begin() + 11);
  CHECK(header == std::vector<std::string>{"distribution", "masking", "eq14_max_residual", "eq14_holds",
                                           "eq18_max_residual", "eq18_holds", "eq36_max_residual", "eq36_holds",
                                           "eq37_max_residual", "eq37_holds", "physically_based"});
  CHECK(rows[0][11] == "eq14_alpha");
  for (std::size_t r = 1; r < 5; ++r) {
    CHECK(rows[r][0] == (r % 2 == 1 ? "beckmann" : "ggx"));
    CHECK(rows[r][1] == (r < 3 ? "smith" : "implicit"));
    CHECK(rows[r][10] == (r < 3 ? "true" : "false"));
    for (const std::size_t column : {2U, 4U, 6U, 8U}) CHECK((std::stod(rows[r][column]) < 1e-7) == (r < 3));
    CHECK(rows[r][11] == (r < 3 ? "" : "0.3")); // where rounding is largest says nothing
  }
  const std::string markdown = folder.read("out/tables/properties.md");
  CHECK(markdown.starts_with("# Properties"));
  CHECK(markdown.find("| smith | ggx | ✓ ") != std::string::npos);
  CHECK(markdown.find("| implicit | ggx | ✗ ") != std::string::npos);
  CHECK(markdown.find('{') == std::string::npos);

  // As the paper has it first: a row for each masking function.
  CHECK(markdown.find("| masking | Eq. 14 |") < markdown.find("| masking | distribution |"));
  CHECK(markdown.find("| smith | ✓ ") != std::string::npos);
  CHECK(markdown.find("| implicit | ✗ ") != std::string::npos);
  CHECK(folder.read("out/figures/curve.json") == curve);

  const auto record = nlohmann::json::parse(folder.read("out/report.json"));
  REQUIRE(record.at("entries").size() == 3);
  for (const auto& entry : record["entries"])
    for (const auto& file : entry.at("files")) CHECK(folder.has("out/" + file.get<std::string>()));
  CHECK(record["entries"][1].at("rows").size() == 4);
  CHECK(folder.read("out/index.html").find("They are small.") != std::string::npos);
  CHECK(folder.read("out/index.html").find("One. It begins at 0.999.") != std::string::npos);
}

TEST_CASE("the report on Kelemen and Szirmay-Kalos: what its captions say is what its data are") {
  const Folder folder;
  make_report(folder, "kelemen2001", {});
  const auto rows_of = [&](const std::string& figure) { return cells(folder.read("out/figures/" + figure + ".csv")); };
  // Eq. 2: too dark, by half at most; nothing is lost by the coupled model; rho cos stays in the mirror direction.
  double least = 1, most = 0, least_at_45 = 1;
  for (const auto& row : rows_of("kelemen_geometric_term")) {
    if (row[0] == "panel") continue;
    least = std::min(least, std::stod(row[3]));
    most = std::max(most, std::stod(row[3]));
    if (row[1] == "θ_o = 45°") least_at_45 = std::min(least_at_45, std::stod(row[3]));
  }
  CHECK(least_at_45 == doctest::Approx(0.5).epsilon(1e-6));
  CHECK(least == doctest::Approx(0.5).epsilon(1e-6));
  CHECK(most <= 1 + 1e-12);
  std::size_t totals = 0;
  for (const auto& row : rows_of("kelemen_fig5_total"))
    if (row[row.size() - 3] == "both") { // a panel's title has a comma
      CHECK(std::fabs(std::stod(row.back()) - 1) < 1e-6);
      ++totals;
    }
  CHECK(totals == 4); // a straight line has its ends
  for (const auto& row : rows_of("kelemen_off_specular"))
    if (row[0] == "ρ cos θ_i") CHECK(std::fabs(std::stod(row[3])) < 1e-8);
  // The peaks of Fig. 2: the half vector is inclined by a < 0 where the derivative of ln f vanishes,
  // -2 tan a / (m^2 cos^2 a) + 3 tan a - 2 tan(theta_o - a) = 0; the light is 2 a beyond the mirror direction.
  const std::string page = folder.read("out/index.html");
  for (const auto& [degrees, named] : {std::pair(22.5, "0.488°"), std::pair(45.0, "1.19°"), std::pair(67.5, "3.03°")}) {
    const double theta = degrees * std::numbers::pi / 180, m = 0.1;
    double low = -0.2, high = 0;
    for (int step = 0; step < 100; ++step) {
      const double a = 0.5 * (low + high), t = std::tan(a);
      const double slope = -2 * t * (1 + t * t) / (m * m) + 3 * t - 2 * std::tan(theta - a);
      (slope > 0 ? low : high) = a;
    }
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.3g°", -2 * low * 180 / std::numbers::pi);
    CHECK(text.data() == std::string(named));
    CHECK(page.find(named) != std::string::npos);
  }
}

TEST_CASE("the report on Real-Time Rendering: what its captions say is what its data are") {
  const Folder folder;
  make_report(folder, "rtr4-chapter9",
              {"rtr_multiple_bounce_anisotropic", "rtr_fig9_39_spheres", "rtr_fig9_41_spheres", "rtr_furnace_spheres",
               "rtr_averaged_normals"});
  // Panels may sweep several variables; the value stands in the column of its name.
  const auto value_in = [](const std::vector<std::vector<std::string>>& rows, const std::vector<std::string>& row) {
    return std::stod(row.at(static_cast<std::size_t>(std::ranges::find(rows[0], "value") - rows[0].begin())));
  };
  const auto last_of = [&](const std::string& figure, const std::string& panel, const std::string& series) {
    double last = 0, least = 1e300;
    const auto rows = cells(folder.read("out/figures/" + figure + ".csv"));
    for (const auto& row : rows)
      if (row[0] == panel && row[1] == series) {
        last = value_in(rows, row);
        least = std::min(least, last);
      }
    return std::pair(last, least);
  };
  const auto [disney, least_disney] = last_of("rtr_diffuse_albedo", "rough", "Disney (9.66)");
  const auto [hammon, least_hammon] = last_of("rtr_diffuse_albedo", "rough", "Hammon (9.68)");
  CHECK(std::fabs(disney - 1.52) < 0.005);
  CHECK(std::fabs(hammon - 1.15) < 0.005);
  CHECK(std::min(least_disney, least_hammon) > 1);
  CHECK(std::fabs(last_of("rtr_diffuse_albedo", "rough", "Oren–Nayar").first - 1.02) < 0.005);
  CHECK(std::fabs(last_of("rtr_diffuse_albedo", "rough", "EON").first - 1) < 1e-6);
  const auto most_of = [&](const std::string& figure, const std::string& panel, const std::string& series) {
    std::pair<double, double> most{0, 0};
    const auto rows = cells(folder.read("out/figures/" + figure + ".csv"));
    for (const auto& row : rows)
      if (row[0] == panel && row[1] == series && value_in(rows, row) > most.first)
        most = {value_in(rows, row), row[2].empty() ? 0 : std::stod(row[2]) * 180 / std::numbers::pi};
    return most;
  };
  CHECK(std::fabs(most_of("rtr_coat", "base alone", "both ways").first - 0.872) < 0.0005);
  CHECK(most_of("rtr_coat", "coat and base", "both ways").first < 1);
  const auto half = most_of("rtr_coat", "coat and base", "half: the viewer’s alone");
  CHECK(std::fabs(half.first - 1.0005) < 0.00005);
  CHECK(std::fabs(half.second - 46) < 0.5);
  CHECK(std::fabs(last_of("rtr_coat", "coat and base", "at the half vector").first - 1.31) < 0.005);
  CHECK(std::fabs(last_of("rtr_coat", "coat and base", "none").first - 1.39) < 0.005);
  CHECK(std::fabs(last_of("rtr_wrap", "all light", "printed").first - 1.5) < 1e-9);
  CHECK(std::fabs(last_of("rtr_wrap", "all light", "ratio").first - 2) < 1e-9);
  CHECK(std::fabs(most_of("rtr_wrap", "all light", "conserving").first - 1) < 1e-9);
  CHECK(std::fabs(last_of("rtr_wrap", "all light", "conserving").second - 1) < 1e-9);
  // The first power of mean F is seven times the square where f0 = 0.1; the square is a third too dark at 85deg.
  const auto at_85 = [&](const std::string& panel, const std::string& series) {
    return last_of("rtr_multiple_bounce", panel, series).first;
  };
  CHECK(std::fabs(at_85("f0 = 0.1", "printed") / at_85("f0 = 0.1", "energy") - 7) < 0.1);
  CHECK(std::fabs(at_85("f0 = 0.5", "energy") / at_85("f0 = 0.5", "walk") - 2.0 / 3) < 0.03);
  CHECK(at_85("f0 = 0.1", "energy") < 0.5 * at_85("f0 = 0.1", "walk"));
  CHECK(std::fabs(at_85("f0 = 1", "energy") - at_85("f0 = 1", "walk")) < 0.01);
}

TEST_CASE("the report on sampling: what its captions say is what its data are") {
  const Folder folder;
  make_report(folder, "sampling", {"sampling_winner"});
  /// The value of a series of a panel at its first or its last theta_o, and its extremes.
  struct Curve {
    double first = 0, last = 0, largest = 0;
  };
  const auto curve_of = [&](const std::string& figure, const std::string& panel, const std::string& series) {
    Curve found;
    bool begun = false;
    for (const auto& row : cells(folder.read("out/figures/sampling_" + figure + ".csv"))) {
      if (row[0] != panel || row[1] != series) continue;
      const double value = std::stod(row.back());
      if (!begun) found.first = value;
      begun = true;
      found.last = value;
      found.largest = std::fmax(found.largest, value);
    }
    CAPTURE(panel);
    CAPTURE(series);
    REQUIRE(begun);
    return found;
  };
  const auto within = [](double value, double said, double half) { return std::fabs(value - said) <= half; };

  const Curve half_01 = curve_of("variance", "GGX with α = 0.1", "half vector");
  const Curve seen_01 = curve_of("variance", "GGX with α = 0.1", "visible normals");
  const Curve half_05 = curve_of("variance", "GGX with α = 0.5", "half vector");
  const Curve seen_05 = curve_of("variance", "GGX with α = 0.5", "visible normals");
  CHECK(within(half_01.last / seen_01.last, 630, 5));
  CHECK(within(half_05.last / seen_05.last, 370, 5));
  CHECK(within(curve_of("variance", "GGX with α = 0.5", "cosine").first, 0.018, 0.0005));
  CHECK(within(seen_05.first, 0.15, 0.005));
  double most = 0, most_half = 0;
  for (const std::string panel :
       {"GGX with α = 0.1", "GGX with α = 0.5", "Beckmann with α = 0.1", "Beckmann with α = 0.5"}) {
    most = std::fmax(most, curve_of("variance", panel, "visible normals").largest);
    most_half = std::fmax(most_half, curve_of("variance", panel, "half vector").largest);
  }
  CHECK(most == seen_05.first);
  CHECK(within(most_half, 7.0, 0.05));

  // The cosine is the worst for narrow lobes and the best for wide ones near the normal; visible normals at grazing.
  for (const std::string distribution : {"GGX", "Beckmann"})
    for (const std::string alpha : {"0.1", "0.5"}) {
      const std::string panel = distribution + " with α = " + alpha;
      const Curve cosine = curve_of("cost", panel, "cosine"), half = curve_of("cost", panel, "half vector"),
                  seen = curve_of("cost", panel, "visible normals");
      CHECK(half.first < seen.first);
      CHECK((alpha == "0.1" ? cosine.first > seen.first : cosine.first < half.first));
      CHECK(seen.last < std::fmin(cosine.last, half.last));
    }

  double of_cosine = 0, of_half = 0, of_seen = 0;
  for (const auto& row : cells(folder.read("out/figures/sampling_largest_weight.csv"))) {
    if (row[0] == "panel") continue;
    double& largest = row[0] == "cosine" ? of_cosine : row[0] == "half vector" ? of_half : of_seen;
    largest = std::fmax(largest, std::stod(row.back()));
  }
  CHECK(of_seen <= 1 + 1e-9);
  CHECK(within(of_half, 183, 0.5));
  CHECK(within(of_cosine, 23000, 50));

  for (const std::string m : {"m = 0.1", "m = 0.4", "m = 0.8"}) {
    const Curve largest = curve_of("kelemen", "largest cos θ_i / cos β", m);
    CHECK(within(largest.last, 1.88, 0.005));
    CHECK(largest.largest == largest.last);
    CHECK(within(largest.first, 1, 0.005));
    const Curve variance = curve_of("kelemen", "variance", m);
    CHECK((variance.last > 0.605 && variance.last < 0.755));
    if (m == "m = 0.1") CHECK(within(variance.first, 0.000215, 5e-6));
    if (m == "m = 0.8") CHECK(within(variance.first, 0.11, 0.005));
  }

  const Curve by_cosine = curve_of("diffuse", "eon with r = 1", "cosine"),
              by_eon = curve_of("diffuse", "eon with r = 1", "eon");
  CHECK(within(by_cosine.last, 1.25, 0.005));
  CHECK(within(by_eon.last, 0.036, 0.0005));
  CHECK(within(by_cosine.last / by_eon.last, 35, 0.5));
  const std::string both = "Kelemen–Szirmay-Kalos with m = 0.4";
  const Curve usual = curve_of("diffuse", both, "half vector and cosine"), own = curve_of("diffuse", both, "their own");
  CHECK(within(own.first, 0.00016, 5e-6));
  CHECK(within(usual.first, 0.00060, 5e-6));
  CHECK(within(own.last, 0.44, 0.005));
  CHECK(within(usual.last, 0.38, 0.005));
}

TEST_CASE("figures and tables of a report are the same bytes on any number of threads") {
  const Folder folder;
  write_report(folder);
  for (const char* threads : {"1", "7"})
    check_output(folder, "brdfplot report report.json -o out" + std::string(threads) + " --threads " + threads);
  for (const char* name : {"figures/curve.svg", "figures/curve.csv", "tables/properties.csv", "tables/properties.md"})
    CHECK(folder.read("out1/" + std::string(name)) == folder.read("out7/" + std::string(name)));
}

TEST_CASE("a report removes what it wrote earlier, and nothing else") {
  const Folder folder;
  write_report(folder);
  fs::create_directories(folder.path() / "out/figures/kept.svg");
  fs::create_directories(folder.path() / "out/tables");
  for (const char* name : {"out/figures/old.svg", "out/figures/old.csv", "out/figures/old.json", "out/tables/old.md",
                           "out/figures/notes.txt", "out/mine.csv", "out/figures/curve.csv"})
    folder.write(name, "old");
  check_output(folder, "brdfplot report report.json -o out");
  CHECK(folder.list("out/figures") ==
        std::vector<std::string>{"curve.csv", "curve.json", "curve.svg", "kept.svg", "notes.txt"});
  CHECK(folder.list("out/tables") == std::vector<std::string>{"measured.csv", "measured.json", "measured.md",
                                                              "properties.csv", "properties.json", "properties.md"});
  CHECK(folder.has("out/mine.csv"));
  CHECK(folder.read("out/figures/curve.csv") != "old");
}

TEST_CASE("a report that fails leaves the folder as it was") {
  const Folder folder;
  write_report(folder);
  check_output(folder, "brdfplot report report.json -o out");
  const std::string page = folder.read("out/index.html");
  std::string broken = curve;
  broken.replace(broken.find("\"g1\""), 4, "\"g2\""); // without omega_i
  folder.write("curve.json", broken);
  check_error(folder, "brdfplot report report.json -o out", 2, {"omega_i"});
  CHECK(folder.read("out/index.html") == page);
  CHECK(folder.list("out/figures") == std::vector<std::string>{"curve.csv", "curve.json", "curve.svg"});
}

TEST_CASE("a report that cannot be written whole leaves the old one") {
  const Folder folder;
  write_report(folder);
  check_output(folder, "brdfplot report report.json -o out");
  for (const char* name : {"figures/curve.svg", "figures/curve.csv", "report.json", "index.html"})
    folder.write("out/" + std::string(name), "as it was");
  fs::remove(folder.path() / "out/tables/properties.md");
  fs::create_directory(folder.path() / "out/tables/properties.md");
  check_error(folder, "brdfplot report report.json -o out", 3, {"out/tables/properties.md: cannot write: "});
  for (const char* name : {"figures/curve.svg", "figures/curve.csv", "report.json", "index.html"})
    CHECK(folder.read("out/" + std::string(name)) == "as it was");
  CHECK(folder.list("out/figures") == std::vector<std::string>{"curve.csv", "curve.json", "curve.svg"});
}

TEST_CASE("manifests that are wrong") {
  const Folder folder;
  write_report(folder);
  folder.write("a.json", R"({"title": "x", "entries": [{"section": "s", "figure": "nope.json"}]})");
  check_error(folder, "brdfplot report a.json -o out", 3, {"nope.json: cannot read"});
  folder.write("b.json", R"({"title": "x", "entires": []})");
  check_error(folder, "brdfplot report b.json -o out", 2, {"b.json: ", "\"entires\"", "\"entries\""});
  folder.write("c.json", R"({"title": "x", "entries": [{"section": "s", "figure": "curve.json"},
                                                     {"section": "s", "figure": "curve.json"}]})");
  check_error(folder, "brdfplot report c.json -o out", 2, {"c.json: /entries/1", "\"curve\""});
  folder.write("d.json",
               R"({"title": "x", "entries": [{"section": "s", "data": {"id": "m", "title": "M", "caption": "C",
    "file": "data.csv", "columns": ["function", "errors"]}}]})");
  check_error(folder, "brdfplot report d.json -o out", 2,
              {"d.json: /entries/0/data/columns/1", "\"errors\"", "\"error\""});
  folder.write("e.json", R"({"title": "x", "references": [{"cited": ["Me"], "text": "Me, 2014"}],
    "entries": [{"section": "s", "figure": "curve.json"}]})");
  check_error(folder, "brdfplot report e.json -o out", 2, {"e.json: /references/0", "doi", "url"});
  CHECK_FALSE(folder.has("out"));
}

TEST_CASE("numbers that are a paper's, references, a licence, and the columns of a table that are shown") {
  const Folder folder;
  write_report(folder);
  folder.write("report.json", R"({"title": "x", "paper": "Me 2014", "licence": "Free.",
    "references": [{"cited": ["Me 2014"], "text": "Me: On x.", "doi": "10.1/2"}],
    "entries": [{"section": "s", "figure": "curve.json", "number": "Fig. 7"},
      {"section": "s", "data": {"id": "m", "title": "M", "caption": "Of Me 2014.", "file": "data.csv", "columns": ["error"]}}]})");
  check_output(folder, "brdfplot report report.json -o out");
  const std::string page = folder.read("out/index.html");
  for (const char* text :
       {"<span class=\"number\">Fig. 7.</span>", "<strong>Fig. 7.</strong> One.", "<strong>Table R1.</strong>",
        "Of <a href=\"#reference-1\">Me 2014</a>.", "href=\"https://doi.org/10.1/2\"", "<br>Free.</footer>",
        "<th scope=\"col\" class=\"num\">error</th></tr>"})
    CHECK_MESSAGE(page.find(text) != std::string::npos, text);
  CHECK(page.find("Figure 1") == std::string::npos);
  CHECK(folder.read("out/tables/m.csv") == folder.read("data.csv"));
}

TEST_CASE("the JSON beside a figure stands by itself: what it refers to is in it") {
  const Folder folder;
  write_report(folder);
  folder.write("ggx.json", R"({"distribution": {"type": "ggx", "alpha": 0.5}})");
  std::string refers = curve;
  const std::string inline_material = R"({"distribution": {"type": "ggx", "alpha": 0.5}})";
  refers.replace(refers.find(inline_material), inline_material.size(), R"({"$ref": "ggx.json"})");
  folder.write("curve.json", refers);
  check_output(folder, "brdfplot report report.json -o out");
  check_output(folder, "brdfplot plot out/figures/curve.json -o again");
  CHECK(folder.read("again/curve.csv") == folder.read("out/figures/curve.csv"));
}

TEST_CASE("Ctrl-C during the built-in report") {
  const Folder folder;
  Process process(folder, "exec brdfplot report -o out");
  wait_for([&] { return folder.has("out"); });
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  CHECK(outcome.code == 130);
  CHECK(outcome.err == "brdfplot: error: interrupted\n");
  CHECK(folder.list("out").empty());
}
