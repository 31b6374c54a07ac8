/// \file
/// Which columns of a CSV hold directions, and the directions of a row.
#pragma once

#include "math/direction.hpp"
#include "stream/rows.hpp"

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdfplot {

/// The directions that a row may have, in this order everywhere.
enum class Letter { o, i, m };
inline constexpr std::size_t letter_count = 3;

/// The header of a CSV, understood. Directions are angles, `theta_o phi_o` (a missing phi is 0), or Cartesian, `x_o y_o
/// z_o`; so for i and m. Other columns are passed through.
class DirectionColumns {
public:
  /// \throws InputError at `where` for a column that is there twice, both forms of one direction, or half of one.
  DirectionColumns(const std::string& header, const std::string& where);

  const std::vector<std::string>& names() const { return names_; }
  bool has(Letter letter) const { return forms_[static_cast<std::size_t>(letter)] != Form::none; }

  /// Reads the fields of the scanner's next row into unit vectors; those that there are no columns for stay as they
  /// are. Numbers are radians, or have a unit ("80deg"); Cartesian ones are plain. What is wrong, or nothing.
  std::optional<std::string> read_row(FieldScanner& scanner, std::array<Direction, letter_count>& directions) const;

private:
  enum class Form { none, angles, cartesian };
  static constexpr std::size_t slots_per_letter = 5; ///< theta, phi, x, y, z
  static constexpr std::size_t no_slot = letter_count * slots_per_letter;
  using Numbers = std::array<double, no_slot + 1>;

  void choose_form(std::size_t letter, const std::string& where);
  std::optional<std::string> read_number(std::string_view field, std::size_t column, double& number) const;
  /// Warns, once, of a plain number that must be degrees.
  void mind_degrees(std::size_t column, double plain) const;
  std::optional<std::string> read_directions(const Numbers& numbers,
                                             std::array<Direction, letter_count>& directions) const;

  std::string where_; ///< the header
  std::vector<std::string> names_;
  std::vector<std::size_t> slots_; ///< of every column
  std::array<Form, letter_count> forms_{};
  std::shared_ptr<std::atomic<bool>> warned_ = std::make_shared<std::atomic<bool>>(false); ///< of degrees, once
};

} // namespace brdfplot
