/// \file
/// Whole numbers of the command line.
#pragma once

#include "base/echo.hpp"
#include "base/errors.hpp"

#include <charconv>
#include <cstdint>
#include <string>

namespace brdfplot::cli {

/// \throws InputError at `where` for what is no whole number in [least, most]
inline std::uint64_t read_whole(const std::string& text, std::uint64_t least, std::uint64_t most,
                                const std::string& where) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= least && value <= most) return value;
  throw InputError(where, "found \"" + echo(text) + "\", accepted: a whole number in [" + std::to_string(least) + ", " +
                              std::to_string(most) + "]");
}

} // namespace brdfplot::cli
