#include "command.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>
#include <utility>

namespace brdfplot::cli {

namespace {

/// Says what a command needs, where CLI11 would list all as options.
class UsageFormatter final : public CLI::Formatter {
public:
  UsageFormatter(const CLI::Formatter& like, std::string usage) : CLI::Formatter(like), usage_(std::move(usage)) {}
  std::string make_usage(const CLI::App*, std::string) const override { return usage_; }

private:
  std::string usage_;
};

} // namespace

void set_usage(CLI::App& command, const std::vector<std::string>& required) {
  std::string usage;
  for (const std::string& one : required)
    usage +=
        (usage.empty() ? "Usage: brdfplot " : "       brdfplot ") + command.get_name() + " " + one + " [OPTIONS]\n";
  const auto like = std::dynamic_pointer_cast<CLI::Formatter>(command.get_formatter());
  command.formatter(std::make_shared<UsageFormatter>(like ? *like : CLI::Formatter(), usage));
}

CLI::Option* add_materials(CLI::App& command, std::vector<std::string>& materials, const std::string& doc) {
  return command.add_option("-m,--material,materials", materials, doc)->type_name("MATERIAL.json|JSON");
}

CLI::Option* add_material(CLI::App& command, std::string& material, const std::string& doc) {
  return command.add_option("-m,--material,material", material, doc)->type_name("MATERIAL.json|JSON");
}

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

void write_output(const std::string& path, const std::string& text) {
  try {
    write_text_file(path, text);
  } catch (const ClosedPipe&) {
    return;
  }
}

void print(const std::string& text) { write_output("-", text); }

} // namespace brdfplot::cli
