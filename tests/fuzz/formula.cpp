#include "fuzz.hpp"

#include "math/formula.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  // Checking evaluates it. A Formula would be kept for ever.
  brdfplot::fuzz::try_to([&] { brdfplot::Formula::problem(text, {"theta", "phi", "r", "a", "alpha"}); });
  return 0;
}
