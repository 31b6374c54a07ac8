/// \file
/// Tensor files, in which measured BRDFs of EPFL's Realistic Graphics Lab are kept.
#pragma once

#include "base/binary_file.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace brdfplot {

/// Arrays by name: "tensor_file\0", version 1.0, how many there are (uint32); of each the length of its name (uint16),
/// the name, how many dimensions it has (uint16), the type of its numbers (a byte), where it begins (uint64) and its
/// lengths (uint64 each); little-endian. The last index runs fastest.
class TensorFile {
public:
  /// Reads the list of arrays, and checks that each lies within the file.
  /// \throws FileError, InputError
  explicit TensorFile(const std::string& path);

  /// The lengths of an array of 32-bit floats. \throws InputError: there is none of this name, of this type, or with so
  /// many dimensions
  const std::vector<std::size_t>& shape(const std::string& name, std::size_t dimensions) const;
  /// Its numbers, all finite. \throws InputError
  std::vector<float> floats(const std::string& name);
  /// The only number of an array of one byte. \throws InputError
  int byte(const std::string& name);

  std::uint64_t size() const { return file_.size(); }
  [[noreturn]] void fail(const std::string& what) const { file_.fail(what); }

private:
  struct Array {
    int type = 0;
    std::uint64_t offset = 0;
    std::vector<std::size_t> shape;
    std::size_t count = 0;
  };
  void read_array();
  const Array& array(const std::string& name) const;

  BinaryFile file_;
  std::map<std::string, Array> arrays_;
};

} // namespace brdfplot
