#include "base/kept.hpp"

#include "base/errors.hpp"
#include "base/hash.hpp"
#include "base/text_files.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace brdfplot {

namespace {

constexpr std::size_t word_size = sizeof(std::uint64_t);

std::string head_of(const std::string& key) {
  // The number tells the order of its bytes: a machine of the other one finds no file of its own.
  constexpr std::uint64_t order = 0x0102030405060708;
  std::string text = "brdfplot pieces 1 " + std::to_string(key.size()) + "\n" + key + "\n";
  return text.append(reinterpret_cast<const char*>(&order), word_size);
}

void append(std::string& bytes, std::uint64_t value) { bytes.append(reinterpret_cast<const char*>(&value), word_size); }

void append(std::string& bytes, const Numbers& numbers) {
  if (!numbers.empty()) bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

std::uint64_t word_at(std::string_view bytes, std::size_t place) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + place, word_size);
  return value;
}

Numbers numbers_at(std::string_view bytes, std::size_t place, std::size_t count) {
  Numbers numbers(count);
  if (count > 0) std::memcpy(numbers.data(), bytes.data() + place, count * sizeof(double));
  return numbers;
}

/// Two counts, the numbers, the hash of these.
std::string record_of(const Numbers& piece, const Numbers& result) {
  std::string bytes;
  append(bytes, piece.size());
  append(bytes, result.size());
  append(bytes, piece);
  append(bytes, result);
  append(bytes, hash(bytes));
  return bytes;
}

/// The records from `place` on; returns where the whole ones end.
std::size_t read_records(std::string_view bytes, std::size_t place, std::map<Numbers, Numbers>& found) {
  while (bytes.size() - place >= 3 * word_size) {
    const std::uint64_t inputs = word_at(bytes, place), outputs = word_at(bytes, place + word_size);
    const std::size_t room = (bytes.size() - place - 3 * word_size) / sizeof(double);
    if (inputs > room || outputs > room - inputs) break;
    const std::size_t size = 2 * word_size + (inputs + outputs) * sizeof(double);
    if (hash(bytes.substr(place, size)) != word_at(bytes, place + size)) break;
    found[numbers_at(bytes, place + 2 * word_size, inputs)] =
        numbers_at(bytes, place + 2 * word_size + inputs * sizeof(double), outputs);
    place += size + word_size;
  }
  return place;
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(fd, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

} // namespace

std::string KeptPieces::path(const std::string& folder, const std::string& key) {
  return (std::filesystem::path(folder) / "pieces" / std::to_string(hash(key))).string();
}

KeptPieces::KeptPieces(const std::string& folder, const std::string& key) {
  if (folder.empty()) return;
  path_ = path(folder, key);
  head_ = head_of(key);
  std::error_code error;
  if (std::filesystem::is_regular_file(path_, error)) open_file();
}

void KeptPieces::open_file() {
  try {
    create_folders(std::filesystem::path(path_).parent_path().string());
    fd_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (fd_ < 0) return give_up();
    if (flock(fd_, LOCK_EX | LOCK_NB) != 0) return give_up();
    const std::string bytes = read_text_file(path_);
    const bool is_ours = bytes.starts_with(head_);
    const std::size_t whole = is_ours ? read_records(bytes, head_.size(), found_) : 0;
    if (ftruncate(fd_, static_cast<off_t>(whole)) != 0 || (!is_ours && !write_all(fd_, head_))) give_up();
  } catch (const FileError&) {
    give_up();
  }
}

KeptPieces::~KeptPieces() { give_up(); }

void KeptPieces::swap(KeptPieces& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(head_, other.head_);
  std::swap(fd_, other.fd_);
  std::swap(found_, other.found_);
}

void KeptPieces::give_up() {
  if (fd_ >= 0) close(fd_);
  fd_ = -1;
  path_.clear();
}

const Numbers* KeptPieces::find(const Numbers& piece) const {
  const auto place = found_.find(piece);
  return place == found_.end() ? nullptr : &place->second;
}

void KeptPieces::add(const Numbers& piece, const Numbers& result) {
  if (path_.empty()) return;
  if (fd_ < 0) open_file();
  if (fd_ >= 0 && !write_all(fd_, record_of(piece, result))) give_up();
}

void KeptPieces::remove() {
  if (fd_ >= 0) unlink(path_.c_str());
  give_up();
}

} // namespace brdfplot
