#include "draw/deflate.hpp"

#include <new>

#include <zlib.h>

namespace brdfplot::plot {

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
  if (result != Z_OK) throw std::bad_alloc(); // the room is enough: nothing else can fail
  out.resize(size);
  return out;
}

} // namespace brdfplot::plot
