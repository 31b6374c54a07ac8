/// \file
/// The kernels for every processor of the architecture; kernels.cmake gives this source its flags.
#define BRDFPLOT_KERNELS_NAMESPACE baseline
#include "math/kernels/loops/cloth_loops.hpp"
#include "math/kernels/loops/direction_loops.hpp"
#include "math/kernels/loops/flat_loops.hpp"
#include "math/kernels/loops/fresnel_loops.hpp"
#include "math/kernels/loops/loops.hpp"
#include "math/kernels/loops/sampling_loops.hpp"

namespace brdfplot::kernels::detail {

constinit const Table baseline_table{baseline::kernels_of<double>(), baseline::kernels_of<float>(),
                                     baseline::fresnel_kernels(),    baseline::flat_kernels(),
                                     baseline::sampling_kernels(),   baseline::cloth_kernels(),
                                     baseline::direction_kernels()};

} // namespace brdfplot::kernels::detail
