/// \file
/// Bytes as text.
#pragma once

#include <string>
#include <string_view>

namespace brdfplot::plot {

/// Appends the bytes in base64, padded (RFC 4648).
void append_base64(std::string& out, std::string_view bytes);

} // namespace brdfplot::plot
