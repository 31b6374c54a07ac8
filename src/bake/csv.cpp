#include "bake/formats.hpp"

#include "base/number.hpp"

namespace brdfplot::bake {

std::string csv_text(const BakedTable& baked, Stored, const std::string&) {
  const Table& table = baked.table;
  std::string text;
  for (const Axis& axis : table.axes) text += axis.variable + ",";
  for (std::size_t c = 0; c < table.channels.size(); ++c) text += (c == 0 ? "" : ",") + table.channels[c];
  text += "\n";
  for (std::size_t node = 0; node < table.nodes(); ++node) {
    std::size_t rest = node;
    for (const Axis& axis : table.axes) {
      const std::size_t k = rest % axis.nodes;
      rest /= axis.nodes;
      text += format_number(axis.at(static_cast<double>(k) / static_cast<double>(axis.nodes - 1))) + ",";
    }
    for (std::size_t c = 0; c < table.channels.size(); ++c)
      text += (c == 0 ? "" : ",") + format_number(table.values[node * table.channels.size() + c]);
    text += "\n";
  }
  return text;
}

} // namespace brdfplot::bake
