#include "choice/methods/operations.hpp"

namespace brdfplot::choice {

Operations& Operations::operator+=(const Operations& other) {
  multiply_adds += other.multiply_adds;
  comparisons += other.comparisons;
  divisions += other.divisions;
  square_roots += other.square_roots;
  exponentials += other.exponentials;
  transcendentals += other.transcendentals;
  table_reads += other.table_reads;
  return *this;
}

double cost(const Operations& operations) {
  return static_cast<double>(operations.multiply_adds + operations.comparisons +
                             4 * (operations.divisions + operations.square_roots + operations.exponentials) +
                             24 * operations.transcendentals + 8 * operations.table_reads);
}

} // namespace brdfplot::choice
