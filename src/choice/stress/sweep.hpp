/// \file
/// Rows that cover a domain, its ends and simple numbers and their neighbourhoods included.
#pragma once

#include "choice/stress/subject.hpp"

namespace brdfplot::choice {

/// Rows of numbers of the method's type, the same for every method of this type: a grid with both ends; around each
/// end and each simple number (0, 1/2, 1, 2, powers of ten) the numbers next to it and those that differ by 2^-k; and
/// numbers of random bits, of a fixed seed, whose exponents are spread evenly.
std::vector<Row> sweep(const Subject& subject);

} // namespace brdfplot::choice
