/// \file
/// Tables as files.
#pragma once

#include "bake/table.hpp"

#include <string>
#include <vector>

namespace brdfplot::bake {

/// How numbers are stored in a file.
enum class Stored {
  float32, ///< IEEE binary32
  half,    ///< IEEE binary16, in .npy, .ktx2 and .exr
  float64, ///< IEEE binary64, in .npy
};

/// The nearest number of that kind. Values of tables are of order 1: none overflows.
double rounded(double value, Stored stored);
/// The largest |rounded - value| of a table.
double rounding_of(const Table& table, Stored stored);

/// A file's ending, with what is written under it.
struct TableFormat {
  std::string ending;
  std::string doc;
  std::vector<Stored> stored; ///< what it can hold, the first by default
  std::string (*bytes)(const BakedTable& baked, Stored stored, const std::string& path);
};

const std::vector<TableFormat>& table_formats();

/// The format of a file by the ending of its name. \throws InputError
const TableFormat& format_of(const std::string& path);

std::string npy_bytes(const BakedTable& baked, Stored stored, const std::string& path);
std::string ktx2_bytes(const BakedTable& baked, Stored stored, const std::string& path);
std::string exr_bytes(const BakedTable& baked, Stored stored, const std::string& path);
std::string c_header(const BakedTable& baked, Stored stored, const std::string& path);
std::string glsl_source(const BakedTable& baked, Stored stored, const std::string& path);
std::string csv_text(const BakedTable& baked, Stored stored, const std::string& path);

/// The table's description, a line each: axes, how they are read, what its error is. Formats have it as comments.
std::vector<std::string> description_of(const BakedTable& baked);

/// Bytes of a number, little-endian, appended.
template <class Number>
void append_bytes(std::string& bytes, Number number, std::size_t count = sizeof(Number)) {
  for (std::size_t k = 0; k < count; ++k) bytes.push_back(static_cast<char>(number >> 8 * k & 0xFF));
}

/// A value as it is stored, appended.
void append_number(std::string& bytes, double value, Stored stored);

} // namespace brdfplot::bake
