/// \file
/// Drawings in other formats than SVG.
#pragma once

#include <optional>
#include <string>

namespace brdfplot::cli {

enum class PictureFormat { svg, png, pdf, csv };

/// What a path asks for by its ending; none: no file of a figure.
std::optional<PictureFormat> format_of(const std::string& path);

/// The drawing as PNG with two pixels for one unit of the SVG, or as PDF with its fonts, by librsvg's rsvg-convert, as
/// wide as `width_mm` where that is not 0. `path` is what errors name. \throws FileError where the program is missing
/// or fails
std::string converted(const std::string& svg, PictureFormat format, double width_mm, const std::string& path);

} // namespace brdfplot::cli
