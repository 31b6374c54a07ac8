#include "stream/columns.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

/// Names of the slots of one direction, without the letter.
constexpr std::array<std::string_view, 5> slot_names = {"theta_", "phi_", "x_", "y_", "z_"};
constexpr std::size_t first_cartesian = 2;
constexpr std::array<char, letter_count> letters = {'o', 'i', 'm'};

/// Each is compared with all the others.
constexpr std::size_t most_columns = 10000;

std::string column_name(std::size_t slot) {
  return std::string(slot_names[slot % slot_names.size()]) + letters[slot / slot_names.size()];
}

} // namespace

DirectionColumns::DirectionColumns(const std::string& header, const std::string& where) : where_(where) {
  const std::string row = header + '\n';
  for (FieldScanner scanner(row); !scanner.at_end();) {
    const std::string name = unquoted(scanner.next());
    if (std::ranges::find(names_, name) != names_.end())
      throw InputError(where, "column \"" + echo(name) + "\" is there twice");
    if (names_.size() == most_columns)
      throw InputError(where, "more than " + std::to_string(most_columns) + " columns; accepted: at most as many");
    std::size_t slot = 0;
    while (slot < no_slot && column_name(slot) != name) ++slot;
    names_.push_back(name);
    slots_.push_back(slot);
  }
  for (std::size_t letter = 0; letter < letter_count; ++letter) choose_form(letter, where);
}

void DirectionColumns::choose_form(std::size_t letter, const std::string& where) {
  const std::size_t first = letter * slots_per_letter;
  std::array<bool, slots_per_letter> given{};
  for (std::size_t k = 0; k < slots_per_letter; ++k) given[k] = std::ranges::find(slots_, first + k) != slots_.end();
  const bool angles = given[0] || given[1];
  const auto cartesian = std::count(given.begin() + first_cartesian, given.end(), true);
  if (angles && cartesian > 0) {
    const auto k =
        static_cast<std::size_t>(std::find(given.begin() + first_cartesian, given.end(), true) - given.begin());
    throw InputError(where, "found \"" + column_name(first + (given[0] ? 0 : 1)) + "\" and \"" +
                                column_name(first + k) +
                                "\", accepted: angles or Cartesian, not both of one direction");
  }
  if (angles && !given[0])
    throw InputError(where, "found \"" + column_name(first + 1) + "\" without \"" + column_name(first) + "\"");
  if (cartesian > 0 && cartesian < 3) {
    const auto k =
        static_cast<std::size_t>(std::find(given.begin() + first_cartesian, given.end(), false) - given.begin());
    throw InputError(where, "\"" + column_name(first + k) + "\" is missing; accepted: x, y and z of a direction");
  }
  forms_[letter] = angles ? Form::angles : cartesian == 3 ? Form::cartesian : Form::none;
}

std::optional<std::string> DirectionColumns::read_row(FieldScanner& scanner,
                                                      std::array<Direction, letter_count>& directions) const {
  Numbers numbers{};
  std::optional<std::string> problem;
  std::size_t column = 0;
  do {
    const bool wanted = column < slots_.size() && slots_[column] != no_slot && !problem;
    if (!wanted)
      scanner.next();
    else if (!scanner.next_number(numbers[slots_[column]]))
      problem = read_number(scanner.next(), column, numbers[slots_[column]]);
    else
      mind_degrees(column, numbers[slots_[column]]);
    ++column;
  } while (!scanner.row_ended());
  if (scanner.cut()) return "a quote is not closed";
  if (column != slots_.size())
    return "found " + std::to_string(column) + (column == 1 ? " field" : " fields") + ", the header has " +
           std::to_string(slots_.size());
  return problem ? problem : read_directions(numbers, directions);
}

std::optional<std::string> DirectionColumns::read_number(std::string_view field, std::size_t column,
                                                         double& number) const {
  const bool angle = slots_[column] % slots_per_letter < first_cartesian;
  auto read = parse_number(field);
  if (read) mind_degrees(column, *read);
  if (!read) {
    const std::string text = unquoted(field);
    read = angle ? parse_angle(text) : parse_number(text);
  }
  if (!read || !std::isfinite(*read))
    return "column \"" + echo(names_[column]) + "\": found \"" + echo(unquoted(field)) +
           "\", accepted: a finite number" + (angle ? " (radians, or with a unit: 80deg)" : "");
  number = *read;
  return std::nullopt;
}

void DirectionColumns::mind_degrees(std::size_t column, double plain) const {
  const bool angle = slots_[column] % slots_per_letter < first_cartesian;
  if (!angle || !(std::abs(plain) > 2 * std::numbers::pi) || !std::isfinite(plain) || warned_->exchange(true)) return;
  warn_of_degrees(where_, names_[column], plain);
}

std::optional<std::string> DirectionColumns::read_directions(const Numbers& numbers,
                                                             std::array<Direction, letter_count>& directions) const {
  for (std::size_t letter = 0; letter < letter_count; ++letter) {
    const double* slot = &numbers[letter * slots_per_letter];
    if (forms_[letter] == Form::angles) directions[letter] = from_angles(slot[0], slot[1]);
    if (forms_[letter] != Form::cartesian) continue;
    const Direction vector{slot[2], slot[3], slot[4]};
    if (vector.x == 0 && vector.y == 0 && vector.z == 0)
      return std::string("(x_") + letters[letter] + ", y_" + letters[letter] + ", z_" + letters[letter] +
             ") is the zero vector: it has no direction";
    directions[letter] = normalized(vector);
  }
  return std::nullopt;
}

} // namespace brdfplot
