#include "stream/rows.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace brdfplot {

namespace {

constexpr std::size_t longest_row = std::size_t{16} << 20;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Just behind the last line end that ends a row; 0 when there is none.
std::size_t end_of_whole_rows(std::string_view text) {
  if (text.find('"') == std::string_view::npos) return text.rfind('\n') + 1;
  std::size_t end = 0;
  for (FieldScanner scanner(text); !scanner.at_end();) {
    scanner.next();
    if (scanner.row_ended() && !scanner.cut()) end = scanner.position();
  }
  return end;
}

std::size_t count_lines(std::string_view text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

} // namespace

std::string_view FieldScanner::next() {
  const std::size_t start = position_;
  std::size_t i = start;
  if (i < text_.size() && text_[i] == '"') {
    for (++i; i < text_.size(); ++i) {
      if (text_[i] == '\n') ++lines_;
      if (text_[i] != '"') continue;
      if (i + 1 == text_.size() || text_[i + 1] != '"') break;
      ++i;
    }
  }
  while (i < text_.size() && text_[i] != ',' && text_[i] != '\n') ++i;
  cut_ = i >= text_.size();
  row_ended_ = cut_ || text_[i] == '\n';
  if (!cut_ && row_ended_) ++lines_;
  position_ = cut_ ? text_.size() : i + 1;
  std::size_t end = std::min(i, text_.size());
  if (row_ended_ && end > start && text_[end - 1] == '\r') --end;
  return text_.substr(start, end - start);
}

bool FieldScanner::next_number(double& number) {
  const char* const last = text_.data() + text_.size();
  double value = 0;
  const auto [end, error] = std::from_chars(text_.data() + position_, last, value);
  if (error != std::errc() || end == last || (*end != ',' && *end != '\n') || !std::isfinite(value)) return false;
  number = value;
  cut_ = false;
  row_ended_ = *end == '\n';
  if (row_ended_) ++lines_;
  position_ = static_cast<std::size_t>(end - text_.data()) + 1;
  return true;
}

std::string unquoted(std::string_view field) {
  constexpr std::string_view blank = " \t";
  const auto first = field.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  field = field.substr(first, field.find_last_not_of(blank) - first + 1);
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return std::string(field);
  std::string text;
  for (std::size_t i = 1; i + 1 < field.size(); ++i) {
    text += field[i];
    if (field[i] == '"' && field[i + 1] == '"') ++i;
  }
  return text;
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

bool RowReader::fill() {
  if (ended_) return false;
  const std::size_t size = rest_.size();
  // A row that is longer than a block is looked through from its start with every piece that comes. A short file takes
  // no more memory than it needs.
  const std::size_t step = std::max(next_size_, size);
  next_size_ = std::min(2 * next_size_, block_size_);
  rest_.resize(size + step);
  const std::size_t count = source_.read(rest_.data() + size, step);
  rest_.resize(size + count);
  ended_ = count == 0;
  if (!started_ && (rest_.size() >= byte_order_mark.size() || ended_)) {
    started_ = true;
    if (rest_.starts_with(byte_order_mark)) rest_.erase(0, byte_order_mark.size());
  }
  if (rest_.size() > longest_row && end_of_whole_rows(rest_) == 0)
    throw InputError(source_.name() + ":" + std::to_string(line_), "a row of more than 16 MiB; is a quote not closed?");
  return !ended_;
}

std::string RowReader::header() {
  while (true) {
    FieldScanner scanner(rest_);
    while (!scanner.at_end()) {
      scanner.next();
      if (scanner.row_ended()) break;
    }
    const bool whole = started_ && scanner.row_ended() && !scanner.cut();
    if (!whole && fill()) continue;
    std::string row = rest_.substr(0, scanner.position());
    if (row.empty()) return row;
    rest_.erase(0, scanner.position());
    header_line_ = line_;
    line_ += count_lines(row);
    if (is_blank(row)) continue;
    while (row.ends_with('\n') || row.ends_with('\r')) row.pop_back();
    return row;
  }
}

bool RowReader::next(RowBlock& block) {
  std::size_t end = end_of_whole_rows(rest_);
  while (end == 0 && fill()) end = end_of_whole_rows(rest_);
  if (end == 0) end = rest_.size();
  block.text.assign(rest_, 0, end);
  block.first_line = line_;
  rest_.erase(0, end);
  line_ += count_lines(block.text);
  if (block.text.empty()) return false;
  if (block.text.back() != '\n') block.text += '\n';
  return true;
}

} // namespace brdfplot
