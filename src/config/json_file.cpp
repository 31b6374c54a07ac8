#include "config/json_file.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/text_files.hpp"
#include "base/threads/interrupt.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace brdfplot::config {

namespace {

/// Deeper files and longer chains of references are refused before they exhaust the stack.
constexpr std::size_t most_levels = 256;

/// References can double what they lead to, level by level; no figure needs as many.
constexpr std::size_t most_references = 10000;

/// What one file may hold, and what its references may make of it.
constexpr std::size_t most_bytes = std::size_t{64} << 20;
constexpr std::size_t most_values = 1000000;

/// LINE:COLUMN of a byte, from 1; columns count characters, and a byte-order mark is none.
std::string line_and_column(const std::string& text, std::size_t byte) {
  std::string_view before = std::string_view(text).substr(0, std::min(byte, text.size()));
  if (before.starts_with("\xEF\xBB\xBF")) before.remove_prefix(3);
  const auto line = std::ranges::count(before, '\n') + 1;
  before.remove_prefix(before.rfind('\n') + 1);
  const auto column =
      std::ranges::count_if(before, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }) + 1;
  return std::to_string(line) + ":" + std::to_string(column);
}

/// What the parser says, without its prefix and of bounded length.
std::string syntax_message(std::string what) {
  const auto colon = what.find(": ", what.find("column"));
  if (colon != std::string::npos) what = what.substr(colon + 2);
  return shortened(what, 200);
}

/// Follows the parser through a text for what the parsed value no longer shows: where an error stands, and keys that
/// are given twice.
class Watch : public nlohmann::json_sax<Json> {
public:
  Watch(const std::string& path, const std::string& text) : path_(path), text_(text) {}

