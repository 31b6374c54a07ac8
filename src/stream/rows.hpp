/// \file
/// CSV as it comes from a file or a pipe: blocks of whole rows, and the fields of a row (RFC 4180).
///
/// A field that starts with a quote may hold commas, doubled quotes and line breaks. LF and CRLF end a row; the last
/// one needs no end. A byte order mark at the start is dropped.
#pragma once

#include "base/text_files.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace brdfplot {

/// Goes through the fields of a text of whole rows, one by one.
class FieldScanner {
public:
  explicit FieldScanner(std::string_view text) : text_(text) {}

  bool at_end() const { return position_ >= text_.size(); }
  std::size_t position() const { return position_; }
  /// The next field as it stands, quotes included; afterwards row_ended() tells whether it was the last of its row.
  std::string_view next();
  /// The same for a field that is a finite number and nothing else, which is then in `number`. Otherwise false, and the
  /// field is still the next one: it may be quoted, have blanks or a unit, or be wrong.
  bool next_number(double& number);
  bool row_ended() const { return row_ended_; }
  /// Whether the text ended instead of the row: there is more to read, or a quote is not closed.
  bool cut() const { return cut_; }
  /// How many lines ended so far, those inside quotes among them.
  std::size_t lines() const { return lines_; }

private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t lines_ = 0;
  bool row_ended_ = false;
  bool cut_ = false;
};

/// A field without its quotes and surrounding blanks.
std::string unquoted(std::string_view field);

bool is_blank(std::string_view text);

/// Whole rows, and the line of the file at which they start (from 1).
struct RowBlock {
  std::string text;
  std::size_t first_line = 1;
};

/// What rows are read from.
class RowSource {
public:
  RowSource() = default;
  virtual ~RowSource() = default;
  RowSource(const RowSource&) = delete;
  RowSource& operator=(const RowSource&) = delete;

  /// What errors name.
  virtual const std::string& name() const = 0;
  /// What errors of its header name, which is on this line.
  virtual std::string header_name(std::size_t line) const { return name() + ":" + std::to_string(line); }
  /// As those of InputFile.
  virtual std::size_t read(char* to, std::size_t size) = 0;
  virtual void stop() = 0;
};

/// The rows of a file.
class FileRows : public RowSource {
public:
  explicit FileRows(InputFile& file) : file_(file) {}
  const std::string& name() const override { return file_.name(); }
  std::size_t read(char* to, std::size_t size) override { return file_.read(to, size); }
  void stop() override { file_.stop(); }

private:
  InputFile& file_;
};

/// Cuts a stream at the ends of rows. Holds one incomplete row at most.
class RowReader {
public:
  /// `block_size`: how much is asked of the source at once, after less at first; what comes at once is a block.
  RowReader(RowSource& source, std::size_t block_size)
      : source_(source), block_size_(block_size), next_size_(std::min<std::size_t>(4096, block_size)) {}

  /// The first row that is not blank, without its end: the header. Empty at the end of the file.
  std::string header();
  std::size_t header_line() const { return header_line_; }
  /// Every row with its end; false when there are no more. \throws InputError for a row of more than 16 MiB: a quote
  /// that nothing closes.
  bool next(RowBlock& block);

private:
  bool fill();

  RowSource& source_;
  std::size_t block_size_;
  std::size_t next_size_;
  std::string rest_; ///< read, but not yet handed out
  std::size_t line_ = 1;
  std::size_t header_line_ = 1;
  bool started_ = false;
  bool ended_ = false;
};

} // namespace brdfplot
