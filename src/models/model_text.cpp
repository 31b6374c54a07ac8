#include "models/model_text.hpp"

#include "base/number.hpp"

namespace brdfplot {

std::string text_of_value(const Value& value) {
  struct Visitor {
    std::string operator()(double x) const { return format_number(x); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const Vec2& v) const { return format_number(v[0]) + ";" + format_number(v[1]); }
    std::string operator()(const Rgb& v) const {
      return format_number(v[0]) + ";" + format_number(v[1]) + ";" + format_number(v[2]);
    }
    std::string operator()(const WeightedChoices& components) const {
      std::string out;
      for (const auto& component : components)
        out += format_number(component.weight) + "*" + text_of_model(component.model) + ";";
      return out;
    }
  };
  return std::visit(Visitor{}, value);
}

std::string text_of_model(const ModelChoice& choice) {
  std::string out = choice.type + "{";
  for (const auto& [key, value] : choice.values.map()) out += key + "=" + text_of_value(value) + ",";
  return out + "}";
}

} // namespace brdfplot
