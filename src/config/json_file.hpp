/// \file
/// A JSON file with its references followed, which still knows where every value stands.
#pragma once

#include "config/schema.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace brdfplot::config {

class JsonFile {
public:
  /// Reads `path` and puts, for every {"$ref": "FILE#/pointer"}, the value that it names (relative to the file it
  /// stands in; no FILE: the same file). \throws FileError, InputError (syntax, duplicate keys, a reference that leads
  /// nowhere or to itself).
  explicit JsonFile(const std::string& path);
  /// The same of a text that is no file: errors say `path`, and references are relative to its folder.
  JsonFile(const std::string& path, std::string text);

  const Json& root() const { return root_; }
  const std::string& path() const { return path_; }
  /// The text as readers are shown it: with what references say in their place, and without "$schema", which tells the
  /// editor of this file where a schema is.
  std::string shown() const;

  /// `FILE: /pointer`, in the file in which the value at `pointer` of root() was written.
  std::string where(const std::string& pointer) const;

  /// The file in which the value at `pointer` of root() was written: what paths in it are relative to.
  std::string file(const std::string& pointer) const;

  /// Checks against a shape, with errors at where() the value stands.
  void check(const Shape& shape) const;

  [[noreturn]] void fail(const std::string& pointer, const std::string& what) const;

private:
  struct Origin {
    std::string prefix, file, pointer;
  };
  Json expand(const Json& value, const std::string& pointer, const Origin& here, std::vector<std::string>& trail);
  Json follow(const Json& value, const std::string& pointer, const Origin& here, std::vector<std::string>& trail);
  /// The parsed text of a file that the reference at `where` names.
  const Json& referenced(const std::string& file, const std::string& where);
  static std::string place(const Origin& origin, const std::string& pointer);
  Origin origin(const std::string& pointer) const;

  std::string path_, text_;
  Json root_;
  std::vector<Origin> origins_; ///< longest matching prefix counts
  std::map<std::string, Json> documents_;
  std::size_t values_ = 0; ///< expanded so far
};

} // namespace brdfplot::config
