#include "draw/png.hpp"

#include "draw/deflate.hpp"

#include <cstdint>
#include <string_view>

#include <zlib.h>

namespace brdfplot::plot {

namespace {

void append_big_endian(std::string& out, std::uint32_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) out += static_cast<char>(number >> shift & 0xFFU);
}

/// ISO/IEC 15948, section 5.3: length, type, data, and the CRC of type and data.
void append_chunk(std::string& out, std::string_view type, std::string_view data) {
  append_big_endian(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = out.size();
  out.append(type).append(data);
  const auto* bytes = reinterpret_cast<const Bytef*>(out.data() + begin);
  append_big_endian(out, static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(out.size() - begin))));
}

/// Greyscale, colour, and both with transparency: table 11.1.
char colour_type(const Picture& picture) {
  return static_cast<char>((picture.channels == 1 ? 0 : 2) + (picture.opaque ? 0 : 4));
}

/// Every row as differences between a pixel and its left neighbour (filter 1, table 9.1). Of a shaded sphere it packs
/// a sixth smaller than what libpng chooses row by row.
std::string filtered(const Picture& picture) {
  const std::size_t step = static_cast<std::size_t>(picture.channels) + (picture.opaque ? 0 : 1);
  const std::size_t stride = step * static_cast<std::size_t>(picture.width);
  std::string out;
  out.reserve(picture.bytes.size() + static_cast<std::size_t>(picture.height));
  for (std::size_t k = 0; k < picture.bytes.size(); ++k) {
    const std::size_t column = k % stride;
    if (column == 0) out += '\1';
    const unsigned left = column < step ? 0 : picture.bytes[k - step];
    out += static_cast<char>((picture.bytes[k] - left) & 0xFFU);
  }
  return out;
}

} // namespace

std::string to_png(const Picture& picture) {
  std::string header;
  append_big_endian(header, static_cast<std::uint32_t>(picture.width));
  append_big_endian(header, static_cast<std::uint32_t>(picture.height));
  header += {8, colour_type(picture), 0, 0, 0};
  std::string out = "\x89PNG\r\n\x1a\n";
  append_chunk(out, "IHDR", header);
  append_chunk(out, "sRGB", std::string_view("\0", 1)); // perceptual
  append_chunk(out, "IDAT", deflated(filtered(picture)));
  append_chunk(out, "IEND", "");
  return out;
}

} // namespace brdfplot::plot
