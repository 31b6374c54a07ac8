/// \file
/// Parameters that know themselves: a model declares key, bounds, default, unit and meaning once; the JSON reader, the
/// JSON Schema, `brdfplot list`, the errors and the sweeps of figures all derive from that declaration.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace brdfplot {

using Vec2 = std::array<double, 2>;
using Rgb = std::array<double, 3>;
struct WeightedChoice;

/// The components of a mixture. A class, not an alias of the vector, since Value needs it before what it holds is
/// complete.
class WeightedChoices {
public:
  WeightedChoices();
  WeightedChoices(std::initializer_list<WeightedChoice> items);
  WeightedChoices(const WeightedChoices& other);
  WeightedChoices(WeightedChoices&& other) noexcept;
  WeightedChoices& operator=(const WeightedChoices& other);
  WeightedChoices& operator=(WeightedChoices&& other) noexcept;
  ~WeightedChoices();

  void push_back(WeightedChoice item);
  std::size_t size() const;
  const WeightedChoice* begin() const;
  const WeightedChoice* end() const;

private:
  std::vector<WeightedChoice> items_;
};

using Value = std::variant<double, Vec2, Rgb, std::string, WeightedChoices, bool>;

struct ModelSpec;

enum class ParameterKind {
  number,
  number_or_rgb, ///< a scalar stands for three equal channels
  vec2,
  vec3,
  boolean,    ///< true or false
  choice,     ///< one of `choices`
  formula,    ///< text: a formula (math/formula.hpp) of the variables `choices`
  text,       ///< any: the path of a file
  components, ///< weighted models of the list `models`
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// An interval of accepted numbers; `open` ends are excluded.
struct Bounds {
  double min = -infinity;
  double max = infinity;
  bool open_min = false;
  bool open_max = false;

  bool contains(double x) const {
    return (open_min ? x > min : x >= min) && (open_max ? x < max : x <= max) && x - x == 0;
  }
  std::string describe() const; ///< "a number > 0", "a number in [-1, 1]"
};

struct ParameterSpec {
  std::string key;
  ParameterKind kind = ParameterKind::number;
  Bounds bounds{};
  std::optional<Value> fallback{}; ///< value when the key is missing; none: required, or one of `alternatives`
  std::string doc;
  std::vector<std::string> choices{};
  const std::vector<ModelSpec>& (*models)() = nullptr;
};

/// What there is to know of a model before one is made.
struct ModelSpec {
  std::string type;   ///< its name in JSON
  std::string doc;    ///< one line
  std::string source; ///< author, year, equation
  std::vector<ParameterSpec> parameters{};
  /// Groups of keys of which exactly one must be given, whole, and nothing of the others (but what it shares with
  /// them). Empty: every parameter without default is required.
  std::vector<std::vector<std::string>> alternatives{};
  /// Keys that its like have and it cannot, each with the reason.
  std::vector<std::pair<std::string, std::string>> refused{};

  const ParameterSpec* find(std::string_view key) const;
};

/// The parameters of one model, checked against its spec.
class Values {
public:
  bool has(std::string_view key) const { return map_.find(key) != map_.end(); }
  double number(std::string_view key) const { return get<double>(key); }
  Vec2 vec2(std::string_view key) const { return get<Vec2>(key); }
  std::string text(std::string_view key) const { return get<std::string>(key); }
  bool flag(std::string_view key) const { return get<bool>(key); }
  const WeightedChoices& components(std::string_view key) const;
  /// A scalar is spread over three channels.
  Rgb rgb(std::string_view key) const;
  bool is_rgb(std::string_view key) const { return std::holds_alternative<Rgb>(map_.find(key)->second); }
  void set(std::string key, Value value) { map_.insert_or_assign(std::move(key), std::move(value)); }

  const std::map<std::string, Value, std::less<>>& map() const { return map_; }

private:
  template <class T>
  T get(std::string_view key) const {
    return std::get<T>(map_.find(key)->second);
  }
  std::map<std::string, Value, std::less<>> map_;
};

/// A model by name, before it is built.
struct ModelChoice {
  std::string type;
  Values values{}; ///< only what was given; build() adds the defaults
};

/// One of the models that a mixture is made of.
struct WeightedChoice {
  double weight = 1;
  ModelChoice model;
};

/// What is wrong with a parameter: which one (empty: the model as a whole) and why. The key may go on as a JSON pointer
/// into the parameter.
struct ParameterError {
  std::string key;
  std::string what;
};

/// A model, or why it cannot be made of parameters that are good one by one.
template <class Model>
using Made = std::variant<Model, ParameterError>;

/// The group that `keys` are, in whatever order; nothing when they are none of them.
const std::vector<std::string>* given_alternative(const std::vector<std::vector<std::string>>& groups,
                                                  const std::vector<std::string>& keys);

/// `given` with the defaults of `spec` added, or what is wrong: unknown key, missing key, value out of bounds, two
/// alternatives at once.
std::variant<Values, ParameterError> complete(const ModelSpec& spec, const Values& given);

/// `"xyz"; did you mean "xy"?`-style help: the entry of `accepted` nearest to `name` by edit distance, if near.
std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& accepted);

/// "unknown WHAT \"name\"; did you mean \"x\"? accepted: a, b, c"
std::string unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& accepted);

} // namespace brdfplot
