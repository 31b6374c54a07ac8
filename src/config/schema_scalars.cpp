#include "config/schema.hpp"

#include "base/number.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace brdfplot::config {

namespace {

Json bounds_schema(const Bounds& bounds) {
  Json out = {{"type", "number"}};
  if (bounds.min > -infinity) out[bounds.open_min ? "exclusiveMinimum" : "minimum"] = bounds.min;
  if (bounds.max < infinity) out[bounds.open_max ? "exclusiveMaximum" : "maximum"] = bounds.max;
  return out;
}

class Number : public Shape {
public:
  explicit Number(Bounds bounds, bool whole = false) : bounds_(bounds), whole_(whole) {}
  void check(const Json& value, const std::string& pointer) const override {
    const bool good = value.is_number() && bounds_.contains(value.get<double>()) &&
                      (!whole_ || value.get<double>() == std::floor(value.get<double>()));
    expect(good, value, pointer, describe());
  }
  Json schema(Json&) const override {
    Json out = bounds_schema(bounds_);
    if (whole_) out["type"] = "integer";
    return out;
  }
  bool matches(const Json& value) const override { return value.is_number(); }
  std::string describe() const override {
    const std::string words = bounds_.describe();
    return whole_ ? "a whole number" + words.substr(words.find("number") + 6) : words;
  }

private:
  Bounds bounds_;
  bool whole_;
};

class Angle : public Shape {
public:
  void check(const Json& value, const std::string& pointer) const override {
    expect(matches(value), value, pointer, describe());
  }
  Json schema(Json&) const override {
    return {{"anyOf", Json::array({{{"type", "number"}}, {{"type", "string"}, {"pattern", pattern_}}})}};
  }
  bool matches(const Json& value) const override {
    if (value.is_number()) return true;
    if (!value.is_string()) return false;
    const auto words = value.get<std::string>();
    if (words.find("deg") == std::string::npos && words.find("°") == std::string::npos &&
        words.find("rad") == std::string::npos)
      return false;
    const auto angle = parse_angle(words);
    return angle && std::isfinite(*angle);
  }
  std::string describe() const override { return "a number in radians, or a string such as \"80deg\" or \"1.5rad\""; }

private:
  static constexpr const char* pattern_ =
      "^[ \\t\\r]*[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?[ \\t\\r]*(deg|°|rad)[ \\t\\r]*$";
};

class Text : public Shape {
public:
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_string(), value, pointer, describe());
    expect(characters(value.get_ref<const std::string&>()) <= most_, value, pointer,
           "a string of up to " + std::to_string(most_) + " characters");
  }
  Json schema(Json&) const override { return {{"type", "string"}, {"maxLength", most_}}; }
  bool matches(const Json& value) const override { return value.is_string(); }
  std::string describe() const override { return "a string"; }

private:
  static std::size_t characters(const std::string& text) {
    const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return static_cast<std::size_t>(std::ranges::count_if(text, starts));
  }
  static constexpr std::size_t most_ = 10000;
};

class FileStem : public Shape {
public:
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_string() && is_stem(value.get<std::string>()), value, pointer, describe());
  }
  Json schema(Json&) const override {
    return {{"type", "string"}, {"maxLength", most_}, {"pattern", "^[A-Za-z0-9_-][A-Za-z0-9_.-]*$"}};
  }
  bool matches(const Json& value) const override { return value.is_string(); }
  std::string describe() const override { return "letters, digits, -, _ and ., at most 200, since it names files"; }

private:
  static constexpr std::size_t most_ = 200;
  static bool is_stem(const std::string& word) {
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
    return !word.empty() && word.size() <= most_ && word.front() != '.' &&
           word.find_first_not_of(plain) == std::string::npos;
  }
};

class Choice : public Shape {
public:
  explicit Choice(std::vector<std::string> accepted) : accepted_(std::move(accepted)) {}
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_string(), value, pointer, describe());
    const auto word = value.get<std::string>();
    if (std::ranges::find(accepted_, word) == accepted_.end())
      throw BadValue{pointer, unknown_name("value", word, accepted_)};
  }
  Json schema(Json&) const override { return {{"enum", accepted_}}; }
  bool matches(const Json& value) const override { return value.is_string(); }
  std::string describe() const override {
    std::string words = "one of ";
    for (const auto& word : accepted_) words += (word == accepted_.front() ? "\"" : ", \"") + word + "\"";
    return words;
  }

private:
  std::vector<std::string> accepted_;
};

class Boolean : public Shape {
public:
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_boolean(), value, pointer, describe());
  }
  Json schema(Json&) const override { return {{"type", "boolean"}}; }
  bool matches(const Json& value) const override { return value.is_boolean(); }
  std::string describe() const override { return "true or false"; }
};

} // namespace

ShapePtr number(Bounds bounds) { return std::make_shared<Number>(bounds); }
ShapePtr whole_number(int min, int max) {
  return std::make_shared<Number>(Bounds{.min = static_cast<double>(min), .max = static_cast<double>(max)}, true);
}
ShapePtr angle() { return std::make_shared<Angle>(); }
ShapePtr text() { return std::make_shared<Text>(); }
ShapePtr file_stem() { return std::make_shared<FileStem>(); }
ShapePtr choice(std::vector<std::string> accepted) { return std::make_shared<Choice>(std::move(accepted)); }
ShapePtr boolean() { return std::make_shared<Boolean>(); }
} // namespace brdfplot::config
