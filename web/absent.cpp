/// \file
/// What the live page has not: threads, files, signals, and formulas, whose library Debian has for its own machine
/// only. Who asks for a file or a formula is told.

#include "base/binary_file.hpp"
#include "base/errors.hpp"
#include "base/memory.hpp"
#include "base/text_files.hpp"
#include "base/threads/interrupt.hpp"
#include "base/threads/parallel.hpp"
#include "math/formula.hpp"

#include <filesystem>

namespace brdfplot {

int hardware_threads() { return 1; }

void run_on_threads(int, const std::function<void()>& work) { work(); }

void parallel_for(std::size_t n, int, const std::function<void(std::size_t)>& body) {
  for (std::size_t k = 0; k < n; ++k) body(k);
}

void throw_if_interrupted() {}

void require_memory(double, const std::string&) {}

std::string read_text_file(const std::string& path, std::size_t) {
  throw FileError(path, "the live page reads no files");
}

InputFile::InputFile(const std::string& path) { throw FileError(path, "the live page reads no files"); }
InputFile::~InputFile() = default;
std::size_t InputFile::read(char*, std::size_t) { return 0; }
void InputFile::seek(std::uint64_t) {}
BinaryFile::BinaryFile(const std::string& path) : path_(path), file_(path) {}
void BinaryFile::read(std::span<std::byte>, const std::string&) {}
void BinaryFile::seek(std::uint64_t) {}
void BinaryFile::fail(const std::string& what) const { throw InputError(path_, what); }

namespace {
constexpr const char* no_formulas = "the live page computes no formulas; brdfplot does";
}

std::optional<FormulaProblem> Formula::problem(const std::string&, const std::vector<std::string>&) {
  return FormulaProblem{"", no_formulas};
}
Formula::Formula(std::string text, std::vector<std::string>) : text_(std::move(text)) {
  throw InputError("formula", no_formulas);
}
double Formula::operator()(std::span<const double>) const { throw InputError("formula", no_formulas); }
std::vector<std::string> names_in_formulas() { return {}; }

} // namespace brdfplot

// The parts of a path, of which libc++ for WASI has the declarations.
namespace std::filesystem {

path::__string_view path::__filename() const {
  const __string_view all = __pn_;
  return all.substr(all.rfind('/') + 1);
}

path::__string_view path::__stem() const {
  const __string_view name = __filename();
  const auto dot = name.rfind('.');
  return dot == 0 ? name : name.substr(0, dot);
}

path::__string_view path::__parent_path() const {
  const __string_view all = __pn_;
  const auto slash = all.rfind('/');
  return slash == __string_view::npos ? __string_view() : all.substr(0, slash == 0 ? 1 : slash);
}

path::__string_view path::__root_directory() const {
  const __string_view all = __pn_;
  return all.substr(0, all.starts_with('/') ? 1 : 0);
}

} // namespace std::filesystem
