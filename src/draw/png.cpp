#include "draw/png.hpp"

#include <new>

#include <png.h>

namespace brdfplot::plot {

namespace {

unsigned format_of(const Picture& picture) {
  if (picture.channels == 1) return picture.opaque ? PNG_FORMAT_GRAY : PNG_FORMAT_GA;
  return picture.opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
}

} // namespace

std::string to_png(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = format_of(picture);
  // What it may take at most, told by the library without packing it.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string out(size, '\0');
  const int written = png_image_write_to_memory(&image, out.data(), &size, 0, picture.bytes.data(), 0, nullptr);
  png_image_free(&image);
  if (written == 0) throw std::bad_alloc(); // the room is enough: nothing else can fail
  out.resize(size);
  return out;
}

} // namespace brdfplot::plot
