#include "simulation/surfaces/image.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string_view>

namespace brdfplot::simulation {

namespace {

constexpr int largest_side = 8192;

/// The bytes that libpng has not read yet.
struct Source {
  std::string_view bytes;
};

void read_bytes(png_structp png, png_bytep to, png_size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (source->bytes.size() < count) png_error(png, "the file ends too early");
  std::memcpy(to, source->bytes.data(), count);
  source->bytes.remove_prefix(count);
}

/// What libpng decoded, or why not. Plain data: an error leaves by longjmp, which runs no destructors.
struct Decoded {
  png_uint_32 width = 0, height = 0;
  int depth = 0;
  const char* wrong = nullptr;
};

void on_error(png_structp png, png_const_charp) { longjmp(png_jmpbuf(png), 1); }
void on_warning(png_structp, png_const_charp) {}

/// Reads the header and, when `rows` is not null, the rows. `Rows` are pointers to width * 2 bytes each.
Decoded decode(std::string_view bytes, png_bytepp rows) {
  Decoded out;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  Source source{bytes};
  if (info == nullptr) {
    png_destroy_read_struct(&png, &info, nullptr);
    out.wrong = "is no PNG that can be read: there is not enough memory";
    return out;
  }
  if (setjmp(png_jmpbuf(png)) != 0) { // NOLINT(cert-err52-cpp): libpng is C and reports errors no other way
    png_destroy_read_struct(&png, &info, nullptr);
    out.wrong = "is a broken PNG";
    return out;
  }
  png_set_read_fn(png, &source, read_bytes);
  png_read_info(png, info);
  out.width = png_get_image_width(png, info);
  out.height = png_get_image_height(png, info);
  out.depth = png_get_bit_depth(png, info);
  if (png_get_color_type(png, info) != PNG_COLOR_TYPE_GRAY)
    out.wrong = "is a PNG with colour or transparency; accepted: greyscale of 8 or 16 bits";
  else if (out.depth != 8 && out.depth != 16)
    out.wrong = "is a PNG of less than 8 bits; accepted: greyscale of 8 or 16 bits";
  else if (rows != nullptr)
    png_read_image(png, rows);
  png_destroy_read_struct(&png, &info, nullptr);
  return out;
}

void check_size(const std::string& path, double width, double height) {
  const auto good = [](double side) { return side >= 2 && side <= largest_side && side == std::floor(side); };
  if (good(width) && good(height)) return;
  throw InputError(path, "found " + format_number(width) + " by " + format_number(height) +
                             " pixels; accepted: a whole number from 2 to 8192 along each side");
}

Image read_png(const std::string& path, std::string_view bytes) {
  const Decoded header = decode(bytes, nullptr);
  if (header.wrong != nullptr) throw InputError(path, header.wrong);
  check_size(path, header.width, header.height);
  const std::size_t width = header.width, height = header.height;
  const std::size_t sample = header.depth == 16 ? 2 : 1;
  std::vector<png_byte> pixels(width * height * sample);
  std::vector<png_bytep> rows(height);
  for (std::size_t k = 0; k < height; ++k) rows[k] = &pixels[k * width * sample];
  if (const Decoded all = decode(bytes, rows.data()); all.wrong != nullptr) throw InputError(path, all.wrong);
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.values.reserve(width * height);
  for (std::size_t iy = 0; iy < height; ++iy)
    for (std::size_t ix = 0; ix < width; ++ix) {
      const png_byte* at = rows[height - 1 - iy] + ix * sample;
      const int value = sample == 2 ? at[0] * 256 + at[1] : at[0];
      image.values.push_back(static_cast<float>(value) / (sample == 2 ? 65535.0F : 255.0F));
    }
  return image;
}

Image read_pfm(const std::string& path, const std::string& bytes) {
  std::istringstream in(bytes);
  std::string magic;
  double width = 0, height = 0, scale = 0;
  in >> magic >> width >> height >> scale;
  if (magic == "PF") throw InputError(path, "is a PFM with colour; accepted: greyscale (Pf)");
  if (!in || in.get() == std::istringstream::traits_type::eof() || scale == 0)
    throw InputError(path, "is a broken PFM: its header is not \"Pf WIDTH HEIGHT SCALE\"");
  check_size(path, width, height);
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const auto begin = static_cast<std::size_t>(in.tellg());
  if (bytes.size() - begin < count * sizeof(float)) throw InputError(path, "is a broken PFM: it ends too early");
  const bool swapped = (scale < 0) != (std::endian::native == std::endian::little);
  image.values.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<char, sizeof(float)> raw{};
    std::memcpy(raw.data(), bytes.data() + begin + k * sizeof(float), sizeof(float));
    if (swapped) std::ranges::reverse(raw);
    image.values[k] = std::bit_cast<float>(raw);
    if (!std::isfinite(image.values[k])) throw InputError(path, "holds a height that is not finite");
  }
  return image;
}

} // namespace

Image read_image(const std::string& path) {
  const std::string bytes = read_text_file(path);
  if (bytes.starts_with("\x89PNG")) return read_png(path, bytes);
  if (bytes.starts_with("Pf") || bytes.starts_with("PF")) return read_pfm(path, bytes);
  throw InputError(path, "is neither a PNG nor a PFM; accepted: greyscale PNG of 8 or 16 bits, greyscale PFM");
}

} // namespace brdfplot::simulation
