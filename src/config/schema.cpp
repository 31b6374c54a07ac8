#include "config/schema.hpp"

#include "math/number.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace brdfplot::config {

namespace {

void expect(bool good, const Json& value, const std::string& pointer, const std::string& accepted) {
  if (!good) throw BadValue{pointer, "found " + show(value) + ", accepted: " + accepted};
}

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
    expect(value.is_number() && (!whole_ || value.is_number_integer()) && bounds_.contains(value.get<double>()), value,
           pointer, describe());
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
    expect(value.is_number() || (value.is_string() && parse_angle(value.get<std::string>())), value, pointer,
           describe());
  }
  Json schema(Json&) const override {
    return {{"anyOf", Json::array({{{"type", "number"}},
                                   {{"type", "string"},
                                    {"pattern", "^\\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?\\s*(deg|rad)\\s*$"}}})}};
  }
  bool matches(const Json& value) const override {
    return value.is_number() || (value.is_string() && parse_angle(value.get<std::string>()));
  }
  std::string describe() const override { return "a number in radians, or a string such as \"80deg\" or \"1.5rad\""; }
};

class Text : public Shape {
public:
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_string(), value, pointer, describe());
  }
  Json schema(Json&) const override { return {{"type", "string"}}; }
  bool matches(const Json& value) const override { return value.is_string(); }
  std::string describe() const override { return "a string"; }
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

class Array : public Shape {
public:
  Array(ShapePtr item, std::size_t min, std::size_t max) : item_(std::move(item)), min_(min), max_(max) {}
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_array(), value, pointer, describe());
    if (value.size() < min_ || value.size() > max_)
      throw BadValue{pointer, "found " + std::to_string(value.size()) + " items, accepted: " + describe()};
    for (std::size_t k = 0; k < value.size(); ++k) item_->check(value[k], step(pointer, std::to_string(k)));
  }
  Json schema(Json& definitions) const override {
    Json out = {{"type", "array"}, {"items", item_->schema(definitions)}};
    if (min_ > 0) out["minItems"] = min_;
    if (max_ < 1000000) out["maxItems"] = max_;
    return out;
  }
  bool matches(const Json& value) const override { return value.is_array(); }
  std::string describe() const override {
    const std::string count = min_ == max_     ? std::to_string(min_) + " items"
                              : max_ < 1000000 ? std::to_string(min_) + " to " + std::to_string(max_) + " items"
                              : min_ > 0       ? "at least " + std::to_string(min_) + " item" + (min_ > 1 ? "s" : "")
                                               : "items";
    return "an array of " + count + ", each " + item_->describe();
  }

private:
  ShapePtr item_;
  std::size_t min_, max_;
};

class Object : public Shape {
public:
  Object(std::vector<Field> fields, std::vector<std::vector<std::string>> alternatives, bool top)
      : fields_(std::move(fields)), alternatives_(std::move(alternatives)), top_(top) {}

  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_object(), value, pointer, describe());
    for (const auto& [key, item] : value.items()) {
      if (top_ && key == "$schema") continue;
      const auto field = std::ranges::find(fields_, key, &Field::key);
      if (field == fields_.end()) throw BadValue{step(pointer, key), unknown_name("key", key, keys())};
      field->shape->check(item, step(pointer, key));
    }
    for (const auto& field : fields_)
      if (field.required && !value.contains(field.key))
        throw BadValue{pointer, "\"" + field.key + "\" is missing: " + field.doc};
    check_alternatives(value, pointer);
  }
  Json schema(Json& definitions) const override {
    Json properties = Json::object();
    Json required = Json::array();
    if (top_) properties["$schema"] = {{"type", "string"}};
    for (const auto& field : fields_) {
      Json item = field.shape->schema(definitions);
      if (!field.doc.empty()) item["description"] = field.doc;
      // "A value anywhere may be {"$ref": ...}": editors check the file as it is written, before references are
      // followed.
      properties[field.key] = {{"anyOf", Json::array({item, {{"$ref", "#/$defs/reference"}}})}};
      if (!field.doc.empty()) properties[field.key]["description"] = field.doc;
      if (field.required) required.push_back(field.key);
    }
    Json out = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) out["required"] = required;
    for (const auto& group : alternatives_) out["oneOf"].push_back({{"required", group}});
    return out;
  }
  bool matches(const Json& value) const override { return value.is_object(); }
  std::string describe() const override {
    std::string words = "an object with";
    for (const auto& field : fields_) words += (field.key == fields_.front().key ? " " : ", ") + field.key;
    return words;
  }

