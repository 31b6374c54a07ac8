/// \file
/// Numbers in a caption, read from the figure that it belongs to, so that they cannot differ from what is drawn.
#pragma once

#include "draw/model.hpp"

#include <limits>
#include <string>
#include <vector>

namespace brdfplot::plot {

/// What is read from a figure.
struct Reading {
  enum class Take { at, largest, smallest, note } take = Take::at;
  std::size_t panel = 0;
  std::string series{};    ///< its label, or that of a note
  bool any_series = false; ///< extremes: of all series, or of a heat map, instead of one
  double x = 0;            ///< Take::at: where, on the straight line between the points that are drawn
  double from = -std::numeric_limits<double>::infinity(); ///< extremes: of the points from here ...
  double to = std::numeric_limits<double>::infinity();    ///< ... to here
  bool place = false;                                     ///< extremes: x of it instead of the value
  bool magnitude = false;                                 ///< extremes: of the absolute values
};

/// A reading, or a combination of two.
struct NumberExpression {
  enum class Operation { reading, difference, ratio } operation = Operation::reading;
  Reading reading;
  std::vector<NumberExpression> operands; ///< two for difference and ratio
};

/// How it is written.
struct NumberDescription {
  std::string name; ///< {name} in the caption
  NumberExpression value;
  enum class Form { plain, percent, degrees } form = Form::plain;
  int digits = 2; ///< significant ones
};

/// The value of a number. `figure` has the panels that were described when the number was.
/// \throws InputError where there is no such series or note (which there are), or x, or the value there, is outside of
/// what is drawn
double value_of(const NumberExpression& number, const Figure& figure);

/// "1.52", "0.32 %", "89°": so many significant digits, as power of ten below 1e-4 and from 1e6 on.
std::string text_of(double value, NumberDescription::Form form, int digits);

/// The names in braces of a text, but for the groups of sub- and superscripts ("_{xyz}", "^{xyz}").
std::vector<std::string> names_in(const std::string& text);

/// The caption with every {name} replaced by its number. \throws InputError
std::string caption_with(const std::string& caption, const std::vector<NumberDescription>& numbers,
                         const Figure& figure);

} // namespace brdfplot::plot
