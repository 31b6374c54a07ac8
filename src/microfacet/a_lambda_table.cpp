#include "microfacet/a_lambda_table.hpp"

#include "math/chebyshev.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <vector>

namespace brdfplot {

namespace {

constexpr double smallest = 1e-300;
constexpr double narrowest = 1e-3; ///< of the intervals in x = ln(1 + a)
constexpr std::size_t node_count = 21;

/// What is interpolated, and how small the last coefficients have to be.
struct Source {
  std::function<double(double)> a_lambda;
  double tail = 0;

  double operator()(double a) const { return a_lambda(a); }
};

struct Piece {
  double from = 0;
  double to = 0;
  std::array<double, node_count> coefficients{};
  bool resolved = false;
  bool vanishes = false; ///< below `smallest` throughout, since a Lambda falls

  double operator()(double x) const {
    const double z = (2 * x - from - to) / (to - from);
    return std::exp(chebyshev_sum(node_count, z, [&](std::size_t k) { return coefficients[k]; }));
  }
};

/// Interpolates at the Chebyshev points of `piece`; whether the last coefficients are small enough.
bool fit(const Source& source, Piece& piece) {
  auto& c = piece.coefficients;
  for (std::size_t k = 0; k < node_count; ++k) {
    const double x = 0.5 * (piece.from + piece.to) + 0.5 * (piece.to - piece.from) * chebyshev_node(k, node_count);
    const double value = source(std::expm1(x));
    if (!(value > smallest)) return false;
    c[k] = std::log(value);
  }
  to_chebyshev_coefficients(c.data(), node_count);
  double tail = 0;
  for (std::size_t j = node_count - 4; j < node_count; ++j) tail = std::max(tail, std::fabs(c[j]));
  // The rounding of the logarithm itself is in the coefficients.
  return tail < std::max(source.tail, 1e-15 * std::fabs(c[0]));
}

void add(const Source& source, double from, double to, std::vector<Piece>& pieces) {
  Piece piece{from, to};
  piece.resolved = fit(source, piece);
  if (!piece.resolved) piece.vanishes = !(source(std::expm1(from)) > smallest);
  if (piece.resolved || piece.vanishes || to - from < narrowest) {
    pieces.push_back(piece);
    return;
  }
  const double middle = 0.5 * (from + to);
  add(source, from, middle, pieces);
  add(source, middle, to, pieces);
}

} // namespace

/// The range of x in blocks, each of which is made whole at its first use.
class ALambdaTable::Blocks {
public:
  explicit Blocks(Source source) : source_(std::move(source)) {}

  double operator()(double a) {
    const double x = std::log1p(a);
    const auto block = static_cast<std::size_t>(std::ranges::upper_bound(starts, x) - starts.begin()) - 1;
    if (block + 1 < starts.size()) {
      const auto& pieces = made(block);
      const Piece& piece = *(std::ranges::upper_bound(pieces, x, {}, &Piece::from) - 1);
      if (piece.resolved) return piece(x);
      if (piece.vanishes) return 0;
    }
    return source_(a);
  }

private:
  static constexpr std::array<double, 15> starts = {0, 0.125, 0.25, 0.5, 1, 1.5, 2, 2.5, 3, 4, 8, 16, 32, 64, 174};

  const std::vector<Piece>& made(std::size_t block) {
    if (!ready_[block].load(std::memory_order_acquire)) {
      const std::lock_guard lock(mutex_);
      if (!ready_[block].load(std::memory_order_relaxed)) {
        std::vector<Piece> pieces;
        add(source_, starts[block], starts[block + 1], pieces);
        pieces_[block] = std::move(pieces);
        ready_[block].store(true, std::memory_order_release);
      }
    }
    return pieces_[block];
  }

  Source source_;
  std::array<std::vector<Piece>, starts.size()> pieces_;
  std::array<std::atomic<bool>, starts.size()> ready_{};
  std::mutex mutex_;
};

ALambdaTable::ALambdaTable(LogDensity log_density, DensityHints hints)
    : blocks_(std::make_shared<Blocks>(Source{[density = std::move(log_density), hints = std::move(hints)](double a) {
                                                return a_lambda_by_quadrature(density, a, hints);
                                              },
                                              2e-12})) {}

ALambdaTable ALambdaTable::of_exact(std::function<double(double)> a_lambda) {
  return ALambdaTable(std::make_shared<Blocks>(Source{std::move(a_lambda), 1e-13}));
}

double ALambdaTable::operator()(double a) const { return (*blocks_)(a); }

} // namespace brdfplot
