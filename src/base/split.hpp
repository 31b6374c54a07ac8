/// \file
#pragma once

#include <string>
#include <vector>

namespace brdfplot {

/// What stands between the signs, empty parts included: one part more than there are signs.
inline std::vector<std::string> split(const std::string& text, char sign) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == sign)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

} // namespace brdfplot
