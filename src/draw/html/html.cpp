#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/interrupt.hpp"
#include "base/number.hpp"
#include "draw/base64.hpp"
#include "draw/html/page.hpp"
#include "draw/html/style.hpp"
#include "draw/text.hpp"

namespace brdfplot::plot {

namespace {

/// An entry with its caption's name and number ("Figure 3").
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
    const int number = table ? ++tables : ++figures;
    numbered.push_back({&entry, (table ? "Table " : "Figure ") + std::to_string(number)});
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
    out += "<span class=\"number\">" + numbered[i].name + ".</span> ";
    append_html(out, numbered[i].entry->title);
    out += "</a></li>\n";
  }
  if (!numbered.empty()) out += "</ol></li>\n";
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

void append_caption(std::string& out, const Numbered& numbered) {
  const auto& entry = *numbered.entry;
  out += "<figcaption><strong>" + numbered.name + ".</strong>";
  if (!entry.title.empty() && caption_needs_title(entry)) {
    out += " <strong>";
    append_sentence(out, entry.title);
    out += "</strong>";
  }
  if (!entry.caption.empty()) {
    out += ' ';
    append_html(out, entry.caption);
  }
  out += "</figcaption>\n";
}

void append_row(std::string& out, const std::vector<std::string>& row, const std::vector<bool>& numeric, bool header) {
  out += "<tr>";
  for (std::size_t i = 0; i < row.size(); ++i) {
    out += header ? "<th scope=\"col\"" : "<td";
    if (i < numeric.size() && numeric[i]) out += " class=\"num\"";
    out += '>';
    append_html(out, row[i]);
    out += header ? "</th>" : "</td>";
  }
  out += "</tr>\n";
}

/// The columns that hold numbers only, to be set flush right.
std::vector<bool> numeric_columns(const std::vector<std::vector<std::string>>& table) {
  std::vector<bool> numeric(table.front().size(), table.size() > 1);
  for (std::size_t r = 1; r < table.size(); ++r) {
    for (std::size_t c = 0; c < numeric.size(); ++c) {
      const bool number = c < table[r].size() && parse_number(table[r][c]).has_value();
      if (!number) numeric[c] = false;
    }
  }
  return numeric;
}

void append_table(std::string& out, const std::vector<std::vector<std::string>>& table) {
  const auto numeric = numeric_columns(table);
  out += "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead>";
  append_row(out, table.front(), numeric, true);
  out += "</thead>\n<tbody>\n";
  for (std::size_t r = 1; r < table.size(); ++r) append_row(out, table[r], numeric, false);
  out += "</tbody></table></div>\n";
}

void append_download(std::string& out, const std::string& file, std::string_view type, std::string_view name,
                     std::string_view data) {
  if (data.empty()) return;
  out += "<a download=\"";
  append_escaped(out, file);
  out.append("\" href=\"data:").append(type).append(";base64,");
  append_base64(out, data);
  out.append("\">").append(name).append("</a>\n");
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
  append_download(out, entry.id + ".svg", "image/svg+xml", "Download SVG", entry.svg);
  append_download(out, entry.id + ".csv", "text/csv;charset=utf-8", "Download CSV", entry.csv);
  if (entry.seconds > 0) out += "<span>computed in " + duration(entry.seconds) + "</span>\n";
  out += "</div>\n";
  if (entry.json.empty()) return;
  out += "<details class=\"config\"><summary>Configuration</summary><pre>";
  append_escaped(out, entry.json);
  out += "</pre></details>\n";
}

void append_entry(std::string& out, const Numbered& numbered) {
  const auto& entry = *numbered.entry;
  const bool table = is_table(entry);
  out += "<figure id=\"";
  append_escaped(out, entry.id);
  out += table ? "\" class=\"table\">\n" : "\">\n";
  if (table) append_caption(out, numbered);
  if (table) append_table(out, entry.table);
  if (!entry.svg.empty()) out += "<div class=\"plot\" tabindex=\"0\">\n" + entry.svg + "</div>\n";
  if (!table) append_caption(out, numbered);
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
      append_escaped(out, paragraph);
      out += "</p>\n";
    }
    at = end + 2;
  }
  out += "</header>\n";
}

std::size_t estimate(const Page& page) {
  std::size_t size = 32768;
  for (const auto& entry : page.entries)
    size += 3 * entry.svg.size() + 2 * entry.csv.size() + 2 * entry.json.size() + 4096;
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
    append_entry(out, numbered[i]);
  }
  if (!numbered.empty()) out += "</section>\n";
  out += "</main>\n<footer>";
  append_escaped(out, page.footer);
  out += "</footer>\n</div>\n</body>\n</html>\n";
  return out;
}

} // namespace brdfplot::plot
