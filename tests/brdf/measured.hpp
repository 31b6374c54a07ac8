/// \file
/// Files of measured data for tests: as bytes, in a folder of their own.
#pragma once

#include "../materials.hpp"
#include "brdf/measured/merl_table.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace test {

/// A folder that lives as long as this.
class MeasuredFolder {
public:
  MeasuredFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "brdfplot-measured-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~MeasuredFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  MeasuredFolder(const MeasuredFolder&) = delete;
  MeasuredFolder& operator=(const MeasuredFolder&) = delete;

  std::string write(const std::string& name, const std::string& bytes) const {
    const auto file = path_ / name;
    std::ofstream(file, std::ios::binary) << bytes;
    return file.string();
  }
  std::string path() const { return path_.string(); }

private:
  std::filesystem::path path_;
};

/// Appends a number as the machine has it: tests run on little-endian ones.
template <class Number>
void append_raw(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  bytes.append(raw.data(), raw.size());
}

/// A term of measured data.
inline TermDescription measured(const std::string& type, const std::string& file) {
  TermDescription term;
  term.type = type;
  term.values.set("file", file);
  return term;
}

/// What reading throws; checks that it is bad input, in one line.
template <class Call>
std::string bad_input(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    CHECK(error.exit_code() == 2);
    const std::string what = error.what();
    CHECK(what.find('\n') == std::string::npos);
    return what;
  }
  return "";
}

} // namespace test
