#include "config/records/bake_record.hpp"
#include "config/shapes.hpp"

#include <nlohmann/json.hpp>

namespace brdfplot::config {

std::string bake_record(const bake::BakedTable& baked, double rounding) {
  const bake::Table& table = baked.table;
  Json axes = Json::array();
  Json where = Json::object();
  for (std::size_t k = 0; k < table.axes.size(); ++k) {
    const bake::Axis& axis = table.axes[k];
    axes.push_back({{"variable", axis.variable},
                    {"from", axis.from},
                    {"to", axis.to},
                    {"nodes", axis.nodes},
                    {"power", axis.power},
                    {"error", baked.axis_error[k]}});
    where[axis.variable] = baked.where[k];
  }
  const Json error = {{"bound", baked.bound + rounding},
                      {"interpolation", baked.bound - baked.tolerance},
                      {"integrals", baked.tolerance},
                      {"stored", rounding},
                      {"where", std::move(where)}};
  return Json{{"material", table.material}, {"quantity", table.quantity}, {"axes", std::move(axes)},
              {"channels", table.channels}, {"values", table.values},     {"error", error}}
             .dump(2) +
         "\n";
}

} // namespace brdfplot::config
