#include "microfacet/a_lambda_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

constexpr double smallest = 1e-300;
constexpr double narrowest = 1e-3; ///< of the intervals in ln(1 + a)

} // namespace

/// Interpolates at the Chebyshev points of `piece`; whether the last coefficients are small enough.
bool ALambdaTable::fit(const LogDensity& log_density, Piece& piece) {
  constexpr std::size_t n = order + 1;
  std::array<double, n> y;
  for (std::size_t k = 0; k < n; ++k) {
    const double z = std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / n);
    const double x = 0.5 * (piece.from + piece.to) + 0.5 * (piece.to - piece.from) * z;
    const double value = a_lambda_by_quadrature(log_density, std::expm1(x));
    if (!(value > smallest)) return false;
    y[k] = std::log(value);
  }
  for (std::size_t j = 0; j < n; ++j) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k)
      sum += y[k] * std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(k) + 0.5) / n);
    piece.coefficients[j] = sum * (j == 0 ? 1.0 : 2.0) / n;
  }
  double tail = 0;
  for (std::size_t j = n - 4; j < n; ++j) tail = std::max(tail, std::fabs(piece.coefficients[j]));
  // The rounding of the logarithm itself is in the coefficients.
  return tail < std::max(2e-12, 1e-15 * std::fabs(piece.coefficients[0]));
}

void ALambdaTable::add(Table& table, double from, double to) {
  Piece piece{from, to};
  piece.resolved = fit(table.log_density, piece);
  if (piece.resolved || to - from < narrowest) {
    table.pieces.push_back(piece);
    return;
  }
  const double middle = 0.5 * (from + to);
  add(table, from, middle);
  if (a_lambda_by_quadrature(table.log_density, std::expm1(middle)) > smallest) add(table, middle, to);
}

ALambdaTable::ALambdaTable(LogDensity log_density) {
  auto table = std::make_shared<Table>();
  table->log_density = std::move(log_density);
  for (const double from : {0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0}) {
    if (!(a_lambda_by_quadrature(table->log_density, std::expm1(from)) > smallest)) break;
    add(*table, from, from == 0 || from == 0.5 ? from + 0.5 : 2 * from);
  }
  table_ = std::move(table);
}

double ALambdaTable::operator()(double a) const {
  const double x = std::log1p(a);
  const auto& pieces = table_->pieces;
  const auto after = std::ranges::upper_bound(pieces, x, {}, &Piece::from);
  if (after == pieces.begin() || !(x <= (after - 1)->to) || !(after - 1)->resolved)
    return a_lambda_by_quadrature(table_->log_density, a);
  const Piece& piece = *(after - 1);
  const double z = (2 * x - piece.from - piece.to) / (piece.to - piece.from);
  double b1 = 0; // Clenshaw's recurrence
  double b2 = 0;
  for (std::size_t k = order; k > 0; --k) {
    const double b0 = piece.coefficients[k] + 2 * z * b1 - b2;
    b2 = b1;
    b1 = b0;
  }
  return std::exp(piece.coefficients[0] + z * b1 - b2);
}

} // namespace brdfplot
