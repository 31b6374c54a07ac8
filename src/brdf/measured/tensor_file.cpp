#include "brdf/measured/tensor_file.hpp"

#include "base/echo.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace brdfplot {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view magic = "tensor_file\0"sv;

/// What the format calls the types of numbers: nothing, integers of 8 to 64 bits without and with sign, and floats.
constexpr std::array<std::size_t, 12> bytes_of_type = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};
constexpr int type_byte = 1, type_float = 10;

/// More than any file of measured data has; a header could ask for four thousand millions.
constexpr std::uint32_t most_arrays = 256;
constexpr std::uint16_t most_dimensions = 8;

std::string shape_text(const std::vector<std::size_t>& shape) {
  std::string text;
  for (const std::size_t length : shape) text += (text.empty() ? "" : " x ") + std::to_string(length);
  return text.empty() ? "none" : text;
}

} // namespace

TensorFile::TensorFile(const std::string& path) : file_(path) {
  std::array<char, magic.size()> start{};
  file_.read_numbers(std::span<char>(start), "the first 12 bytes of a tensor file");
  if (std::string_view(start.data(), start.size()) != magic)
    file_.fail("is no tensor file (.bsdf): it does not begin with \"tensor_file\"");
  const int major = file_.read_number<std::uint8_t>("the version"),
            minor = file_.read_number<std::uint8_t>("the version");
  if (major != 1 || minor != 0)
    file_.fail("found version " + std::to_string(major) + "." + std::to_string(minor) +
               " of a tensor file; accepted: 1.0");
  const auto count = file_.read_number<std::uint32_t>("the number of arrays");
  if (count > most_arrays)
    file_.fail("found " + std::to_string(count) + " arrays; accepted: up to " + std::to_string(most_arrays));
  for (std::uint32_t k = 0; k < count; ++k) read_array();
}

void TensorFile::read_array() {
  const std::string where = "the description of array " + std::to_string(arrays_.size());
  const auto length = file_.read_number<std::uint16_t>(where);
  std::string name(length, '\0');
  file_.read_numbers(std::span<char>(name), where);
  const auto dimensions = file_.read_number<std::uint16_t>(where);
  Array made;
  made.type = file_.read_number<std::uint8_t>(where);
  made.offset = file_.read_number<std::uint64_t>(where);
  const std::string shown = "\"" + echo(name) + "\"";
  if (made.type < 1 || made.type >= static_cast<int>(bytes_of_type.size()))
    file_.fail("found type " + std::to_string(made.type) + " of the array " + shown + "; accepted: 1 to 11");
  if (dimensions > most_dimensions)
    file_.fail("found " + std::to_string(dimensions) + " dimensions of the array " + shown + "; accepted: up to " +
               std::to_string(most_dimensions));
  std::vector<std::uint64_t> lengths(dimensions);
  file_.read_numbers(std::span<std::uint64_t>(lengths), where);
  made.shape.assign(lengths.begin(), lengths.end());
  // By division, since products of what a file says can be too large.
  const bool empty = std::ranges::find(made.shape, std::size_t{0}) != made.shape.end();
  std::uint64_t room = made.offset > file_.size() ? 0 : (file_.size() - made.offset);
  room /= bytes_of_type[static_cast<std::size_t>(made.type)];
  made.count = empty ? 0 : 1;
  for (const std::size_t side : made.shape) {
    if (empty) break;
    room /= side;
    made.count *= side;
  }
  if (room == 0 && !empty)
    file_.fail("found the array " + shown + " of " + shape_text(made.shape) + " numbers from byte " +
               std::to_string(made.offset) + " on, in a file of " + std::to_string(file_.size()) + " bytes");
  if (!arrays_.emplace(name, std::move(made)).second) file_.fail("found the array " + shown + " twice");
}

const TensorFile::Array& TensorFile::array(const std::string& name) const {
  const auto found = arrays_.find(name);
  if (found != arrays_.end()) return found->second;
  std::string names;
  for (const auto& entry : arrays_) names += (names.empty() ? "" : ", ") + echo(entry.first);
  file_.fail("has no array \"" + name + "\"; found: " + echo(names.empty() ? "none" : names, 300));
}

const std::vector<std::size_t>& TensorFile::shape(const std::string& name, std::size_t dimensions) const {
  const Array& found = array(name);
  if (found.type != type_float || found.shape.size() != dimensions)
    file_.fail("found the array \"" + name + "\" with " + std::to_string(found.shape.size()) + " dimensions and type " +
               std::to_string(found.type) + "; accepted: " + std::to_string(dimensions) +
               ", type 10 (float of 32 bits)");
  return found.shape;
}

std::vector<float> TensorFile::floats(const std::string& name) {
  const Array& found = array(name);
  file_.seek(found.offset);
  std::vector<float> values(found.count);
  file_.read_numbers(std::span<float>(values), "the array \"" + name + "\"");
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]))
      file_.fail("found " + format_number(static_cast<double>(values[k])) + " at place " + std::to_string(k) +
                 " of the array \"" + name + "\"; accepted: a finite number");
  return values;
}

int TensorFile::byte(const std::string& name) {
  const Array& found = array(name);
  if (found.type != type_byte || found.count != 1)
    file_.fail("found the array \"" + name + "\" of " + shape_text(found.shape) + " numbers of type " +
               std::to_string(found.type) + "; accepted: one, of type 1 (byte)");
  file_.seek(found.offset);
  return file_.read_number<std::uint8_t>("the array \"" + name + "\"");
}

} // namespace brdfplot
