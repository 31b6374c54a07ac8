/// \file
/// a Lambda(a) of a density without a closed form, interpolated.
#pragma once

#include "microfacet/smith_quadrature.hpp"

#include <array>
#include <memory>
#include <vector>

namespace brdfplot {

/// a_lambda_by_quadrature() at the price of an exponential: ln(a Lambda) in Chebyshev polynomials of degree 20 of
/// ln(1 + a), on intervals halved until the last coefficients are below 2e-12. Relative error <= 1e-10 from a = 0 up to
/// where a Lambda falls below 1e-300; below it, and on intervals where the density has a kink, the quadrature itself is
/// asked. Copies share the table. Making one takes some milliseconds.
class ALambdaTable {
public:
  /// \throws AccuracyError as a_lambda_by_quadrature().
  explicit ALambdaTable(LogDensity log_density);

  /// a Lambda(a), a in [0, infinity].
  double operator()(double a) const;

private:
  static constexpr std::size_t order = 20;
  struct Piece {
    double from = 0; ///< in x = ln(1 + a)
    double to = 0;
    std::array<double, order + 1> coefficients{};
    bool resolved = false;
  };
  struct Table {
    LogDensity log_density;
    std::vector<Piece> pieces;
  };

  static bool fit(const LogDensity& log_density, Piece& piece);
  static void add(Table& table, double from, double to);

  std::shared_ptr<const Table> table_;
};

} // namespace brdfplot
