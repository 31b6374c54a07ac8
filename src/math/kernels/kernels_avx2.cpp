/// \file
/// The kernels for AVX2 with FMA; kernels.cmake gives this source its flags.
#define BRDFPLOT_KERNELS_NAMESPACE avx2
#include "math/kernels/loops/cloth_loops.hpp"
#include "math/kernels/loops/direction_loops.hpp"
#include "math/kernels/loops/flat_loops.hpp"
#include "math/kernels/loops/fresnel_loops.hpp"
#include "math/kernels/loops/loops.hpp"
#include "math/kernels/loops/sampling_loops.hpp"

namespace brdfplot::kernels::detail {

constinit const Table avx2_table{avx2::kernels_of<double>(), avx2::kernels_of<float>(), avx2::fresnel_kernels(),
                                 avx2::flat_kernels(),       avx2::sampling_kernels(),  avx2::cloth_kernels(),
                                 avx2::direction_kernels()};

} // namespace brdfplot::kernels::detail
