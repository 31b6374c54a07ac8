#include "bake/formats.hpp"

namespace brdfplot::bake {

/// NumPy's format 1.0: an array in C order, the axes in reverse, the values of a node last.
std::string npy_bytes(const BakedTable& baked, Stored stored, const std::string&) {
  const Table& table = baked.table;
  std::string shape;
  for (std::size_t k = table.axes.size(); k-- > 0;) shape += std::to_string(table.axes[k].nodes) + ", ";
  shape += std::to_string(table.channels.size());
  const char* const type = stored == Stored::half ? "<f2" : stored == Stored::float32 ? "<f4" : "<f8";
  std::string header = std::string("{'descr': '") + type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
  constexpr std::size_t before = 10, alignment = 64;
  header.append(alignment - (before + header.size() + 1) % alignment, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += '\x01';
  bytes += '\0';
  append_bytes(bytes, header.size(), 2);
  bytes += header;
  for (const double value : table.values) append_number(bytes, value, stored);
  return bytes;
}

} // namespace brdfplot::bake
