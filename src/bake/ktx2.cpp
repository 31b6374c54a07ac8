#include "bake/formats.hpp"

#include "base/errors.hpp"

#include <array>
#include <cstdint>

namespace brdfplot::bake {

namespace {

constexpr std::size_t header_size = 80, level_index_size = 24;

/// Vulkan's formats of one, two and three floats of 32 bits, and of 16.
std::uint32_t vulkan_format(std::size_t channels, Stored stored) {
  constexpr std::array<std::uint32_t, 3> of_float{100, 103, 106}, of_half{76, 83, 90};
  return stored == Stored::half ? of_half.at(channels - 1) : of_float.at(channels - 1);
}

/// The basic data format descriptor (Khronos Data Format 1.3, section 5): linear, uncompressed floats.
std::string data_format(std::size_t channels, std::uint32_t bytes_per_number) {
  constexpr std::uint32_t rgbsda = 1, bt709 = 1, linear = 1, version = 2;
  const auto block_size = static_cast<std::uint32_t>(24 + 16 * channels);
  std::string bytes;
  append_bytes(bytes, block_size + 4);
  append_bytes(bytes, std::uint32_t{0});
  append_bytes(bytes, version | block_size << 16);
  append_bytes(bytes, rgbsda | bt709 << 8 | linear << 16);
  append_bytes(bytes, std::uint32_t{0});
  append_bytes(bytes, static_cast<std::uint64_t>(channels * bytes_per_number));
  for (std::uint32_t c = 0; c < channels; ++c) {
    constexpr std::uint32_t is_signed_float = 0xC0, minus_one = 0xBF800000, one = 0x3F800000;
    const std::uint32_t bits = 8 * bytes_per_number;
    append_bytes(bytes, c * bits | (bits - 1) << 16 | (is_signed_float | c) << 24);
    append_bytes(bytes, std::uint32_t{0});
    append_bytes(bytes, minus_one);
    append_bytes(bytes, one);
  }
  return bytes;
}

/// Metadata: keys and values that end in 0, each padded to 4 bytes.
std::string metadata(const BakedTable& baked) {
  std::string description;
  for (const std::string& line : description_of(baked)) description += line + "\n";
  std::string bytes;
  const std::array<std::array<std::string, 2>, 2> entries = {{{"KTXwriter", "brdfplot"}, {"brdfplot", description}}};
  for (const std::array<std::string, 2>& entry : entries) {
    append_bytes(bytes, static_cast<std::uint32_t>(entry[0].size() + entry[1].size() + 2));
    bytes += entry[0] + '\0' + entry[1] + '\0';
    bytes.append((4 - bytes.size() % 4) % 4, '\0');
  }
  return bytes;
}

} // namespace

std::string ktx2_bytes(const BakedTable& baked, Stored stored, const std::string& path) {
  const Table& table = baked.table;
  if (table.axes.size() > 3)
    throw InputError(path, "found " + std::to_string(table.axes.size()) + " axes; a texture has 1 to 3");
  const std::uint32_t size = stored == Stored::half ? 2 : 4;
  const std::string format = data_format(table.channels.size(), size), keys = metadata(baked);
  std::string level;
  for (const double value : table.values) append_number(level, value, stored);
  const auto extent = [&](std::size_t k) {
    return k < table.axes.size() ? static_cast<std::uint32_t>(table.axes[k].nodes) : 0;
  };

  std::string bytes = "\xABKTX 20\xBB\r\n\x1A\n";
  for (const std::uint32_t number :
       {vulkan_format(table.channels.size(), stored), size, extent(0), extent(1), extent(2), 0U, 1U, 1U, 0U})
    append_bytes(bytes, number);
  const std::size_t format_at = header_size + level_index_size, keys_at = format_at + format.size();
  for (const std::size_t number : {format_at, format.size(), keys_at, keys.size()})
    append_bytes(bytes, static_cast<std::uint32_t>(number));
  append_bytes(bytes, std::uint64_t{0}); // no supercompression
  append_bytes(bytes, std::uint64_t{0});
  // Levels begin at a multiple of the texel's size and of 4.
  constexpr std::size_t alignment = 24;
  const std::size_t end = keys_at + keys.size(), level_at = (end + alignment - 1) / alignment * alignment;
  for (const std::size_t number : {level_at, level.size(), level.size()})
    append_bytes(bytes, static_cast<std::uint64_t>(number));
  bytes += format + keys;
  bytes.append(level_at - end, '\0');
  return bytes + level;
}

} // namespace brdfplot::bake
