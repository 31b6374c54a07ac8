/// \file
/// The report's page: one self-contained HTML file that works offline.
#pragma once

#include <string>
#include <vector>

namespace brdfplot::plot {

/// Header row and body rows, plain text with label markup.
using Cells = std::vector<std::vector<std::string>>;

/// One figure or table of the page.
struct PageEntry {
  std::string id;       ///< unique; the anchor
  std::string section;  ///< heading under which it stands; entries of one section are adjacent
  std::string title;    ///< plain text with label markup
  std::string caption;  ///< plain text with label markup
  std::string svg;      ///< the figure as to_svg wrote it; empty for a table
  std::string csv;      ///< its data, offered for download
  std::string json;     ///< the configuration that made it, to unfold
  Cells table;          ///< of a table; empty for a figure
  double seconds = 0;   ///< how long it took to compute
  std::string stem{};   ///< of its files beside the page, "figures/fig11_lobes"; none: there are no files
  std::string number{}; ///< the paper's own, "Fig. 11"; none: it gets one of the page's
  Cells all_rows{};     ///< of a table that is a summary: what it summarises, to unfold
};

/// A publication that the page refers to.
struct Reference {
  std::vector<std::string> cited; ///< how captions name it: "Walter et al. 2007"
  std::string text;               ///< author, title, where and when
  std::string url;
};

struct Page {
  std::string title;
  std::string introduction; ///< plain text, paragraphs separated by an empty line
  std::string footer;       ///< "made by brdfplot 0.1.0 from heitz2014.json"
  std::vector<PageEntry> entries;
  /// How captions name the paper whose numbers entries have: "Heitz 2014". Where there is one, the page's own numbers
  /// are R1, R2 and so on.
  std::string paper{};
  std::vector<Reference> references{};
  std::string licence{};
};

/// The page as one HTML document without any outside reference but the links to publications. Nothing is stored twice:
/// drawings share one style sheet, what is downloaded as SVG is the drawing itself, CSV is deflated.
std::string to_html(const Page& page);

} // namespace brdfplot::plot
