/// \file
/// What the levels of a figure hand down, and the check of a term where it stands.
#pragma once

#include "config/shapes.hpp"
#include "figure/description.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::config {

/// What outer levels hand down: figure to panel to series to operand.
struct Scope {
  std::optional<MaterialDescription> material;
  std::string material_name; ///< in labels
  bool each_channel = false; ///< of what is coloured, each in a series of its own
  std::vector<plot::Setting> at;
  std::vector<std::string> places;          ///< where each of `at` stands
  std::map<std::string, std::string> words; ///< what {variable} becomes

  void set(plot::Setting setting, std::string place) {
    at.push_back(std::move(setting));
    places.push_back(std::move(place));
  }
};

/// A number, or an angle with its unit.
bool is_numeric(const Json& value);

/// A number, an angle with its unit, an angle that follows another ("phi_o+180deg", "-theta_o"), or a word.
plot::Setting to_setting(const std::string& variable, const Json& value);

/// "60°" for "60deg", the number or the word otherwise.
std::string word_for(const Json& value);

/// The text with every {variable} replaced by its word.
std::string substituted(std::string text, const std::map<std::string, std::string>& words);

/// `simulate` of a term.
plot::Simulate read_simulate(const Json& value);

/// A swept variable, its ends, and where its axis stands.
struct Sweep {
  std::string variable, place;
  double from, to;
};

/// Tries everything but the values of the term at `pointer`, so that what is wrong is told where it stands.
void check_term(const JsonFile& file, const plot::Term& term, const std::string& pointer, const Scope& scope,
                const std::vector<Sweep>& swept, double tolerance);

} // namespace brdfplot::config
