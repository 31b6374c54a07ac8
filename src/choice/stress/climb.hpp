/// \file
/// From a bad row to a worse one, and from a bad row to a simple one.
#pragma once

#include "choice/stress/failure_kinds.hpp"

namespace brdfplot::choice {

/// The worst row that a pattern search over bit patterns finds: one input at a time moves up or down by some power of
/// two of numbers of the method's type, from a large part of its range down to a single one, as long as the failure
/// gets worse. What it finds is a lower bound of the worst.
Trial climbed(const Subject& subject, const FailureKind& kind, Trial best);

/// The simplest row that still shows the failure, and at least as badly as `least`: one input after the other becomes
/// 1, 0, or a number of few significant digits, those near 1 first, or an end of its range.
Trial simplified(const Subject& subject, const FailureKind& kind, Trial best, double least);

} // namespace brdfplot::choice
