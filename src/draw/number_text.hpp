/// \file
/// Numbers as a reader of a figure wants them: few digits for coordinates, proper minus signs for labels.
#pragma once

#include <string>

namespace brdfplot::plot {

/// Appends a coordinate rounded to hundredths, without needless digits: "12.5", "-0.25", "3".
void append_fixed(std::string& out, double value);

/// Appends a coordinate given in hundredths as short as path data allows: "12.5", "-.25", "3".
void append_hundredths(std::string& out, long long hundredths);

/// The number with this many decimals and a typographic minus; never "-0".
std::string decimal_label(double value, int decimals);

/// "5·10^{-3}" in label markup: the value as a multiple of a power of ten; zero is "0".
std::string power_label(double value, int exponent, int decimals);

} // namespace brdfplot::plot