private:
  std::vector<std::string> keys() const {
    std::vector<std::string> out;
    for (const auto& field : fields_) out.push_back(field.key);
    return out;
  }
  /// Exactly one of the groups; complete() says the same of models, but this is for objects that are no model.
  void check_alternatives(const Json& value, const std::string& pointer) const {
    if (alternatives_.empty()) return;
    std::string texts;
    int present = 0;
    for (const auto& group : alternatives_) {
      std::string words;
      for (const auto& key : group) words += (words.empty() ? "" : " with ") + key;
      texts += (texts.empty() ? "either " : ", or ") + words;
      if (std::ranges::any_of(group, [&](const auto& key) { return value.contains(key); })) ++present;
      const bool partly = std::ranges::any_of(group, [&](const auto& key) { return value.contains(key); });
      if (partly && !std::ranges::all_of(group, [&](const auto& key) { return value.contains(key); })) present = 2;
    }
    if (present != 1) throw BadValue{pointer, "accepted: " + texts};
  }
  std::vector<Field> fields_;
  std::vector<std::vector<std::string>> alternatives_;
  bool top_;
};

class Map : public Shape {
public:
  Map(ShapePtr item, std::string key_doc) : item_(std::move(item)), key_doc_(std::move(key_doc)) {}
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_object(), value, pointer, describe());
    for (const auto& [key, item] : value.items()) item_->check(item, step(pointer, key));
  }
  Json schema(Json& definitions) const override {
    return {{"type", "object"}, {"additionalProperties", item_->schema(definitions)}, {"description", key_doc_}};
  }
  bool matches(const Json& value) const override { return value.is_object(); }
  std::string describe() const override { return "an object of " + key_doc_; }

private:
  ShapePtr item_;
  std::string key_doc_;
};

class Tagged : public Shape {
public:
  explicit Tagged(std::vector<std::pair<std::string, ShapePtr>> types) : types_(std::move(types)) {}
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_object(), value, pointer, describe());
    if (!value.contains("type")) throw BadValue{pointer, "\"type\" is missing; accepted: " + names_text()};
    const Json& type = value["type"];
    expect(type.is_string(), type, step(pointer, "type"), names_text());
    const auto word = type.get<std::string>();
    const auto found = std::ranges::find(types_, word, &std::pair<std::string, ShapePtr>::first);
    if (found == types_.end()) throw BadValue{step(pointer, "type"), unknown_name("type", word, names())};
    found->second->check(value, pointer);
  }
  Json schema(Json& definitions) const override {
    Json branches = Json::array();
    for (const auto& [name, shape] : types_) {
      Json branch = shape->schema(definitions);
      branch["properties"]["type"] = {{"const", name}};
      branch["title"] = name;
      branches.push_back(branch);
    }
    return {{"oneOf", branches}};
  }
  bool matches(const Json& value) const override { return value.is_object(); }
  std::string describe() const override { return "an object with \"type\": " + names_text(); }

private:
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& type : types_) out.push_back(type.first);
    return out;
  }
  std::string names_text() const { return Choice(names()).describe(); }
  std::vector<std::pair<std::string, ShapePtr>> types_;
};

class Either : public Shape {
public:
  explicit Either(std::vector<ShapePtr> shapes) : shapes_(std::move(shapes)) {}
  void check(const Json& value, const std::string& pointer) const override {
    const auto found = std::ranges::find_if(shapes_, [&](const auto& shape) { return shape->matches(value); });
    expect(found != shapes_.end(), value, pointer, describe());
    (*found)->check(value, pointer);
  }
  Json schema(Json& definitions) const override {
    Json branches = Json::array();
    for (const auto& shape : shapes_) branches.push_back(shape->schema(definitions));
    return {{"anyOf", branches}};
  }
  bool matches(const Json& value) const override {
    return std::ranges::any_of(shapes_, [&](const auto& shape) { return shape->matches(value); });
  }
  std::string describe() const override {
    std::string words;
    for (const auto& shape : shapes_) words += (words.empty() ? "" : ", or ") + shape->describe();
    return words;
  }

private:
  std::vector<ShapePtr> shapes_;
};

