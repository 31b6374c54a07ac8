/// \file
/// Points of the unit cube, random or evenly spread.
#pragma once

#include "sampling/facets.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace brdfplot {

enum class PointKind {
  random, ///< independent
  sobol,  ///< Sobol's sequence, shifted digit by digit (Cranley and Patterson's rotation in base 2)
};

/// \throws InputError at `where` for an unknown name
PointKind point_kind(const std::string& name, const std::string& where);

/// Points `first` ... `first` + n - 1 of a sequence, of which there is one for every seed and stream. Whoever asks for
/// which part of it and when, they are the same; each coordinate is an odd multiple of 2^-53 in (0, 1).
std::vector<SamplePoint> points(PointKind kind, std::uint64_t seed, std::uint64_t stream, std::uint64_t first,
                                std::size_t n);

} // namespace brdfplot
