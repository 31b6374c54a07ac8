#include "models/parameters.hpp"

#include "base/echo.hpp"
#include "base/number.hpp"
#include "math/formula.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <utility>

namespace brdfplot {

namespace {

/// Names that errors list, and how long one may be to be taken for a misspelt one.
constexpr std::size_t most_names = 60;
constexpr std::size_t longest_name = 100;

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  std::string out;
  for (const auto& word : words) {
    if (!out.empty()) out += separator;
    out += word;
  }
  return out;
}

std::vector<std::string> keys_of(const ModelSpec& spec) {
  std::vector<std::string> keys;
  for (const auto& parameter : spec.parameters) keys.push_back(parameter.key);
  return keys;
}

/// What is wrong with a formula, with what it may be made of.
std::optional<std::string> problem_with_formula(const std::string& text, const std::vector<std::string>& variables) {
  const auto problem = Formula::problem(text, variables);
  if (!problem) return std::nullopt;
  if (problem->unknown.empty()) return "the formula \"" + echo(text) + "\": " + problem->what;
  std::vector<std::string> names = variables;
  for (auto& name : names_in_formulas()) names.push_back(std::move(name));
  return "the formula \"" + echo(text) + "\": " + problem->what + "; " + unknown_name("name", problem->unknown, names);
}

std::optional<std::string> problem_with(const ParameterSpec& parameter, const Value& value) {
  const auto outside = [&](double x) -> std::optional<std::string> {
    if (parameter.bounds.contains(x)) return std::nullopt;
    return "found " + format_number(x) + ", accepted: " + parameter.bounds.describe();
  };
  if (std::holds_alternative<bool>(value)) return std::nullopt;
  if (const auto* number = std::get_if<double>(&value)) return outside(*number);
  if (const auto* pair = std::get_if<Vec2>(&value)) {
    for (const double x : *pair)
      if (auto problem = outside(x)) return problem;
  } else if (const auto* rgb = std::get_if<Rgb>(&value)) {
    for (const double x : *rgb)
      if (auto problem = outside(x)) return problem;
  } else if (const auto* parts = std::get_if<WeightedChoices>(&value)) {
    if (parts->size() == 0) return "found no component, accepted: one or more";
    for (const WeightedChoice& part : *parts)
      if (auto problem = outside(part.weight)) return "the weight: " + *problem;
  } else if (const auto& word = std::get<std::string>(value); parameter.kind == ParameterKind::formula) {
    return problem_with_formula(word, parameter.choices);
  } else if (parameter.kind == ParameterKind::choice &&
             std::ranges::find(parameter.choices, word) == parameter.choices.end()) {
    return unknown_name("value", word, parameter.choices);
  }
  return std::nullopt;
}

/// That one alternative is given, or what is wrong.
std::optional<ParameterError> problem_with_alternatives(const ModelSpec& spec, const Values& given) {
  if (spec.alternatives.empty()) return std::nullopt;
  std::vector<std::string> keys;
  std::vector<std::string> texts;
  for (const auto& group : spec.alternatives) {
    texts.push_back(join(group, " with "));
    for (const auto& key : group)
      if (given.has(key) && std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  }
  if (given_alternative(spec.alternatives, keys) != nullptr) return std::nullopt;
  const std::string accepted = "accepted: either " + join(texts, ", or ");
  if (keys.empty()) return ParameterError{"", "\"" + spec.type + "\" lacks a parameter; " + accepted};
  for (const auto& key : keys) {
    const bool together = std::ranges::any_of(spec.alternatives, [&](const auto& group) {
      return std::ranges::find(group, key) != group.end() && std::ranges::find(group, keys.front()) != group.end();
    });
    if (!together) return ParameterError{key, "cannot stand beside \"" + keys.front() + "\"; " + accepted};
  }
  return ParameterError{"", "incomplete with \"" + join(keys, "\" and \"") + "\" alone; " + accepted};
}

} // namespace

std::string Bounds::describe() const {
  const bool low = min > -infinity;
  const bool high = max < infinity;
  if (low && high)
    return std::string("a number in ") + (open_min ? "(" : "[") + format_number(min) + ", " + format_number(max) +
           (open_max ? ")" : "]");
  if (low) return std::string("a number ") + (open_min ? "> " : ">= ") + format_number(min);
  if (high) return std::string("a number ") + (open_max ? "< " : "<= ") + format_number(max);
  return "a finite number";
}

const ParameterSpec* ModelSpec::find(std::string_view key) const {
  const auto found = std::ranges::find(parameters, key, &ParameterSpec::key);
  return found == parameters.end() ? nullptr : &*found;
}

Rgb Values::rgb(std::string_view key) const {
  const Value& value = map_.find(key)->second;
  if (const auto* number = std::get_if<double>(&value)) return {*number, *number, *number};
  return std::get<Rgb>(value);
}

WeightedChoices::WeightedChoices() = default;
WeightedChoices::WeightedChoices(std::initializer_list<WeightedChoice> items) : items_(items) {}
WeightedChoices::WeightedChoices(const WeightedChoices& other) = default;
WeightedChoices::WeightedChoices(WeightedChoices&& other) noexcept = default;
WeightedChoices& WeightedChoices::operator=(const WeightedChoices& other) = default;
WeightedChoices& WeightedChoices::operator=(WeightedChoices&& other) noexcept = default;
WeightedChoices::~WeightedChoices() = default;

void WeightedChoices::push_back(WeightedChoice item) { items_.push_back(std::move(item)); }
std::size_t WeightedChoices::size() const { return items_.size(); }
const WeightedChoice* WeightedChoices::begin() const { return items_.data(); }
const WeightedChoice* WeightedChoices::end() const { return items_.data() + items_.size(); }

const WeightedChoices& Values::components(std::string_view key) const {
  return std::get<WeightedChoices>(map_.find(key)->second);
}

const std::vector<std::string>* given_alternative(const std::vector<std::vector<std::string>>& groups,
                                                  const std::vector<std::string>& keys) {
  for (const auto& group : groups) {
    const auto given = [&](const std::string& key) { return std::ranges::find(keys, key) != keys.end(); };
    const auto grouped = [&](const std::string& key) { return std::ranges::find(group, key) != group.end(); };
    if (std::ranges::all_of(group, given) && std::ranges::all_of(keys, grouped)) return &group;
  }
  return nullptr;
}

std::variant<Values, ParameterError> complete(const ModelSpec& spec, const Values& given) {
  for (const auto& [key, value] : given.map()) {
    const ParameterSpec* parameter = spec.find(key);
    for (const auto& [other, why] : spec.refused)
      if (other == key) return ParameterError{key, why};
    if (parameter == nullptr) return ParameterError{key, unknown_name("parameter of " + spec.type, key, keys_of(spec))};
    if (auto problem = problem_with(*parameter, value)) return ParameterError{key, *problem};
  }
  if (auto problem = problem_with_alternatives(spec, given)) return *problem;
  Values all = given;
  for (const auto& parameter : spec.parameters) {
    if (all.has(parameter.key)) continue;
    if (parameter.fallback) {
      all.set(parameter.key, *parameter.fallback);
      continue;
    }
    const bool alternative = std::ranges::any_of(
        spec.alternatives, [&](const auto& group) { return std::ranges::find(group, parameter.key) != group.end(); });
    if (!alternative)
      return ParameterError{"", "\"" + spec.type + "\" needs \"" + parameter.key + "\": " + parameter.doc};
  }
  return all;
}

namespace {

/// Lower case, without what only joins words: "alphaX" and "alpha_x" are the same.
std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (c != '_' && c != '-' && c != ' ') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// What other programs call it.
std::string_view usual_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> names = {{{"ior", "eta"},
                                                                                    {"int_ior", "eta"},
                                                                                    {"n", "eta"},
                                                                                    {"base_color", "albedo"},
                                                                                    {"reflectance", "albedo"},
                                                                                    {"reflectivity", "f0"},
                                                                                    {"anisotropy", "disney_anisotropy"},
                                                                                    {"trowbridge_reitz", "ggx"},
                                                                                    {"metal", "conductor"},
                                                                                    {"glass", "dielectric"},
                                                                                    {"charlie", "sheen"},
                                                                                    {"uncorrelated", "separable"}}};
  for (const auto& [other, ours] : names)
    if (plain(other) == plain(name)) return ours;
  return name;
}

/// The accepted name that is the same word, written in another way.
std::optional<std::string> same_word(std::string_view name, const std::vector<std::string>& accepted) {
  const std::string_view usual = usual_name(name);
  for (const std::string& other : accepted)
    if (plain(other) == plain(usual)) return other;
  return std::nullopt;
}

/// The only accepted name that is a whole word of `name`: "ggx" of "smith-ggx".
std::optional<std::string> word_of(std::string_view name, const std::vector<std::string>& accepted) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      words.back() += c;
    else
      words.emplace_back();
  }
  std::optional<std::string> found;
  for (const std::string& other : accepted) {
    const bool is_word =
        std::ranges::any_of(words, [&](const std::string& word) { return plain(word) == plain(other); });
    if (is_word && found) return std::nullopt;
    if (is_word) found = other;
  }
  return found;
}

} // namespace

