#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "draw/base64.hpp"
#include "draw/deflate.hpp"
#include "draw/html/cite.hpp"
#include "draw/html/page.hpp"
#include "draw/html/script.hpp"
#include "draw/html/style.hpp"
#include "draw/html/table.hpp"
#include "draw/style.hpp"
#include "draw/text.hpp"

namespace brdfplot::plot {

namespace {

/// An entry with its caption's name and number: "Fig. 11" of a paper, or the page's "Figure 3", "Figure R3" beside a
/// paper's.
struct Numbered {
  const PageEntry* entry = nullptr;
  std::string name;
};

bool is_table(const PageEntry& entry) { return !entry.table.empty(); }

std::vector<Numbered> number_entries(const Page& page) {
  int figures = 0;
  int tables = 0;
  std::vector<Numbered> numbered;
  for (const auto& entry : page.entries) {
    const bool table = is_table(entry);
    if (!entry.number.empty()) {
      numbered.push_back({&entry, entry.number});
      continue;
    }
    const std::string number = (page.paper.empty() ? "" : "R") + std::to_string(table ? ++tables : ++figures);
    numbered.push_back({&entry, (table ? "Table " : "Figure ") + number});
  }
  return numbered;
}

bool starts_section(const Page& page, std::size_t i) {
  return i == 0 || page.entries[i].section != page.entries[i - 1].section;
}

std::string section_id(std::size_t first_entry) { return "section-" + std::to_string(first_entry + 1); }

void append_link(std::string& out, std::string_view id) {
  out += "<a href=\"#";
  append_escaped(out, id);
  out += "\">";
}

void append_contents(std::string& out, const Page& page, const std::vector<Numbered>& numbered) {
  out += "<nav class=\"toc\" aria-label=\"Contents\"><details open><summary>Contents</summary>\n<ol>\n";
  for (std::size_t i = 0; i < numbered.size(); ++i) {
    if (starts_section(page, i)) {
      if (i != 0) out += "</ol></li>\n";
      out += "<li>";
      if (!page.entries[i].section.empty()) {
        append_link(out, section_id(i));
        append_html(out, page.entries[i].section);
        out += "</a>";
      }
      out += "<ol>\n";
    }
    out += "<li>";
    append_link(out, numbered[i].entry->id);
    out += "<span class=\"number\">";
    append_escaped(out, numbered[i].name);
    out += ".</span> ";
    append_html(out, numbered[i].entry->title);
    out += "</a></li>\n";
  }
  if (!numbered.empty()) out += "</ol></li>\n";
  if (!page.references.empty()) out += "<li><a href=\"#references\">References</a></li>\n";
  // Without scripts the contents simply start unfolded on phones too.
  out += "</ol></details></nav>\n<script>if(matchMedia('(max-width:60rem)').matches)"
         "document.querySelector('.toc details').open=false</script>\n";
}

/// Whether the caption must say the title because the drawing does not.
bool caption_needs_title(const PageEntry& entry) {
  return entry.svg.find("bp-title") == std::string::npos || entry.caption.empty();
}

void append_sentence(std::string& out, std::string_view text) {
  append_html(out, text);
  if (text.find_last_of(".!?") != text.size() - 1) out += '.';
}

/// "Fig. 11." before the caption; where that begins with "Heitz 2014, Fig. 11", these words are it.
void append_caption(std::string& out, const Page& page, const Numbered& numbered) {
  const auto& entry = *numbered.entry;
  std::string_view caption = entry.caption;
  const std::string named = page.paper + ", " + numbered.name;
  const bool names_itself = !page.paper.empty() && !entry.number.empty() && caption.starts_with(named);
  out += "<figcaption><strong>";
  if (names_itself) {
    append_cited(out, named, page.references);
    caption.remove_prefix(named.size());
  } else {
    append_escaped(out, numbered.name);
    out += '.';
  }
  if (!entry.title.empty() && caption_needs_title(entry)) {
    out += names_itself ? ": " : "</strong> <strong>";
    if (names_itself) append_html(out, entry.title);
    if (!names_itself) append_sentence(out, entry.title);
  }
  out += "</strong>";
  if (!caption.empty() && !names_itself) out += ' ';
  append_cited(out, caption, page.references);
  out += "</figcaption>\n";
}

/// The drawing without its style sheet, which is the page's.
std::string unstyled(const std::string& svg) {
  constexpr std::string_view begin = "<style>", end = "</style>\n";
  const std::size_t from = svg.find(begin), to = svg.find(end);
  return from == std::string::npos || to == std::string::npos ? svg : svg.substr(0, from) + svg.substr(to + end.size());
}

/// A link to the file beside the page; a script makes the file from the page, which may have been moved. Where there
/// is no file, the link is for the script to show.
void append_file(std::string& out, const PageEntry& entry, const std::string& kind, const std::string& name) {
  out += "<a data-file=\"" + kind + "\"" + (entry.stem.empty() ? " hidden" : "") + " download href=\"";
  append_escaped(out, (entry.stem.empty() ? entry.id : entry.stem) + "." + kind);
  out += "\">" + name + "</a>\n";
}

/// "0.42 s", "3.1 s", "120 s": two digits are enough to know what a figure costs.
std::string duration(double seconds) {
  if (seconds < 0.01) return "less than 0.01 s";
  const int decimals = seconds < 1 ? 2 : seconds < 10 ? 1 : 0;
  const long long scale = decimals == 2 ? 100 : decimals == 1 ? 10 : 1;
  const long long units = std::llround(seconds * static_cast<double>(scale));
  return format_number(static_cast<double>(units) / static_cast<double>(scale)) + " s";
}

void append_tools(std::string& out, const PageEntry& entry) {
  out += "<div class=\"tools\">\n";
  if (!entry.svg.empty()) out += "<button type=\"button\" data-enlarge hidden>Enlarge</button>\n";
  if (!entry.svg.empty()) append_file(out, entry, "svg", "SVG");
  if (!entry.csv.empty()) append_file(out, entry, "csv", "CSV");
  if (!entry.json.empty()) append_file(out, entry, "json", "JSON");
  if (entry.seconds > 0) out += "<span>computed in " + duration(entry.seconds) + "</span>\n";
  out += "</div>\n";
  if (!entry.json.empty()) {
    out += "<details class=\"config\"><summary>Configuration</summary><pre>";
    append_escaped(out, entry.json);
    out += "</pre></details>\n";
  }
  if (entry.csv.empty()) return;
  out += "<script class=\"csv\" type=\"text/plain\">";
  append_base64(out, deflated(entry.csv));
  out += "</script>\n";
}

void append_entry(std::string& out, const Page& page, const Numbered& numbered) {
  const auto& entry = *numbered.entry;
  const bool table = is_table(entry);
  out += "<figure id=\"";
  append_escaped(out, entry.id);
  out += table ? "\" class=\"table\">\n" : "\">\n";
  if (table) append_caption(out, page, numbered);
  if (table) append_table(out, entry.table);
  if (!entry.all_rows.empty()) {
    out += "<details class=\"rows\"><summary>All " + std::to_string(entry.all_rows.size() - 1) + " rows</summary>\n";
    append_table(out, entry.all_rows);
    out += "</details>\n";
  }
  if (!entry.svg.empty()) out += "<div class=\"plot\">\n" + unstyled(entry.svg) + "</div>\n";
  if (!table) append_caption(out, page, numbered);
  append_tools(out, entry);
  out += "</figure>\n";
}

void append_head(std::string& out, const Page& page) {
  out += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>";
  append_escaped(out, strip_markup(page.title));
  out += "</title>\n<style>";
  append_page_style(out);
  out += "</style>\n<style id=\"bp-style\">\n" + every_rule();
  out += "</style>\n</head>\n<body>\n<div class=\"layout\">\n";
}

void append_introduction(std::string& out, const Page& page) {
  out += "<header><h1>";
  append_html(out, page.title);
  out += "</h1>\n";
  const std::string_view text = page.introduction;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find("\n\n", at), text.size());
    const auto paragraph = text.substr(at, end - at);
    if (paragraph.find_first_not_of(" \n\t") != std::string_view::npos) {
      out += "<p>";
      append_cited(out, paragraph, page.references);
      out += "</p>\n";
    }
    at = end + 2;
  }
  out += "</header>\n";
}

