#include "config/json_file.hpp"

#include "math/errors.hpp"
#include "math/text_files.hpp"

#include <algorithm>
#include <filesystem>

namespace brdfplot::config {

namespace {

/// LINE:COLUMN of a byte, from 1.
std::string line_and_column(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::ranges::count(before, '\n') + 1;
  const auto start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string::npos ? 0 : start + 1) + 1;
  return std::to_string(line) + ":" + std::to_string(column);
}

/// What the parser says, without its prefix and with the place taken off.
std::string syntax_message(std::string what) {
  const auto colon = what.find(": ", what.find("column"));
  if (colon != std::string::npos) what = what.substr(colon + 2);
  std::ranges::replace(what, '\n', ' ');
  return what;
}

Json parse(const std::string& path, const std::string& text) {
  std::vector<std::vector<std::string>> keys;
  std::string duplicate;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key) {
      const auto key = parsed.get<std::string>();
      if (std::ranges::find(keys.back(), key) != keys.back().end()) duplicate = key;
      keys.back().push_back(key);
    }
    return true;
  };
  try {
    Json value = Json::parse(text, watch);
    if (!duplicate.empty()) throw InputError(path, "the key \"" + duplicate + "\" stands twice in one object");
    return value;
  } catch (const Json::parse_error& error) {
    throw InputError(path + ":" + line_and_column(text, error.byte > 0 ? error.byte - 1 : 0),
                     syntax_message(error.what()));
  }
}

} // namespace

JsonFile::JsonFile(const std::string& path) : path_(path), text_(read_text_file(path)) {
  std::vector<std::string> trail;
  const Origin here{"", path, ""};
  root_ = expand(parse(path, text_), "", here, trail);
}

Json JsonFile::expand(const Json& value, const std::string& pointer, const Origin& here,
                      std::vector<std::string>& trail) {
  const auto at = [&] { return here.pointer + pointer.substr(here.prefix.size()); };
  if (value.is_object() && value.contains("$ref")) {
    const Json& target = value["$ref"];
    if (value.size() != 1 || !target.is_string())
      throw InputError(here.file + ": " + at(), "a reference is {\"$ref\": \"FILE#/pointer\"} and nothing else");
    const auto words = target.get<std::string>();
    const auto hash = words.find('#');
    const std::string name = words.substr(0, hash);
    const std::string inside = hash == std::string::npos ? "" : words.substr(hash + 1);
    const std::string file =
        name.empty() ? here.file : (std::filesystem::path(here.file).parent_path() / name).string();
    const std::string whole = file + "#" + inside;
    if (std::ranges::find(trail, whole) != trail.end())
      throw InputError(here.file + ": " + at(), "the reference \"" + words + "\" leads back to itself");
    const Json document = parse(file, read_text_file(file));
    Json::json_pointer place;
    try {
      place = Json::json_pointer(inside);
    } catch (const Json::exception&) {
      throw InputError(here.file + ": " + at(),
                       "\"" + inside + "\" is not a JSON pointer; accepted: \"\" or \"/key/...\"");
    }
    if (!document.contains(place))
      throw InputError(here.file + ": " + at(), "there is nothing at \"" + inside + "\" in " + file);
    const Origin there{pointer, file, inside};
    origins_.push_back(there);
    trail.push_back(whole);
    Json result = expand(document[place], pointer, there, trail);
    trail.pop_back();
    return result;
  }
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

std::string JsonFile::where(const std::string& pointer) const {
  const Origin* best = nullptr;
  for (const auto& origin : origins_) {
    const bool inside = pointer.starts_with(origin.prefix) &&
                        (pointer.size() == origin.prefix.size() || pointer[origin.prefix.size()] == '/');
    if (inside && (best == nullptr || origin.prefix.size() >= best->prefix.size())) best = &origin;
  }
  std::string at = best == nullptr ? pointer : best->pointer + pointer.substr(best->prefix.size());
  if (at.empty()) at = "/";
  return (best == nullptr ? path_ : best->file) + ": " + at;
}

void JsonFile::fail(const std::string& pointer, const std::string& what) const {
  throw InputError(where(pointer), what);
}

void JsonFile::check(const Shape& shape) const {
  try {
    shape.check(root_, "");
  } catch (const BadValue& bad) {
    fail(bad.pointer, bad.what);
  }
}

} // namespace brdfplot::config
