#include "command.hpp"

#include "math/errors.hpp"
#include "math/text_files.hpp"

namespace brdfplot::cli {

std::string footer(const std::string& example) {
  return "Global flags, before or after the command: --threads --quiet --progress --color (see brdfplot --help)\n"
         "\nExample:\n  " +
         example;
}

void require_argument(bool given, const std::string& command, const std::string& what) {
  if (!given) throw InputError(command, "needs " + what + "; see brdfplot " + command + " --help");
}

void print(const std::string& text) { write_text_file("-", text); }

} // namespace brdfplot::cli
