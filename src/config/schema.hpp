/// \file
/// One declaration of what a file may hold: the reader checks JSON against it and the published JSON Schema is written
/// from it, so the two cannot differ.
#pragma once

#include "models/parameters.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace brdfplot::config {

/// An array or object of it starts as Json::array() or Json::object(): a null that is made one by `[]` or `push_back`
/// is left without its value when there is no memory for it, and its destructor then crashes (nlohmann-json 3.11.2).
using Json = nlohmann::ordered_json;

/// A value that does not fit, at a JSON pointer.
struct BadValue {
  std::string pointer;
  std::string what;
};

/// More values in an array, and more keys in an object, are no file that a person or a sensible program wrote. They are
/// refused while they are read, since each key is compared with all before it.
inline constexpr std::size_t most_items = 10000;
inline constexpr std::size_t most_keys = 1000;

class Shape;
using ShapePtr = std::shared_ptr<const Shape>;

struct Field {
  std::string key;
  ShapePtr shape;
  bool required = false;
  std::string doc;
};

/// The shape of a JSON value.
class Shape {
public:
  virtual ~Shape() = default;
  /// \throws BadValue
  virtual void check(const Json& value, const std::string& pointer) const = 0;
  /// As JSON Schema. Named shapes (see `named`) are put into `definitions` and referred to.
  virtual Json schema(Json& definitions) const = 0;
  /// Whether a value is meant for this shape, by its JSON type alone: how `either` chooses.
  virtual bool matches(const Json& value) const = 0;
  /// "a number > 0", "an array": for errors.
  virtual std::string describe() const = 0;
};

ShapePtr number(Bounds bounds = {});
ShapePtr whole_number(int min, int max);
/// Radians as a number, or a string with a unit: "80deg", "1.5rad".
ShapePtr angle();
/// Of up to 10000 characters: longer ones are no titles, and would take long to lay out.
ShapePtr text();
/// A name of files: up to 200 letters, digits, `-`, `_` and, not in front, `.`.
ShapePtr file_stem();
ShapePtr choice(std::vector<std::string> accepted);
ShapePtr boolean();
ShapePtr array(ShapePtr item, std::size_t min = 0, std::size_t max = most_items);
/// Unknown keys are errors, but "$schema" is always accepted at the top of a file (`top`).
ShapePtr object(std::vector<Field> fields, bool top = false);
/// An object with one of the given sets of keys.
ShapePtr object_with_alternatives(std::vector<Field> fields, std::vector<std::vector<std::string>> alternatives);
/// An object with free keys.
ShapePtr map(ShapePtr item, std::string key_doc);
/// An object whose `type` names which of the shapes (all objects) the rest has.
ShapePtr tagged(std::vector<std::pair<std::string, ShapePtr>> types);
/// One of several, told apart by JSON type.
ShapePtr either(std::vector<ShapePtr> shapes);
/// An object that is of one shape with a key, and of another without it.
ShapePtr with_key(std::string key, ShapePtr with, ShapePtr without);
/// A shape by name: published under "$defs", and free to contain itself.
ShapePtr named(std::string name, std::function<ShapePtr()> make);

/// The shape of one parameter of a model.
ShapePtr parameter(const ParameterSpec& spec);
/// Those of a model; one of alternatives is not required by itself.
std::vector<Field> parameter_fields(const ModelSpec& spec);
/// The shape of a model's parameters beside its `type`.
ShapePtr model(const std::vector<ModelSpec>& specs);

/// The whole schema of a kind of file. Its "$id" is a name: nothing is kept at that address.
Json json_schema(const Shape& shape, const std::string& kind);

/// \throws BadValue "found VALUE, accepted: ACCEPTED" unless `good`.
void expect(bool good, const Json& value, const std::string& pointer, const std::string& accepted);

/// `"abc"`, `3`, `an object`: a value as errors show it, on one line.
std::string show(const Json& value);

/// At most `most` bytes of a text, cut between characters.
std::string shortened(const std::string& text, std::size_t most);

/// A pointer as errors show it: on one line, with long keys cut.
std::string show_pointer(const std::string& pointer);

/// A pointer's next step, escaped (RFC 6901).
std::string step(const std::string& pointer, const std::string& key);

} // namespace brdfplot::config
