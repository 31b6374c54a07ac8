#include "accuracy/measure.hpp"

#include "../sample.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <charconv>
#include <cstdlib>
#include <fstream>

namespace brdfplot::accuracy {

std::size_t inputs_per_row() { return test::random_inputs("BRDFPLOT_ACCURACY_INPUTS", 8000, 500); }

std::string text(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

template <>
double Random::pattern(double low, double high) {
  const auto first = std::bit_cast<std::uint64_t>(low), last = std::bit_cast<std::uint64_t>(high);
  return std::bit_cast<double>(first + engine_() % (last - first));
}

template <>
float Random::pattern(float low, float high) {
  const auto first = std::bit_cast<std::uint32_t>(low), last = std::bit_cast<std::uint32_t>(high);
  return std::bit_cast<float>(first + static_cast<std::uint32_t>(engine_() % (last - first)));
}

void Row::write() const {
  const char* const path = std::getenv("BRDFPLOT_ACCURACY_TABLE");
  if (path == nullptr) return;
  static bool started = false;
  std::ofstream file(path, started ? std::ios::app : std::ios::trunc);
  if (!started)
    file << "function,type,isa,domain,inputs,bound_ulp,bound_ulp_per_exponent,max_ulp,rms_ulp,worst_input\n";
  started = true;
  file << function_ << ',' << type_ << ',' << isa_ << ",\"" << domain_ << "\"," << count_ << ',' << text(bound_.ulp)
       << ',' << text(bound_.per_exponent) << ',' << text(largest_) << ','
       << text(std::sqrt(sum_of_squares_ / static_cast<double>(std::max<std::size_t>(count_, 1)))) << ",\"" << worst_
       << "\"\n";
}

void finish(const Row& row) {
  row.write();
  CHECK_MESSAGE(row.count() > 0, row.label());
  CHECK_MESSAGE(row.largest() <= row.bound(), row.label());
}

} // namespace brdfplot::accuracy
