/// \file
/// FNV-1a (Fowler, Noll, Vo), 64 bits: tells files and keys apart, and whether bytes are whole.
#pragma once

#include <cstdint>
#include <string_view>

namespace brdfplot {

inline constexpr std::uint64_t hash_basis = 0xcbf29ce484222325;

/// The hash of what `state` is the hash of, with the text behind it.
inline std::uint64_t hash(std::string_view text, std::uint64_t state = hash_basis) {
  for (const char c : text) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return state;
}

} // namespace brdfplot
