/// \file
/// The rows of one block, read, evaluated and written as text. One evaluator a thread.
#pragma once

#include "sampling/sampler.hpp"
#include "stream/columns.hpp"
#include "stream/stream.hpp"

#include <exception>
#include <optional>

namespace brdfplot {

/// What all threads share.
struct StreamPlan {
  const Material& material;
  const StreamOptions& options;
  DirectionColumns columns;
  std::string file;               ///< for errors
  std::optional<Sampler> sampler; ///< where its density is asked for

  int channels_of(const StreamQuantity& quantity) const;
};

class StreamEvaluator {
public:
  explicit StreamEvaluator(const StreamPlan& plan);

  /// Sets `out` to the rows of `block` with their values, up to the first that is wrong: it is what is returned.
  std::exception_ptr run(const RowBlock& block, std::string& out);

private:
  /// The values of one quantity: channel k of row r at k * stride + r.
  struct Result {
    std::vector<double> values;
    std::vector<float> single; ///< instead, in single precision
    std::size_t channels = 1;
    std::size_t stride = 0;
  };

  /// Reads a chunk of rows, up to the first that is wrong: it is what is returned.
  std::exception_ptr read(FieldScanner& scanner, const std::string& text, std::size_t first_line);
  /// The integral of every row of the chunk, up to the first that misses the tolerance: it ends the chunk.
  std::exception_ptr integrate_rows(const StreamQuantity& quantity, Result& result);
  /// All quantities with a closed form, and densities.
  void evaluate_rows();
  double value_of(const Result& result, std::size_t index) const;
  /// The last guard: the first row with a value that is no answer ends the chunk.
  std::exception_ptr guard(const StreamQuantity& quantity, const Result& result);
  void append_value(std::string& out, const Result& result, std::size_t index) const;
  void append_rows(std::string& out) const;
  std::string where(std::size_t line) const { return plan_.file + ":" + std::to_string(line); }
  Columns columns_of(Letter letter) const;

  const StreamPlan& plan_;
  std::size_t n_ = 0; ///< rows of the chunk
  std::vector<std::string_view> rows_;
  std::vector<std::size_t> lines_;
  std::array<std::array<std::vector<double>, 3>, letter_count> directions_; ///< x, y, z of o, i, m
  std::vector<Result> results_;                                             ///< per quantity
};

} // namespace brdfplot
