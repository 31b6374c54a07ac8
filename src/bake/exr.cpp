#include "bake/formats.hpp"

#include "base/errors.hpp"

#include <bit>
#include <cstdint>

namespace brdfplot::bake {

namespace {

constexpr std::uint32_t half_pixels = 1, float_pixels = 2;

/// A field of the header (OpenEXR File Layout): name, type, size, value.
void append_field(std::string& bytes, const std::string& name, const std::string& type, const std::string& value) {
  bytes += name + '\0' + type + '\0';
  append_bytes(bytes, static_cast<std::uint32_t>(value.size()));
  bytes += value;
}

std::string numbers(std::initializer_list<std::uint32_t> words) {
  std::string bytes;
  for (const std::uint32_t word : words) append_bytes(bytes, word);
  return bytes;
}

/// Names of the channels in the order of the values: a luminance, or the first of red, green and blue.
std::vector<std::string> channel_names(std::size_t count) {
  if (count == 1) return {"Y"};
  return count == 2 ? std::vector<std::string>{"R", "G"} : std::vector<std::string>{"R", "G", "B"};
}

std::string header(const BakedTable& baked, std::uint32_t width, std::uint32_t height, Stored stored) {
  const std::vector<std::string> names = channel_names(baked.table.channels.size());
  std::string channels;
  for (std::size_t c = names.size(); c-- > 0;) // in the order of the alphabet
    channels += names[c] + '\0' + numbers({stored == Stored::half ? half_pixels : float_pixels, 0, 1, 1});
  channels += '\0';
  std::string description;
  for (const std::string& line : description_of(baked)) description += line + "\n";
  const auto one = std::bit_cast<std::uint32_t>(1.0F);
  const std::string window = numbers({0, 0, width - 1, height - 1});

  std::string bytes;
  append_field(bytes, "brdfplot", "string", description);
  append_field(bytes, "channels", "chlist", channels);
  append_field(bytes, "compression", "compression", std::string(1, '\0'));
  append_field(bytes, "dataWindow", "box2i", window);
  append_field(bytes, "displayWindow", "box2i", window);
  append_field(bytes, "lineOrder", "lineOrder", std::string(1, '\0'));
  append_field(bytes, "pixelAspectRatio", "float", numbers({one}));
  append_field(bytes, "screenWindowCenter", "v2f", numbers({0, 0}));
  append_field(bytes, "screenWindowWidth", "float", numbers({one}));
  return bytes + '\0';
}

} // namespace

/// OpenEXR 2, lines without compression.
std::string exr_bytes(const BakedTable& baked, Stored stored, const std::string& path) {
  const Table& table = baked.table;
  if (table.axes.size() > 2)
    throw InputError(path, "found " + std::to_string(table.axes.size()) + " axes; an image has 1 or 2");
  const std::size_t width = table.axes[0].nodes, height = table.axes.size() > 1 ? table.axes[1].nodes : 1;
  const std::size_t channels = table.channels.size();
  const std::size_t line_size = width * channels * (stored == Stored::half ? 2 : 4);

  std::string bytes = numbers({0x01312F76, 2});
  bytes += header(baked, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), stored);
  const std::size_t first_line = bytes.size() + 8 * height;
  for (std::size_t y = 0; y < height; ++y)
    append_bytes(bytes, static_cast<std::uint64_t>(first_line + y * (8 + line_size)));
  for (std::size_t y = 0; y < height; ++y) {
    append_bytes(bytes, static_cast<std::uint32_t>(y));
    append_bytes(bytes, static_cast<std::uint32_t>(line_size));
    for (std::size_t c = channels; c-- > 0;)
      for (std::size_t x = 0; x < width; ++x)
        append_number(bytes, table.values[(y * width + x) * channels + c], stored);
  }
  return bytes;
}

} // namespace brdfplot::bake
