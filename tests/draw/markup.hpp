/// \file
/// A small check that markup is well-formed: enough of XML for what the writers write.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace plot_tests {

/// What is wrong with the document, or nothing: tags that do not match, a bare `&` or `<`, two equal ids.
inline std::string fault_of(const std::string& xml, const std::set<std::string>& unclosed = {}) {
  std::vector<std::string> open;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (xml[i] == '&' && xml.find(';', i) > i + 6) return "bare & at " + xml.substr(i, 30);
    if (xml[i] != '<') continue;
    const auto end = xml.find('>', i);
    if (end == std::string::npos) return "unfinished tag " + xml.substr(i, 30);
    const auto tag = xml.substr(i + 1, end - i - 1);
    if (tag.find('<') != std::string::npos) return "bare < at " + xml.substr(i, 30);
    const auto name = tag.substr(0, tag.find_first_of(" /", 1));
    const auto id = tag.find(" id=\"");
    if (id != std::string::npos && !ids.insert(tag.substr(id + 5, tag.find('"', id + 5) - id - 5)).second) {
      return "second id in " + tag;
    }
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "unexpected " + tag;
      open.pop_back();
    } else if (tag.back() != '/' && tag[0] != '!' && !unclosed.contains(name)) {
      open.push_back(name);
    }
    if (name == "style" || name == "script") { // their text is not markup
      i = xml.find("</" + name + ">", end) - 1;
    } else {
      i = end;
    }
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

} // namespace plot_tests
