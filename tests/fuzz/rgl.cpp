#include "fuzz.hpp"

#include "brdf/measured/rgl_table.hpp"

#include <cmath>

namespace {

using namespace brdfplot;

/// What is read has a value everywhere.
void read_whole(const std::string& path) {
  const RglTable table = read_rgl(path);
  for (const double theta_i : {0.0, 0.4, 1.5})
    for (const double theta_o : {1e-9, 0.7, 1.57})
      for (const double phi : {-3.0, -0.2, 0.0, 1.7, 3.141592653589793})
        for (const double value : table.value(from_angles(theta_i, phi), from_angles(theta_o, 0.3)))
          if (!(value >= 0) || !std::isfinite(value)) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return brdfplot::fuzz::try_file(data, size, read_whole);
}