  bool null() override { return item(); }
  bool boolean(bool) override { return item(); }
  bool number_integer(number_integer_t) override { return item(); }
  bool number_unsigned(number_unsigned_t) override { return item(); }
  bool number_float(number_float_t, const string_t&) override { return item(); }
  bool string(string_t&) override { return item(); }
  bool binary(binary_t&) override { return item(); }
  bool start_object(std::size_t) override { return enter(true); }
  bool start_array(std::size_t) override { return enter(false); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool key(string_t& key) override {
    Level& level = levels_.back();
    level.key = key;
    if (!level.keys.insert(key).second)
      throw InputError(path_ + ": " + show_pointer(pointer()), "the key " + show(key) + " stands twice in one object");
    if (level.keys.size() > most_keys) too_many(most_keys, "keys in one object");
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token, const Json::exception& error) override {
    const bool overflow = dynamic_cast<const Json::parse_error*>(&error) == nullptr;
    throw InputError(path_ + ":" + line_and_column(text_, position > 0 ? position - 1 : 0),
                     overflow ? "the number " + shortened(token, 60) + " is too large" : syntax_message(error.what()));
  }

private:
  struct Level {
    bool is_object;
    std::string key;
    std::size_t index = 0;
    std::set<std::string> keys;
  };

  bool item() {
    throw_if_interrupted();
    if (++values_ > most_values) too_many(most_values, "values in one file");
    if (levels_.empty()) return true;
    Level& level = levels_.back();
    if (++level.index > most_items && !level.is_object) too_many(most_items, "items in one array");
    return true;
  }
  [[noreturn]] void too_many(std::size_t most, const std::string& what) const {
    std::string place = pointer();
    place.erase(place.rfind('/') == std::string::npos ? 0 : place.rfind('/'));
    throw InputError(path_ + ": " + (place.empty() ? "/" : show_pointer(place)),
                     "more than " + std::to_string(most) + " " + what + "; accepted: at most as many");
  }
  bool enter(bool is_object) {
    if (levels_.size() == most_levels)
      throw InputError(path_, "values are nested more than " + std::to_string(most_levels) + " deep");
    levels_.push_back({is_object, "", 0, {}});
    return true;
  }
  bool leave() {
    levels_.pop_back();
    return item();
  }
  std::string pointer() const {
    std::string out;
    for (const Level& level : levels_) out = step(out, level.is_object ? level.key : std::to_string(level.index));
    return out;
  }

  const std::string& path_;
  const std::string& text_;
  std::vector<Level> levels_;
  std::size_t values_ = 0;
};

Json parse(const std::string& path, const std::string& text) {
  Watch watch(path, text);
  Json::sax_parse(text, &watch);
  // To nlohmann's lexer it is the end of the text, whatever follows.
  if (const auto zero = text.find('\0'); zero != std::string::npos)
    throw InputError(path + ":" + line_and_column(text, zero), "a zero byte; accepted: nothing behind the value");
  return Json::parse(text);
}

/// One name for a file, however the way to it is written.
std::string canonical(const std::string& path) {
  std::error_code ignored;
  const auto found = std::filesystem::weakly_canonical(path, ignored);
  return found.empty() ? path : found.string();
}

/// The text of a file that the reference at `where` names.
std::string read_referenced(const std::string& file, const std::string& where) {
  try {
    return read_text_file(file, most_bytes);
  } catch (const FileError& error) {
    throw FileError(where, error.what());
  }
}

/// The value at a pointer of a document, or null.
const Json* find(const Json& document, const Json::json_pointer& place) {
  try {
    return &document.at(place);
  } catch (const Json::exception&) {
    return nullptr;
  }
}

constexpr const char* blanks = " \t\r\n";

/// Behind the string that begins at `at`.
std::size_t end_of_string(const std::string& json, std::size_t at) {
  for (++at; json[at] != '"'; ++at)
    if (json[at] == '\\') ++at;
  return at + 1;
}

/// Valid JSON without the member "$schema" of its outermost object, a text; else as it is.
std::string without_schema(const std::string& json) {
  const std::string name = "\"$schema\"";
  int depth = 0;
  for (std::size_t at = 0; at < json.size();) {
    const std::size_t begin = at;
    if (json[at] == '{' || json[at] == '[') ++depth;
    if (json[at] == '}' || json[at] == ']') --depth;
    at = json[at] == '"' ? end_of_string(json, at) : at + 1;
    const std::size_t colon = json.find_first_not_of(blanks, at);
    if (depth != 1 || json.compare(begin, at - begin, name) != 0 || colon == std::string::npos || json[colon] != ':')
      continue;
    const std::size_t end = end_of_string(json, json.find('"', colon));
    const std::size_t after = json.find_first_not_of(blanks, end);
    if (json[after] == ',') return json.substr(0, begin) + json.substr(json.find_first_not_of(blanks, after + 1));
    const std::size_t before = json.find_last_not_of(blanks, begin - 1); // a comma, or the object's beginning
    return json.substr(0, before + (json[before] == ',' ? 0 : 1)) + json.substr(end);
  }
  return json;
}

} // namespace

JsonFile::JsonFile(const std::string& path) : JsonFile(path, read_text_file(path, most_bytes)) {}

JsonFile::JsonFile(const std::string& path, std::string text) : path_(path), text_(std::move(text)) {
  std::vector<std::string> trail;
  const Origin here{"", path, ""};
  root_ = expand(parse(path, text_), "", here, trail);
}

std::string JsonFile::shown() const {
  if (text_.find("\"$ref\"") != std::string::npos) {
    Json root = root_;
    if (root.is_object()) root.erase("$schema");
    return root.dump(2) + "\n";
  }
  return without_schema(text_);
}

