/// \file
/// Directions of the light drawn for a stream of viewers: CSV in, CSV out.
#pragma once

#include "base/text_files.hpp"
#include "sampling/points.hpp"
#include "sampling/sampler.hpp"

#include <cstdint>

namespace brdfplot {

struct SampleOptions {
  std::uint64_t samples = 1; ///< of every row
  std::uint64_t seed = 1;
  PointKind points = PointKind::random;
  int threads = 1;
};

/// Reads viewers (see DirectionColumns) and writes for each `samples` rows: the row as it was, the direction
/// `x_i,y_i,z_i`, its density `pdf` (1/sr), and rho c_i / pdf, `weight`, or `weight_r,weight_g,weight_b` of a coloured
/// material. Below the horizon of the mesosurface, and where nothing is drawn (pdf 0), the weight is 0. Every row of
/// the input has points of its own, chosen by the seed and its line.
///
/// Memory does not grow with the number of rows nor of samples, and what is written does not depend on the number of
/// threads: before a row that is wrong, all rows above it.
/// \throws InputError naming FILE:LINE for the first row that is wrong; AccuracyError where a BRDF misses its accuracy
/// or a weight is not finite; FileError when reading or writing fails.
void sample_stream(const Material& material, const Sampler& sampler, const SampleOptions& options, InputFile& in,
                   OutputFile& out);

} // namespace brdfplot
