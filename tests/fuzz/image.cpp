#include "fuzz.hpp"

#include "simulation/surfaces/image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return brdfplot::fuzz::try_file(data, size, brdfplot::simulation::read_image);
}