std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& accepted) {
  if (name.size() > longest_name) return std::nullopt;
  if (auto found = same_word(name, accepted)) return found;
  const auto distance = [&](std::string_view other) {
    std::vector<std::size_t> row(other.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= name.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= other.size(); ++j) {
        const std::size_t replaced = diagonal + (name[i - 1] == other[j - 1] ? 0 : 1);
        diagonal = row[j];
        row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
      }
    }
    return row.back();
  };
  const auto best = std::ranges::min_element(accepted, {}, distance);
  if (best == accepted.end() || distance(*best) > std::max<std::size_t>(2, name.size() / 3))
    return word_of(name, accepted);
  return *best;
}

std::string unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& accepted) {
  std::string text = "unknown " + std::string(what) + " \"" + echo(name) + "\"";
  const auto near = nearest(name, accepted);
  text += near ? "; did you mean \"" + echo(*near) + "\"?" : ";";
  if (accepted.empty()) return text + " accepted: none";
  std::vector<std::string> shown;
  for (std::size_t k = 0; k < std::min(accepted.size(), most_names); ++k) shown.push_back(echo(accepted[k]));
  if (accepted.size() > most_names) shown.push_back("and " + std::to_string(accepted.size() - most_names) + " more");
  return text + " accepted: " + join(shown, ", ");
}

} // namespace brdfplot
