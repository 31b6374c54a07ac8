#include "fuzz.hpp"

#include "brdf/measured/merl_table.hpp"

#include <cmath>

namespace {

using namespace brdfplot;

/// What is read can be looked up everywhere.
void read_whole(const std::string& path) {
  const MerlTable table = read_merl(path);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < table.grid().cells(); ++k)
      if (!(table.value(c, k) >= 0) || !std::isfinite(table.value(c, k))) std::abort();
  for (const double angle : {0.0, 0.3, 1.2, 1.5707963267948966})
    for (const double phi : {-3.141592653589793, -1.0, 0.0, 3.141592653589793})
      if (table.grid().cell_of({angle, 0, angle, phi}) >= table.grid().cells()) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return brdfplot::fuzz::try_file(data, size, read_whole);
}
