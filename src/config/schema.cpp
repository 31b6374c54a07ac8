#include "config/schema.hpp"

#include "base/threads/interrupt.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <mutex>

namespace brdfplot::config {

namespace {

/// "A value anywhere may be {"$ref": ...}": editors check a file as it is written, before references are followed.
Json or_reference(Json schema) {
  return {{"anyOf", Json::array({std::move(schema), {{"$ref", "#/$defs/reference"}}})}};
}

class Array : public Shape {
public:
  Array(ShapePtr item, std::size_t min, std::size_t max) : item_(std::move(item)), min_(min), max_(max) {}
  void check(const Json& value, const std::string& pointer) const override {
    expect(value.is_array(), value, pointer, describe());
    if (value.size() < min_ || value.size() > max_)
      throw BadValue{pointer, "found " + std::to_string(value.size()) + " items, accepted: " + describe()};
    for (std::size_t k = 0; k < value.size(); ++k) {
      throw_if_interrupted();
      item_->check(value[k], step(pointer, std::to_string(k)));
    }
  }
  Json schema(Json& definitions) const override {
    Json out = {{"type", "array"}, {"items", or_reference(item_->schema(definitions))}};
    if (min_ > 0) out["minItems"] = min_;
    out["maxItems"] = max_;
    return out;
  }
  bool matches(const Json& value) const override { return value.is_array(); }
  std::string describe() const override {
    const std::string count = min_ == max_        ? std::to_string(min_) + " items"
                              : max_ < most_items ? std::to_string(min_) + " to " + std::to_string(max_) + " items"
                              : min_ > 0          ? "at least " + std::to_string(min_) + " item" + (min_ > 1 ? "s" : "")
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
      if (top_ && key == "$schema") {
        text()->check(item, step(pointer, key));
        continue;
      }
      const auto field = std::ranges::find(fields_, key, &Field::key);
      if (field == fields_.end()) throw BadValue{step(pointer, key), unknown_name("key", key, keys())};
      field->shape->check(item, step(pointer, key));
    }
    for (const auto& field : fields_)
      if (field.required && !value.contains(field.key))
        throw BadValue{pointer,
                       "\"" + field.key + "\" is missing: " + field.doc + "; accepted: " + field.shape->describe()};
    check_alternatives(value, pointer);
  }
  Json schema(Json& definitions) const override {
    Json properties = Json::object();
    Json required = Json::array();
    if (top_) properties["$schema"] = {{"type", "string"}};
    for (const auto& field : fields_) {
      properties[field.key] = or_reference(field.shape->schema(definitions));
      if (!field.doc.empty()) properties[field.key]["description"] = field.doc;
      if (field.required) required.push_back(field.key);
    }
    Json out = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!required.empty()) out["required"] = required;
    Json groups = Json::array();
    for (const auto& group : alternatives_) groups.push_back(alternative_schema(group));
    if (!groups.empty()) out["oneOf"] = std::move(groups);
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
  /// The group whole, and nothing of the others.
  Json alternative_schema(const std::vector<std::string>& group) const {
    Json others = Json::array();
    for (const auto& other : alternatives_)
      for (const auto& key : other)
        if (std::ranges::find(group, key) == group.end()) others.push_back({{"required", Json::array({key})}});
    return {{"required", group}, {"not", {{"anyOf", others}}}};
  }
  /// One of the groups, whole, and nothing else of the others; complete() says the same of models, but this is also for
  /// what is no model.
  void check_alternatives(const Json& value, const std::string& pointer) const {
    if (alternatives_.empty()) return;
    std::vector<std::string> known, present;
    std::string accepted;
    for (const auto& group : alternatives_) {
      accepted += (accepted.empty() ? "either " : ", or ") + joined(group, " with ");
      for (const auto& key : group)
        if (std::ranges::find(known, key) == known.end()) known.push_back(key);
    }
    for (const auto& key : known)
      if (value.contains(key)) present.push_back(key);
    if (given_alternative(alternatives_, present) != nullptr) return;
    const bool within_one = std::ranges::any_of(alternatives_, [&](const auto& group) {
      return std::ranges::all_of(present,
                                 [&](const auto& key) { return std::ranges::find(group, key) != group.end(); });
    });
    const std::string found =
        present.empty() ? "none of " + joined(known, ", ") : joined(present, " with ") + (within_one ? " alone" : "");
    throw BadValue{pointer, "found " + found + "; accepted: " + accepted};
  }
  static std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string out;
    for (const auto& word : words) out += (out.empty() ? "" : separator) + word;
    return out;
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
    return {{"type", "object"},
            {"additionalProperties", or_reference(item_->schema(definitions))},
            {"description", key_doc_}};
  }
  bool matches(const Json& value) const override { return value.is_object(); }
  std::string describe() const override { return "an object of " + key_doc_; }

private:
  ShapePtr item_;
  std::string key_doc_;
};

