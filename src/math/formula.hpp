/// \file
/// A real function that the user writes as text.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace brdfplot {

/// What is wrong with a formula.
struct FormulaProblem {
  std::string unknown; ///< a name that it uses and that there is none of; empty: something else is wrong
  std::string what;    ///< one line, with the position (from 0) where one can be told
};

/// A formula of named variables, in the syntax of muParser: + - * / ^, comparisons, `c ? x : y`, numbers, `pi`, and the
/// functions of names_in_formulas(). Angles are radians, `log` and `ln` are natural.
///
/// Any number of threads may call one formula. It is compiled once a thread, however many copies of it are made.
class Formula {
public:
  /// \throws InputError when problem() finds one.
  Formula(std::string text, std::vector<std::string> variables);

  /// Its value, the variables in the order of the constructor; NaN and infinity where the arithmetic gives them.
  double operator()(std::span<const double> values) const;

  const std::string& text() const { return text_; }

  /// What is wrong with `text`, if anything is.
  static std::optional<FormulaProblem> problem(const std::string& text, const std::vector<std::string>& variables);

private:
  std::string text_;
  std::size_t program_ = 0; ///< in the table of all formulas
};

/// What a formula may use besides its variables: `pi` and the functions, sorted.
std::vector<std::string> names_in_formulas();

} // namespace brdfplot
