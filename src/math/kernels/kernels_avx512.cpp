/// \file
/// The kernels for AVX-512 (F, DQ, VL); kernels.cmake gives this source its flags.
#define BRDFPLOT_KERNELS_NAMESPACE avx512
#include "math/kernels/loops/cloth_loops.hpp"
#include "math/kernels/loops/direction_loops.hpp"
#include "math/kernels/loops/flat_loops.hpp"
#include "math/kernels/loops/fresnel_loops.hpp"
#include "math/kernels/loops/loops.hpp"
#include "math/kernels/loops/sampling_loops.hpp"

namespace brdfplot::kernels::detail {

constinit const Table avx512_table{avx512::kernels_of<double>(), avx512::kernels_of<float>(), avx512::fresnel_kernels(),
                                   avx512::flat_kernels(),       avx512::sampling_kernels(),  avx512::cloth_kernels(),
                                   avx512::direction_kernels()};

} // namespace brdfplot::kernels::detail
