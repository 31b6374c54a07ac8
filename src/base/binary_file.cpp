#include "base/binary_file.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"

#include <filesystem>
#include <system_error>

namespace brdfplot {

namespace {

/// Opening a pipe would wait for who writes to it.
const std::string& require_regular(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw FileError(echo(path, shown_path), "cannot read: it is no regular file");
  return path;
}

} // namespace

BinaryFile::BinaryFile(const std::string& path) : path_(require_regular(path)), file_(path == "-" ? "./-" : path) {
  std::error_code error;
  size_ = std::filesystem::file_size(path, error);
  if (error) throw FileError(echo(path, shown_path), "cannot read: " + error.message());
}

void BinaryFile::read(std::span<std::byte> to, const std::string& what) {
  if (to.size() > left()) fail("ends within " + what);
  for (std::size_t done = 0; done < to.size();) {
    // In steps, between which Ctrl-C is looked at.
    constexpr std::size_t step = std::size_t{1} << 20;
    const std::size_t count =
        file_.read(reinterpret_cast<char*>(to.data()) + done, std::min(step, to.size() - done)); // NOLINT(*-cast)
    if (count == 0) fail("ends within " + what);
    done += count;
  }
  position_ += to.size();
}

void BinaryFile::seek(std::uint64_t position) {
  file_.seek(position);
  position_ = position;
}

void BinaryFile::fail(const std::string& what) const { throw InputError(echo(path_, shown_path), what); }

} // namespace brdfplot
