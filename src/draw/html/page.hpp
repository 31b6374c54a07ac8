/// \file
/// The report's page: one self-contained HTML file that works offline.
#pragma once

#include <string>
#include <vector>

namespace brdfplot::plot {

/// One figure or table of the page.
struct PageEntry {
  std::string id;      ///< unique; the anchor
  std::string section; ///< heading under which it stands; entries of one section are adjacent
  std::string title;   ///< plain text with label markup
  std::string caption; ///< plain text with label markup
  std::string svg;     ///< the figure as to_svg wrote it; empty for a table
  std::string csv;     ///< its data, offered for download
  std::string json;    ///< the configuration that made it, to unfold
  /// A table: header row and body rows, plain text with label markup; empty for a figure.
  std::vector<std::vector<std::string>> table;
  double seconds = 0; ///< how long it took to compute
};

struct Page {
  std::string title;
  std::string introduction; ///< plain text, paragraphs separated by an empty line
  std::string footer;       ///< "made by brdfplot 0.1.0 from heitz2014.json"
  std::vector<PageEntry> entries;
};

/// The page as one HTML document without any outside reference.
std::string to_html(const Page& page);

} // namespace brdfplot::plot
