/// \file
/// Files for the tests of the reader, and what it says of them.
#pragma once

#include "base/errors.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace brdfplot::test {

/// A folder that lives as long as this.
class TempFolder {
public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "brdfplot-config-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }

  /// Writes a file, folders included, and returns its path.
  std::string write(const std::string& name, std::string_view text) const {
    const auto file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file.string();
  }

  /// The text with this folder's name and the `/` after it taken out.
  std::string relative(std::string text) const {
    const std::string prefix = path_.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) text.erase(at, prefix.size());
    return text;
  }

private:
  std::filesystem::path path_;
};

/// What a call throws, without the folder's name; empty when it throws nothing. Checks exit code and that it is one
/// line.
template <class Call>
std::string error_of(const TempFolder& folder, int exit_code, const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    const std::string what = error.what();
    CHECK(error.exit_code() == exit_code);
    CHECK(what.find_first_of("\n\r") == std::string::npos);
    return folder.relative(what);
  }
  return "";
}

inline bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

} // namespace brdfplot::test
