#include "fuzz.hpp"

#include "simulation/store.hpp"

namespace {

using namespace brdfplot;

const std::string key = "a key";

/// The body of a file, with the head and the sum that its reader asks for.
std::string sealed(const std::string& body) {
  static const std::string empty = simulation::to_text(key, {});
  std::string text = empty.substr(0, empty.size() - 17) + body;
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[sum >> shift & 15U];
  return text + "\n";
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  simulation::from_text(key, bytes);
  const auto result = simulation::from_text(key, sealed(bytes));
  // What was read is written and read again.
  if (result && !simulation::from_text(key, simulation::to_text(key, *result))) std::abort();
  return 0;
}
