#include "choice/advise/target.hpp"

#include <algorithm>
#include <stdexcept>

namespace brdfplot::choice {

namespace {

struct Weights {
  double multiply_add, comparison, division, root, exponential, transcendental, table_read;
};

constexpr Weights one_double = {1, 1, 7, 15, 25, 40, 3}, one_float = {1, 1, 5, 8, 18, 28, 3};
constexpr Weights lane_double = {1, 1, 6, 14, 20, 32, 18}, lane_float = {0.5, 0.5, 3, 4, 8, 11, 16};

double weighted(const Operations& operations, const Weights& by) {
  return by.multiply_add * static_cast<double>(operations.multiply_adds) +
         by.comparison * static_cast<double>(operations.comparisons) +
         by.division * static_cast<double>(operations.divisions) +
         by.root * static_cast<double>(operations.square_roots) +
         by.exponential * static_cast<double>(operations.exponentials) +
         by.transcendental * static_cast<double>(operations.transcendentals) +
         by.table_read * static_cast<double>(operations.table_reads);
}

bool in_lanes(Target target) { return target == Target::double_lanes || target == Target::float_lanes; }

} // namespace

const std::vector<std::string>& target_names() {
  static const std::vector<std::string> names = {"shader", "double", "double_simd", "float", "float_simd"};
  return names;
}

Target target_of(const std::string& name) {
  const auto found = std::ranges::find(target_names(), name);
  if (found == target_names().end()) throw std::out_of_range(name);
  return static_cast<Target>(found - target_names().begin());
}

Precision precision_of(Target target) {
  return target == Target::float_one || target == Target::float_lanes ? Precision::single : Precision::full;
}

double cost(const Operations& operations, Target target, Precision precision) {
  if (target == Target::shader) return cost(operations);
  const bool single = precision == Precision::single;
  if (in_lanes(target)) return weighted(operations, single ? lane_float : lane_double);
  return weighted(operations, single ? one_float : one_double);
}

std::string cost_unit(Target target) {
  if (target == Target::shader) return "estimated operations";
  return in_lanes(target) ? "estimated multiply-adds of a lane in double" : "estimated multiply-adds in double";
}

} // namespace brdfplot::choice
