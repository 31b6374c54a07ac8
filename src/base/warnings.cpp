#include "base/warnings.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

namespace brdfplot {

namespace {

constexpr std::size_t most_warnings = 20;

std::mutex warnings_mutex;

std::vector<std::string>& kept_warnings() {
  static std::vector<std::string> kept;
  return kept;
}

} // namespace

void warn(const std::string& where, const std::string& what) {
  const std::lock_guard lock(warnings_mutex);
  std::string text = where + ": " + what;
  auto& kept = kept_warnings();
  if (kept.size() < most_warnings && std::ranges::find(kept, text) == kept.end()) kept.push_back(std::move(text));
}

std::vector<std::string> take_warnings() {
  const std::lock_guard lock(warnings_mutex);
  std::vector<std::string> taken;
  taken.swap(kept_warnings());
  return taken;
}

void warn_of_degrees(const std::string& where, const std::string& name, double radians) {
  if (!(std::abs(radians) > 2 * std::numbers::pi) || !std::isfinite(radians)) return;
  const std::string number = format_number(radians);
  warn(where, name + " = " + number + " rad is more than a full circle; " + number + "deg?");
}

} // namespace brdfplot
