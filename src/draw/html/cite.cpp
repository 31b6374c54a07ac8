#include "draw/html/cite.hpp"

#include <algorithm>
#include <cstddef>
#include <set>

#include "draw/text.hpp"

namespace brdfplot::plot {

namespace {

std::string anchor(std::size_t reference) { return "reference-" + std::to_string(reference + 1); }

/// Where a publication is mentioned.
struct Mention {
  std::size_t at = std::string_view::npos;
  std::string_view words;
  std::size_t reference = 0;
};

/// The first mention from `from` on of one that was not mentioned before; of several there the longest.
Mention next_mention(std::string_view text, std::size_t from, const std::vector<Reference>& references,
                     const std::set<std::size_t>& before) {
  Mention next;
  for (std::size_t k = 0; k < references.size(); ++k) {
    if (before.contains(k)) continue;
    for (const std::string& words : references[k].cited) {
      const std::size_t at = text.find(words, from);
      const bool longer = at == next.at && words.size() > next.words.size();
      if (at != std::string_view::npos && (at < next.at || longer)) next = {at, words, k};
    }
  }
  return next;
}

} // namespace

void append_cited(std::string& out, std::string_view text, const std::vector<Reference>& references) {
  std::set<std::size_t> mentioned;
  std::size_t from = 0;
  while (true) {
    const Mention mention = next_mention(text, from, references, mentioned);
    if (mention.at == std::string_view::npos) break;
    append_html(out, text.substr(from, mention.at - from));
    out += "<a href=\"#" + anchor(mention.reference) + "\">";
    append_escaped(out, mention.words);
    out += "</a>";
    mentioned.insert(mention.reference);
    from = mention.at + mention.words.size();
  }
  append_html(out, text.substr(from));
}

void append_references(std::string& out, const std::vector<Reference>& references) {
  if (references.empty()) return;
  out += "<section id=\"references\">\n<h2>References</h2>\n<ol>\n";
  for (std::size_t k = 0; k < references.size(); ++k) {
    out += "<li id=\"" + anchor(k) + "\">";
    append_html(out, references[k].text);
    out += " <a href=\"";
    append_escaped(out, references[k].url);
    out += "\">";
    append_escaped(out, references[k].url);
    out += "</a></li>\n";
  }
  out += "</ol>\n</section>\n";
}

} // namespace brdfplot::plot
