/// \file
/// The kernels of one instruction set, on one thread.
#pragma once

#include "math/kernels/kernels.hpp"

namespace brdfplot::kernels {

/// While it lives, the kernels that its thread calls are those of `isa`, whatever use_isa() says. For comparisons.
/// \pre `isa` is among available_isas()
class IsaHere {
public:
  explicit IsaHere(Isa isa);
  ~IsaHere();
  IsaHere(const IsaHere&) = delete;
  IsaHere& operator=(const IsaHere&) = delete;

private:
  const void* before_;
};

} // namespace brdfplot::kernels
