#include "draw/html/page.hpp"

#include <doctest/doctest.h>

#include <string>

#include "draw/figures.hpp"
#include "draw/markup.hpp"
#include "draw/model.hpp"

namespace {

using namespace brdfplot::plot;
using plot_tests::count;

PageEntry entry_of(const Figure& figure, const std::string& section) {
  PageEntry entry;
  entry.id = figure.id;
  entry.section = section;
  entry.title = figure.title;
  entry.caption = "As α_x grows & shrinks, from heitz2014_x.";
  entry.svg = to_svg(figure);
  entry.csv = to_csv(figure);
  entry.json = "{\"id\": \"<" + figure.id + ">\"}";
  entry.seconds = 1.234;
  return entry;
}

Page page() {
  Page page;
  page.title = "Report <1>";
  page.introduction = "First & only.\n\nSecond.";
  page.footer = "made by brdfplot";
  page.entries.push_back(entry_of(plot_tests::lines_figure(), "One"));
  page.entries.push_back(entry_of(plot_tests::polar_figure(), "One"));
  page.entries.push_back(entry_of(plot_tests::heatmap_figure(), "Two"));
  PageEntry table;
  table.id = "verify";
  table.section = "Two";
  table.title = "Verification";
  table.table = {{"check", "D_{GGX}"}, {"energy", "1.5"}, {"<b>", "2e-3"}};
  page.entries.push_back(table);
  return page;
}

} // namespace

TEST_CASE("the page is well-formed, and all ids on it differ") {
  CHECK(plot_tests::fault_of(to_html(page()), {"meta", "link", "br", "wbr"}) == "");
  CHECK(plot_tests::fault_of(to_html(Page{}), {"meta", "link", "br", "wbr"}) == "");
}

TEST_CASE("the page needs nothing from outside") {
  const auto html = to_html(page());
  CHECK(count(html, "http://") == count(html, "xmlns=\"http://www.w3.org/2000/svg\""));
  CHECK(count(html, "https://") == 0);
  CHECK(count(html, "src=") == 0);
  CHECK(count(html, "@import") == 0);
  CHECK(count(html, "<link rel=\"icon\" href=\"data:,\">") == 1);
}

TEST_CASE("the page numbers figures and tables and links to them") {
  const auto html = to_html(page());
  CHECK(count(html, "<strong>Figure 3.</strong>") == 1);
  CHECK(count(html, "<strong>Table 1.</strong>") == 1);
  for (const char* id : {"g1", "lobes", "map", "verify", "section-1", "section-3"}) {
    CHECK(count(html, std::string(" id=\"") + id + "\"") == 1);
    CHECK(count(html, std::string("href=\"#") + id + "\"") == 1);
  }
  CHECK(count(html, "<h2>") == 2);
}

TEST_CASE("text of the page is escaped, and markup of labels becomes sub and sup") {
  const auto html = to_html(page());
  CHECK(count(html, "<title>Report &lt;1&gt;</title>") == 1);
  CHECK(count(html, "<p>First &amp; only.</p>\n<p>Second.</p>") == 1);
  CHECK(count(html, "As α<sub>x</sub> grows &amp; shrinks, from heitz2014_x.") == 3);
  CHECK(count(html, "{&quot;id&quot;: &quot;&lt;g1&gt;&quot;}") == 1);
  CHECK(count(html, "<th scope=\"col\" class=\"num\">D<sub>GGX</sub></th>") == 1);
  CHECK(count(html, "<td>&lt;b&gt;</td><td class=\"num\">2e-3</td>") == 1);
}

TEST_CASE("the page holds each thing once: drawings without their style, data deflated, links to the files beside it") {
  Page small;
  PageEntry entry;
  entry.id = "a";
  entry.csv = "x,y\n1,2\n";
  entry.json = "{}";
  entry.stem = "figures/a";
  entry.svg = to_svg(plot_tests::lines_figure());
  small.entries = {entry, entry};
  const auto html = to_html(small);
  CHECK(count(html, ".bp-halo{") == 1);
  CHECK(count(html, "<style") == 2); // of the page and of the drawings
  CHECK(count(html, "<script class=\"csv\" type=\"text/plain\">eN") == 2);
  for (const char* kind : {"svg", "csv", "json"}) {
    const std::string name(kind);
    CHECK(count(html, "<a data-file=\"" + name + "\" download href=\"figures/a." + name + "\">") == 2);
  }
  CHECK(count(html, "data-enlarge hidden") == 2);
  small.entries[1].stem.clear(); // no files beside the page: a script makes them
  CHECK(count(to_html(small), "<a data-file=\"csv\" hidden download href=\"a.csv\">") == 1);
}

TEST_CASE("numbers are the paper's, or the page's beside them") {
  Page of_paper = page();
  of_paper.paper = "Me 2014";
  of_paper.entries[1].number = "Fig. 2";
  of_paper.entries[1].caption = "Me 2014, Fig. 2: lobes.";
  of_paper.references = {{{"Me 2014"}, "Me: On x_1.", "https://doi.org/10.1/2"}, {{"Me"}, "Me.", "https://a.b/?c&d"}};
  const auto html = to_html(of_paper);
  CHECK(plot_tests::fault_of(html, {"meta", "link", "br", "wbr"}) == "");
  CHECK(count(html, "<strong><a href=\"#reference-1\">Me 2014</a>, Fig. 2</strong>: lobes.") == 1);
  CHECK(count(html, "<strong>Figure R2.</strong>") == 1);
  CHECK(count(html, "<strong>Table R1.</strong>") == 1);
  CHECK(count(html, "<span class=\"number\">Fig. 2.</span>") == 1);
  CHECK(count(html, "<li id=\"reference-1\">Me: On x<sub>1</sub>. <a href=\"https://doi.org/10.1/2\">") == 1);
  CHECK(count(html, "href=\"https://a.b/?c&amp;d\"") == 1);
}

TEST_CASE("names in tables keep their underscores, and may be broken there") {
  Page named = page();
  named.entries.back().table = {{"masking", "x"}, {"v_cavity", "1"}, {"student\\_t", "2"}};
  const auto html = to_html(named);
  CHECK(count(html, "<td>v_<wbr>cavity</td>") == 1);
  CHECK(count(html, "<td>student_<wbr>t</td>") == 1);
}

TEST_CASE("a table that is a summary has its rows to unfold") {
  Page folded = page();
  folded.entries.back().all_rows = {{"check"}, {"a"}, {"b"}};
  CHECK(count(to_html(folded), "<details class=\"rows\"><summary>All 2 rows</summary>") == 1);
  CHECK(count(to_html(page()), "class=\"rows\"") == 0);
}

TEST_CASE("the page has light, dark, narrow and print styles") {
  const auto html = to_html(page());
  CHECK(count(html, "prefers-color-scheme:dark") == 1);
  CHECK(count(html, "--bp-s0:") == 1);
  CHECK(count(html, "--bp-r20:") == 1);
  CHECK(count(html, "@media print") == 1);
  CHECK(count(html, "<html lang=\"en\">") == 1);
  CHECK(count(html, "name=\"viewport\"") == 1);
}
