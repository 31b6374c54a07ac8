/// \file
/// Directions on a grid, as rows of a CSV that is never written.
#pragma once

#include "stream/rows.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace brdfplot {

/// The values of one angle, evenly spaced.
struct GridAxis {
  std::string name; ///< theta_o, phi_o, theta_i, phi_i, theta_m or phi_m
  double from = 0, to = 0, step = 1;
  bool degrees = false; ///< of the three numbers above
  std::uint64_t count = 1;

  /// The k-th value, in radians; in degrees it is the double that a CSV with "37deg" gives. The last is `to` itself
  /// where it is a whole number of steps away, as far as rounding shows.
  double value(std::uint64_t k) const;
};

/// Reads "theta_o=0:90deg:1deg", or "theta_o=60deg" for a single value. \throws InputError at `where`
GridAxis grid_axis(const std::string& text, const std::string& where);

/// The product of axes, the last the fastest, as rows under a header; made as they are read.
class GridRows : public RowSource {
public:
  /// \throws InputError at `where`, which errors name, for an axis that is wrong or there twice, a phi without its
  /// theta, and more than 10^9 rows.
  GridRows(const std::vector<std::string>& axes, std::string where);

  const std::string& name() const override { return where_; }
  std::string header_name(std::size_t) const override { return where_; }
  std::size_t read(char* to, std::size_t size) override;
  void stop() override { stopped_ = true; }

private:
  void append_row(std::uint64_t row);

  std::string where_;
  std::vector<GridAxis> axes_;
  std::uint64_t rows_ = 1;
  std::uint64_t next_ = 0;
  std::string text_; ///< of rows that are made, but not read yet
  std::atomic<bool> stopped_{false};
};

} // namespace brdfplot
