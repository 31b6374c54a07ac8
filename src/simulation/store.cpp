#include "simulation/store.hpp"

#include "base/errors.hpp"
#include "base/hash.hpp"
#include "base/number.hpp"
#include "base/text_files.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace brdfplot::simulation {

namespace {

std::string hexadecimal(std::uint64_t value) {
  std::array<char, 16> digits{};
  digits.fill('0');
  std::array<char, 16> out{};
  const auto end = std::to_chars(out.data(), out.data() + out.size(), value, 16).ptr;
  const auto length = static_cast<std::size_t>(end - out.data());
  return std::string(digits.data(), out.size() - length) + std::string(out.data(), length);
}

std::string head(const std::string& key) {
  return "brdfplot simulation " + std::to_string(results_version) + " " + std::to_string(key.size()) + "\n" + key +
         "\n";
}

/// Reads words separated by single blanks or line ends.
class Words {
public:
  explicit Words(std::string_view text) : text_(text) {}
  std::string_view next() {
    const auto end = std::min(text_.find_first_of(" \n"), text_.size());
    const auto word = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    return word;
  }
  template <class Number>
  bool read(Number& value) {
    const auto word = next();
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
  }
  bool done() const { return text_.empty(); }

private:
  std::string_view text_;
};

} // namespace

std::string to_text(const std::string& key, const Result& result) {
  std::string text = head(key);
  for (const auto& [name, estimates] : result) {
    text += name + " " + std::to_string(estimates.points) + " " + std::to_string(estimates.values.size()) + "\n";
    for (const double value : estimates.values) {
      append_number(text, value);
      text += '\n';
    }
  }
  return text + hexadecimal(hash(text)) + "\n";
}

std::optional<Result> from_text(const std::string& key, const std::string& text) {
  constexpr std::size_t tail = 17;
  const std::string start = head(key);
  if (text.size() < start.size() + tail || !text.starts_with(start)) return std::nullopt;
  const std::string_view body(text.data(), text.size() - tail);
  if (text.substr(text.size() - tail) != hexadecimal(hash(body)) + "\n") return std::nullopt;
  Result result;
  for (Words words(body.substr(start.size())); !words.done();) {
    Estimates& estimates = result[std::string(words.next())];
    std::size_t count = 0;
    if (!words.read(estimates.points) || !words.read(count) || count > body.size()) return std::nullopt;
    estimates.values.resize(count);
    for (double& value : estimates.values)
      if (!words.read(value)) return std::nullopt;
  }
  return result;
}

std::string Store::path(const std::string& key) const {
  const std::string name = hexadecimal(hash(key)) + hexadecimal(hash(key, ~hash_basis));
  return (std::filesystem::path(folder_) / ("v" + std::to_string(results_version)) / name).string();
}

std::optional<Result> Store::read(const std::string& key) const {
  if (folder_.empty()) return std::nullopt;
  std::error_code error;
  const std::string file = path(key);
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  try {
    return from_text(key, read_text_file(file));
  } catch (const FileError&) {
    return std::nullopt;
  }
}

void Store::write(const std::string& key, const Result& result) const {
  if (folder_.empty()) return;
  const std::string file = path(key);
  try {
    create_folders(std::filesystem::path(file).parent_path().string());
    write_text_file(file, to_text(key, result));
  } catch (const FileError&) {
    // A full disk or a folder of someone else's is no reason to lose what was computed.
    return;
  }
}

Store::Shared Store::make(const std::string& key, const std::function<Result()>& compute) const {
  if (auto kept = read(key)) return std::make_shared<const Result>(std::move(*kept));
  auto result = std::make_shared<const Result>(compute());
  write(key, *result);
  return result;
}

std::shared_ptr<const Result> Store::get(const std::string& key, const std::function<Result()>& compute) {
  std::promise<Shared> promise;
  {
    std::unique_lock lock(mutex_);
    const auto [place, is_new] = known_.try_emplace(key, promise.get_future().share());
    if (!is_new) {
      const auto other = place->second;
      lock.unlock();
      return other.get();
    }
  }
  try {
    auto result = make(key, compute);
    promise.set_value(result);
    return result;
  } catch (...) {
    promise.set_exception(std::current_exception());
    const std::lock_guard lock(mutex_);
    known_.erase(key);
    throw;
  }
}

std::string default_store_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  const std::filesystem::path cache = variable("XDG_CACHE_HOME");
  if (cache.is_absolute()) return (cache / "brdfplot").string();
  const std::filesystem::path home = variable("HOME");
  return home.is_absolute() ? (home / ".cache" / "brdfplot").string() : "";
}

} // namespace brdfplot::simulation
