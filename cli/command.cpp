#include "command.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"

#include <cmath>

namespace brdfplot::cli {

std::string footer(const std::string& example) {
  return "Global flags, before or after the command: --threads --quiet --progress --color (see brdfplot --help)\n"
         "\nExample:\n  " +
         example;
}

void require_argument(bool given, const std::string& command, const std::string& what) {
  if (!given) throw InputError(command, "needs " + what + "; see brdfplot " + command + " --help");
}

double read_tolerance(const std::string& text, double fallback) {
  if (text.empty()) return fallback;
  const auto value = parse_number(text);
  if (!value || !(*value > 0) || !std::isfinite(*value))
    throw InputError("--tolerance", "found \"" + echo(text) + "\", accepted: a number > 0");
  return *value;
}

void print(const std::string& text) {
  try {
    write_text_file("-", text);
  } catch (const ClosedPipe&) {
    return; // who reads a part of a table, as head does, has what he wanted
  }
}

} // namespace brdfplot::cli
