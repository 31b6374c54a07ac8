/// \file
/// What an error repeats of its input.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace brdfplot {

/// A text that is whole up to `most` characters, else their beginning with an ellipsis and how long the whole is:
/// "aaaa… (1000000 bytes)". Cut between the characters of UTF-8; bytes that are none count one each.
std::string cut(std::string_view text, std::size_t most = 60);

/// The text with its control characters as JSON escapes them, so that an error stays on one line and a terminal obeys
/// none of them.
std::string one_line(std::string_view text);

/// Longer paths than these are cut in errors.
inline constexpr std::size_t shown_path = 300;

/// A text as an error shows it: cut, on one line.
std::string echo(std::string_view text, std::size_t most = 60);

} // namespace brdfplot
