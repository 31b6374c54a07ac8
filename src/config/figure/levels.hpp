/// \file
/// What figure, panels, series and operands take from their JSON alike: the material, settings, and repetition.
#pragma once

#include "config/figure/scope.hpp"

#include <functional>

namespace brdfplot::config {

class Levels {
public:
  /// Reads the figure's `materials`.
  explicit Levels(const JsonFile& file);

  /// Takes `material`, `channel` and `at` of an object into the scope.
  void enter(Scope& scope, const Json& object, const std::string& pointer) const;

  /// Calls `make` for every combination of the values of `for_each` (once when there is none), with the place of the
  /// value among its fellows in [0, 1] where they form a family of numbers.
  using Make = std::function<void(const Scope& scope, std::optional<double> ramp)>;
  void for_each(const Json& object, const std::string& pointer, const Scope& scope, const Make& make) const;

private:
  /// One variable of a `for_each`, and where it stands.
  struct Loop {
    Json json;
    std::string place;
  };

  void nest(const std::vector<Loop>& loops, std::size_t depth, const Scope& scope, std::optional<double> ramp,
            const Make& make) const;

  const JsonFile& file_;
  std::map<std::string, MaterialDescription> materials_;
};

/// The loops of `for_each`, which may be one; none where there is none.
std::vector<Json> loops_of(const Json& object);

/// Warns of an angle whose unit was forgotten.
void mind_degrees(const JsonFile& file, const std::string& variable, const Json& value, const std::string& pointer);

/// The text at `key`, with the words of what `for_each` runs over.
std::string worded(const JsonFile& file, const Json& object, const std::string& pointer, const std::string& key,
                   const Scope& scope);

} // namespace brdfplot::config
