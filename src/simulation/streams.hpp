/// \file
/// Which stream of random numbers belongs to what: every piece of work has its own, whoever does it and when.
#pragma once

#include <cstdint>

namespace brdfplot::simulation {

enum class Purpose : std::uint64_t { surface, rays };

/// A stream for Random: realisation below 2^20, part below 2^42.
inline std::uint64_t stream(Purpose purpose, std::uint64_t realisation, std::uint64_t part) {
  return (static_cast<std::uint64_t>(purpose) << 62) | (realisation << 42) | part;
}

} // namespace brdfplot::simulation