class Named : public Shape {
public:
  Named(std::string name, std::function<ShapePtr()> make) : name_(std::move(name)), make_(std::move(make)) {}
  void check(const Json& value, const std::string& pointer) const override { make_()->check(value, pointer); }
  Json schema(Json& definitions) const override {
    if (!definitions.contains(name_)) {
      definitions[name_] = true; // stands in while the definition is being written
      Json definition = make_()->schema(definitions);
      definitions[name_] = std::move(definition);
    }
    return {{"$ref", "#/$defs/" + name_}};
  }
  bool matches(const Json& value) const override { return make_()->matches(value); }
  std::string describe() const override { return "a " + name_; }

private:
  std::string name_;
  std::function<ShapePtr()> make_;
};

ShapePtr parameter(const ParameterSpec& spec) {
  switch (spec.kind) {
  case ParameterKind::number: return number(spec.bounds);
  case ParameterKind::number_or_rgb: return either({number(spec.bounds), array(number(spec.bounds), 3, 3)});
  case ParameterKind::vec2: return array(number(spec.bounds), 2, 2);
  case ParameterKind::choice: break;
  }
  return choice(spec.choices);
}

} // namespace

ShapePtr number(Bounds bounds) { return std::make_shared<Number>(bounds); }
ShapePtr whole_number(int min, int max) {
  return std::make_shared<Number>(Bounds{.min = static_cast<double>(min), .max = static_cast<double>(max)}, true);
}
ShapePtr angle() { return std::make_shared<Angle>(); }
ShapePtr text() { return std::make_shared<Text>(); }
ShapePtr choice(std::vector<std::string> accepted) { return std::make_shared<Choice>(std::move(accepted)); }
ShapePtr boolean() { return std::make_shared<Boolean>(); }
ShapePtr array(ShapePtr item, std::size_t min, std::size_t max) {
  return std::make_shared<Array>(std::move(item), min, max);
}
ShapePtr object(std::vector<Field> fields, bool top) {
  return std::make_shared<Object>(std::move(fields), std::vector<std::vector<std::string>>{}, top);
}
ShapePtr object_with_alternatives(std::vector<Field> fields, std::vector<std::vector<std::string>> alternatives) {
  return std::make_shared<Object>(std::move(fields), std::move(alternatives), false);
}
ShapePtr map(ShapePtr item, std::string key_doc) { return std::make_shared<Map>(std::move(item), std::move(key_doc)); }
ShapePtr tagged(std::vector<std::pair<std::string, ShapePtr>> types) {
  return std::make_shared<Tagged>(std::move(types));
}
ShapePtr either(std::vector<ShapePtr> shapes) { return std::make_shared<Either>(std::move(shapes)); }
ShapePtr named(std::string name, std::function<ShapePtr()> make) {
  return std::make_shared<Named>(std::move(name), std::move(make));
}

ShapePtr model(const std::vector<ModelSpec>& specs) {
  std::vector<std::pair<std::string, ShapePtr>> types;
  for (const auto& spec : specs) {
    std::vector<Field> fields = {{"type", text(), true, spec.doc + " (" + spec.source + ")"}};
    for (const auto& item : spec.parameters) {
      const bool alternative = std::ranges::any_of(
          spec.alternatives, [&](const auto& group) { return std::ranges::find(group, item.key) != group.end(); });
      fields.push_back({item.key, parameter(item), !item.fallback && !alternative, item.doc});
    }
    types.emplace_back(spec.type, object_with_alternatives(std::move(fields), spec.alternatives));
  }
  return tagged(std::move(types));
}

Json json_schema(const Shape& shape, const std::string& title) {
  Json definitions = Json::object();
  definitions["reference"] = {{"type", "object"},
                              {"properties", {{"$ref", {{"type", "string"}, {"pattern", "^[^#]*(#(/.*)?)?$"}}}}},
                              {"required", Json::array({"$ref"})},
                              {"additionalProperties", false},
                              {"description", "stands for the value at FILE#/json/pointer, relative to this file"}};
  Json body = shape.schema(definitions);
  Json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  for (const auto& [key, value] : body.items()) out[key] = value;
  out["$defs"] = definitions;
  return out;
}

std::string show(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  std::string text = value.dump();
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

std::string step(const std::string& pointer, const std::string& key) {
  std::string out = pointer + "/";
  for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

} // namespace brdfplot::config
