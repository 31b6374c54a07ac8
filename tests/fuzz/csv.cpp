#include "fuzz.hpp"

#include "stream/stream.hpp"

namespace {

using namespace brdfplot;

Material ggx() {
  TermDescription description;
  description.distribution.type = "ggx";
  description.distribution.values.set("alpha", 0.5);
  return build(description);
}

/// Every column of directions is read for them; evaluation has other tests.
void read_rows(const std::string& path) {
  static const Material material = ggx();
  static const StreamOptions options{select_quantities({"d", "brdf"}, "-q"), 1e-9, 1, false};
  InputFile in(path);
  OutputFile out("/dev/null");
  evaluate_stream(material, options, in, out);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::try_file(data, size, read_rows);
}