Json JsonFile::expand(const Json& value, const std::string& pointer, const Origin& here,
                      std::vector<std::string>& trail) {
  throw_if_interrupted();
  if (++values_ > most_values)
    throw InputError(path_, "more than " + std::to_string(most_values) + " values where references are followed");
  if (value.is_object() && value.contains("$ref")) return follow(value, pointer, here, trail);
  if (value.is_object()) {
    Json out = Json::object();
    for (const auto& [key, item] : value.items()) out[key] = expand(item, step(pointer, key), here, trail);
    return out;
  }
  if (value.is_array()) {
    Json out = Json::array();
    for (std::size_t k = 0; k < value.size(); ++k)
      out.push_back(expand(value[k], step(pointer, std::to_string(k)), here, trail));
    return out;
  }
  return value;
}

Json JsonFile::follow(const Json& value, const std::string& pointer, const Origin& here,
                      std::vector<std::string>& trail) {
  const std::string where = place(here, pointer);
  const Json& target = value["$ref"];
  if (value.size() != 1 || !target.is_string())
    throw InputError(where, "a reference is {\"$ref\": \"FILE#/pointer\"} and nothing else");
  const auto words = target.get<std::string>();
  const auto hash = words.find('#');
  const std::string name = words.substr(0, hash);
  const std::string inside = hash == std::string::npos ? "" : words.substr(hash + 1);
  const std::string file = name.empty() ? here.file : (std::filesystem::path(here.file).parent_path() / name).string();
  Json::json_pointer steps;
  try {
    steps = Json::json_pointer(inside);
  } catch (const Json::exception&) {
    throw InputError(where, show(inside) + " is not a JSON pointer; accepted: \"\" or \"/key/...\"");
  }
  const std::string whole = canonical(file) + "#" + inside;
  if (std::ranges::find(trail, whole) != trail.end())
    throw InputError(where, "the reference " + show(target) + " leads back to itself");
  if (trail.size() == most_levels)
    throw InputError(where, "more than " + std::to_string(most_levels) + " references lead to each other");
  if (origins_.size() == most_references)
    throw InputError(where, "there are more than " + std::to_string(most_references) + " references");
  const Json& document = referenced(file, where);
  const Json* found = find(document, steps);
  if (found == nullptr) throw InputError(where, "there is nothing at " + show(inside) + " in " + echo(file, 300));
  const Origin there{pointer, file, inside};
  origins_.push_back(there);
  trail.push_back(whole);
  Json result = expand(*found, pointer, there, trail);
  trail.pop_back();
  return result;
}

const Json& JsonFile::referenced(const std::string& file, const std::string& where) {
  const auto known = documents_.find(file);
  if (known != documents_.end()) return known->second;
  Json document = parse(file, read_referenced(file, where));
  // What names the schema of a file says nothing of the value that the file holds.
  if (document.is_object()) document.erase("$schema");
  return documents_.emplace(file, std::move(document)).first->second;
}

std::string JsonFile::place(const Origin& origin, const std::string& pointer) {
  const std::string at = origin.pointer + pointer.substr(origin.prefix.size());
  return origin.file + ": " + (at.empty() ? "/" : show_pointer(at));
}

JsonFile::Origin JsonFile::origin(const std::string& pointer) const {
  const Origin* best = nullptr;
  for (const auto& candidate : origins_) {
    const bool inside = pointer.starts_with(candidate.prefix) &&
                        (pointer.size() == candidate.prefix.size() || pointer[candidate.prefix.size()] == '/');
    if (inside && (best == nullptr || candidate.prefix.size() >= best->prefix.size())) best = &candidate;
  }
  return best == nullptr ? Origin{"", path_, ""} : *best;
}

std::string JsonFile::where(const std::string& pointer) const { return place(origin(pointer), pointer); }

std::string JsonFile::file(const std::string& pointer) const { return origin(pointer).file; }

void JsonFile::fail(const std::string& pointer, const std::string& what) const {
  throw InputError(where(pointer), one_line(what));
}

void JsonFile::check(const Shape& shape) const {
  try {
    shape.check(root_, "");
  } catch (const BadValue& bad) {
    fail(bad.pointer, bad.what);
  }
}

} // namespace brdfplot::config