/// An object that refuses some keys with a reason.
class Refusing : public Shape {
public:
  Refusing(ShapePtr shape, std::vector<std::pair<std::string, std::string>> refused)
      : shape_(std::move(shape)), refused_(std::move(refused)) {}
  void check(const Json& value, const std::string& pointer) const override {
    for (const auto& [key, why] : refused_)
      if (value.is_object() && value.contains(key)) throw BadValue{step(pointer, key), why};
    shape_->check(value, pointer);
  }
  Json schema(Json& definitions) const override { return shape_->schema(definitions); }
  bool matches(const Json& value) const override { return shape_->matches(value); }
  std::string describe() const override { return shape_->describe(); }

private:
  ShapePtr shape_;
  std::vector<std::pair<std::string, std::string>> refused_;
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
      Json type = {{"const", name}};
      const Json& properties = branch["properties"];
      if (properties.contains("type") && properties["type"].contains("description")) {
        // Editors show it at the word, and while one is chosen.
        const Json description = properties["type"]["description"];
        type["description"] = description;
        branch["description"] = description;
      }
      branch["properties"]["type"] = type;
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
  std::string names_text() const { return choice(names())->describe(); }
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

class WithKey : public Shape {
public:
  WithKey(std::string key, ShapePtr with, ShapePtr without)
      : key_(std::move(key)), with_(std::move(with)), without_(std::move(without)) {}
  void check(const Json& value, const std::string& pointer) const override {
    (value.is_object() && value.contains(key_) ? with_ : without_)->check(value, pointer);
  }
  Json schema(Json& definitions) const override {
    return {{"if", {{"type", "object"}, {"required", Json::array({key_})}}},
            {"then", with_->schema(definitions)},
            {"else", without_->schema(definitions)}};
  }
  bool matches(const Json& value) const override { return value.is_object(); }
  std::string describe() const override { return without_->describe(); }

private:
  std::string key_;
  ShapePtr with_, without_;
};

class Named : public Shape {
public:
  Named(std::string name, std::function<ShapePtr()> make) : name_(std::move(name)), make_(std::move(make)) {}
  void check(const Json& value, const std::string& pointer) const override { made().check(value, pointer); }
  Json schema(Json& definitions) const override {
    if (!definitions.contains(name_)) {
      definitions[name_] = true; // stands in while the definition is being written
      Json definition = made().schema(definitions);
      definitions[name_] = std::move(definition);
    }
    return {{"$ref", "#/$defs/" + name_}};
  }
  bool matches(const Json& value) const override { return made().matches(value); }
  std::string describe() const override { return "a " + name_; }

private:
  /// Made when it is first needed, since it may contain itself, and then once: it may be that of many values.
  const Shape& made() const {
    // Not std::call_once: what is thrown for want of memory could not pass through the C library's pthread_once.
    const std::lock_guard lock(mutex_);
    if (!made_) made_ = make_();
    return *made_;
  }

  std::string name_;
  std::function<ShapePtr()> make_;
  mutable std::mutex mutex_;
  mutable ShapePtr made_;
};

} // namespace

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

ShapePtr with_key(std::string key, ShapePtr with, ShapePtr without) {
  return std::make_shared<WithKey>(std::move(key), std::move(with), std::move(without));
}

ShapePtr parameter(const ParameterSpec& spec) {
  switch (spec.kind) {
  case ParameterKind::number: return number(spec.bounds);
  case ParameterKind::number_or_rgb: return either({number(spec.bounds), array(number(spec.bounds), 3, 3)});
  case ParameterKind::vec2: return array(number(spec.bounds), 2, 2);
  case ParameterKind::vec3: return array(number(spec.bounds), 3, 3);
  case ParameterKind::boolean: return boolean();
  case ParameterKind::formula:
  case ParameterKind::text: return text();
  case ParameterKind::components:
    return array(named("component",
                       [spec] {
                         return object({{"weight", number(spec.bounds), true, "share of the sum"},
                                        {"distribution", model(spec.models()), true, "what has this share"}});
                       }),
                 1, 64);
  case ParameterKind::choice: break;
  }
  return choice(spec.choices);
}

std::vector<Field> parameter_fields(const ModelSpec& spec) {
  std::vector<Field> fields;
  for (const ParameterSpec& item : spec.parameters) {
    const bool alternative = std::ranges::any_of(
        spec.alternatives, [&](const auto& group) { return std::ranges::find(group, item.key) != group.end(); });
    fields.push_back({item.key, parameter(item), !item.fallback && !alternative, item.doc});
  }
  return fields;
}

ShapePtr model(const std::vector<ModelSpec>& specs) {
  std::vector<std::pair<std::string, ShapePtr>> types;
  for (const auto& spec : specs) {
    std::vector<Field> fields = {{"type", text(), true, spec.doc + " (" + spec.source + ")"}};
    for (Field& field : parameter_fields(spec)) fields.push_back(std::move(field));
    ShapePtr shape = object_with_alternatives(std::move(fields), spec.alternatives);
    if (!spec.refused.empty()) shape = std::make_shared<Refusing>(std::move(shape), spec.refused);
    types.emplace_back(spec.type, std::move(shape));
  }
  return tagged(std::move(types));
}

Json json_schema(const Shape& shape, const std::string& kind) {
  Json definitions = Json::object();
  definitions["reference"] = {{"type", "object"},
                              {"properties", {{"$ref", {{"type", "string"}, {"pattern", "^[^#]*(#(/.*)?)?$"}}}}},
                              {"required", Json::array({"$ref"})},
                              {"additionalProperties", false},
                              {"description", "stands for the value at FILE#/json/pointer, relative to this file"}};
  Json body = shape.schema(definitions);
  Json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"$id", "https://brdfplot.example/schemas/" + kind + ".json"},
              {"title", "brdfplot " + kind}};
  for (const auto& [key, value] : body.items()) out[key] = value;
  out["$defs"] = definitions;
  return out;
}

} // namespace brdfplot::config
