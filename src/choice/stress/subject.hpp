/// \file
/// A method under test, and what it gives at rows of inputs.
#pragma once

#include "choice/methods/method.hpp"

#include <cstdint>

namespace brdfplot::choice {

/// A value for each input of a problem.
using Row = std::vector<double>;

/// What a method gives at a row.
struct Trial {
  Row input;
  double value = 0;
  Exact exact; ///< of the same row, whose inputs are numbers of the method's type: their rounding costs nothing
  bool has_exact = true;
  double noise = 0, seen_noise = 0; ///< without an exact value: relative, how far the value is off a smooth curve
  double unequal = 0;               ///< the relative difference where the halves of the inputs change places
  double wrong_way = 0; ///< the largest step of the seen value, relative, against the order of the exact function
  double stated = std::numeric_limits<double>::infinity(); ///< the error that the method states here
};

/// Whether searches take fewer rows.
inline bool is_slow(const Problem& problem) { return problem.samples < 1000; }

class Subject {
public:
  Subject(const Problem& of, const Method& by) : problem_(&of), method_(&by) {}

  const Problem& problem() const { return *problem_; }
  const Method& method() const { return *method_; }

  /// Whether it computes another function in place of the problem's.
  bool is_another_function() const;
  double epsilon() const { return method_->is_single() ? 0x1p-23 : 0x1p-52; }
  double largest() const;
  /// What is seen of a value (Problem::seen).
  double seen(double value) const { return problem_->seen ? problem_->seen(value) : value; }
  /// |value - exact| relative to the latter, or to the root of the smallest normal number of the type where that is
  /// more: 2^-511, in float 2^-63. What is below half of the exponents is as good as 0. Of a function of both signs,
  /// whose relative error means nothing at its root, relative to 1 where it is less.
  double error(const Trial& trial) const;
  /// The same of what is seen. Of another function in place of a share of the light, which is in [0, 1], absolute.
  double seen_error(const Trial& trial) const;

  /// The nearest row of numbers of the method's type inside the domain.
  Row rounded(Row row) const;
  /// The number that lies `steps` numbers of the method's type above, in the domain.
  double stepped(std::size_t input, double from, std::int64_t steps) const;
  /// The place of a number of the method's type in their order.
  std::int64_t place(double x) const;

  std::vector<double> values(const std::vector<Row>& rows) const;
  /// \pre rounded rows; `exact` of each
  std::vector<Trial> trials(const std::vector<Row>& rows, const std::vector<Exact>& exact) const;
  Trial trial(const Row& row) const;

private:
  bool replaces_a_share() const;
  void compare_with_neighbours(std::vector<Trial>& trials) const;
  void compare_with_exchanged(std::vector<Trial>& trials) const;
  /// The relative change of the value by that of an input by two roundings.
  double sensitivity(const Trial& trial) const;
  /// By fourth differences over steps of 2^-16: of a smooth function they vanish, of lost digits they do not.
  void measure_noise(std::vector<Trial>& trials) const;
  void state_errors(std::vector<Trial>& trials) const;

  const Problem* problem_;
  const Method* method_;
};

/// The exact values of rows.
std::vector<Exact> exact_values(const Problem& problem, const std::vector<Row>& rows);

} // namespace brdfplot::choice
