/// \file
/// Text made small, as browsers make it large again.
#pragma once

#include <string>
#include <string_view>

namespace brdfplot::plot {

/// The bytes as a zlib stream (RFC 1950), which is what browsers call "deflate". The same for the same bytes and
/// version of zlib. \throws std::bad_alloc
std::string deflated(std::string_view bytes);

} // namespace brdfplot::plot