std::size_t estimate(const Page& page) {
  std::size_t size = 32768;
  for (const auto& entry : page.entries) size += entry.svg.size() + entry.csv.size() + 2 * entry.json.size() + 4096;
  return size;
}

} // namespace

std::string to_html(const Page& page) {
  const auto numbered = number_entries(page);
  std::string out;
  out.reserve(estimate(page));
  append_head(out, page);
  append_contents(out, page, numbered);
  append_introduction(out, page);
  out += "<main>\n";
  for (std::size_t i = 0; i < numbered.size(); ++i) {
    throw_if_interrupted();
    const auto& section = page.entries[i].section;
    if (starts_section(page, i)) {
      if (i != 0) out += "</section>\n";
      out += "<section id=\"" + section_id(i) + "\">\n";
      if (!section.empty()) {
        out += "<h2>";
        append_html(out, section);
        out += "</h2>\n";
      }
    }
    append_entry(out, page, numbered[i]);
  }
  if (!numbered.empty()) out += "</section>\n";
  append_references(out, page.references);
  out += "</main>\n<footer>";
  append_escaped(out, page.footer);
  if (!page.licence.empty()) {
    out += "<br>";
    append_escaped(out, page.licence);
  }
  out += "</footer>\n</div>\n<script>";
  out += page_script();
  out += "</script>\n</body>\n</html>\n";
  return out;
}

} // namespace brdfplot::plot
