#include "fuzz.hpp"

#include "config/load.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return brdfplot::fuzz::try_file(data, size, brdfplot::config::load_advice);
}
