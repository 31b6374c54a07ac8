/// \file
/// Binary files whose length is known before anything of them is read.
#pragma once

#include "base/text_files.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace brdfplot {

/// A regular file that is read in order of its bytes. Numbers in it are little-endian. What a header asks for is
/// compared with what is left() before memory is taken for it.
class BinaryFile {
public:
  /// \throws FileError when it cannot be opened, or is no regular file, and has no length
  explicit BinaryFile(const std::string& path);

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }
  std::uint64_t left() const { return size_ - position_; }

  /// \throws InputError "ends within WHAT" when so many bytes are not left.
  void read(std::span<std::byte> to, const std::string& what);
  /// Goes on reading at a byte of the file, at most its end.
  void seek(std::uint64_t position);

  template <class Number>
  void read_numbers(std::span<Number> to, const std::string& what) {
    read(std::as_writable_bytes(to), what);
    if constexpr (std::endian::native == std::endian::big && sizeof(Number) > 1)
      for (Number& number : to) std::ranges::reverse(std::as_writable_bytes(std::span(&number, 1)));
  }
  template <class Number>
  Number read_number(const std::string& what) {
    Number number{};
    read_numbers(std::span(&number, 1), what);
    return number;
  }

  /// \throws InputError at this file
  [[noreturn]] void fail(const std::string& what) const;

private:
  std::string path_;
  InputFile file_;
  std::uint64_t size_ = 0, position_ = 0;
};

} // namespace brdfplot
