#include "stream/evaluator.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "brdf/evaluate_single.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace brdfplot {

namespace {

/// Rows are evaluated by so many: enough for the batch evaluation, few enough for the cache.
constexpr std::size_t chunk_size = 1024;

} // namespace

int StreamPlan::channels_of(const StreamQuantity& quantity) const {
  if (const auto* info = quantity.closed_form()) return brdfplot::channels_of(material, info->quantity, quantity.term);
  if (quantity.is_density()) return 1;
  return quantity.integral()->coloured ? brdfplot::channels_of(material, Quantity::brdf, quantity.term) : 1;
}

StreamEvaluator::StreamEvaluator(const StreamPlan& plan) : plan_(plan), rows_(chunk_size), lines_(chunk_size) {
  for (auto& direction : directions_)
    for (auto& component : direction) component.resize(chunk_size);
  for (const auto& quantity : plan.options.quantities) {
    const auto channels = static_cast<std::size_t>(plan.channels_of(quantity));
    const bool single = plan.options.single_precision;
    results_.push_back({std::vector<double>(single ? 0 : chunk_size * channels),
                        std::vector<float>(single ? chunk_size * channels : 0), channels, chunk_size});
  }
}

std::exception_ptr StreamEvaluator::run(const RowBlock& block, std::string& out) {
  out.clear();
  const auto& quantities = plan_.options.quantities;
  std::exception_ptr failure;
  for (FieldScanner scanner(block.text); !scanner.at_end() && !failure;) {
    throw_if_interrupted();
    failure = read(scanner, block.text, block.first_line);
    // Integrals first: they may end the chunk before its last row.
    for (std::size_t q = 0; q < quantities.size(); ++q)
      if (quantities[q].integral() != nullptr)
        if (auto missed = integrate_rows(quantities[q], results_[q])) failure = std::move(missed);
    evaluate_rows();
    for (std::size_t q = 0; q < quantities.size(); ++q)
      if (quantities[q].integral() == nullptr)
        if (auto untold = guard(quantities[q], results_[q])) failure = std::move(untold);
    append_rows(out);
  }
  return failure;
}

std::exception_ptr StreamEvaluator::read(FieldScanner& scanner, const std::string& text, std::size_t first_line) {
  n_ = 0;
  std::array<Direction, letter_count> directions{};
  while (n_ < chunk_size && !scanner.at_end()) {
    const std::size_t start = scanner.position();
    const std::size_t row_line = first_line + scanner.lines();
    const auto problem = plan_.columns.read_row(scanner, directions);
    std::string_view row = std::string_view(text).substr(start, scanner.position() - start);
    // A blank line has one field, and so may look like a wrong row.
    if (row.front() <= ' ' && is_blank(row)) continue;
    if (problem) return std::make_exception_ptr(InputError(where(row_line), *problem));
    row.remove_suffix(row.ends_with("\r\n") ? 2 : 1);
    rows_[n_] = row;
    lines_[n_] = row_line;
    for (std::size_t letter = 0; letter < letter_count; ++letter) {
      directions_[letter][0][n_] = directions[letter].x;
      directions_[letter][1][n_] = directions[letter].y;
      directions_[letter][2][n_] = directions[letter].z;
    }
    ++n_;
  }
  return nullptr;
}

std::exception_ptr StreamEvaluator::integrate_rows(const StreamQuantity& quantity, Result& result) {
  const Columns o = columns_of(Letter::o);
  Rgb values{};
  for (std::size_t r = 0; r < n_; ++r) {
    const bool as_before = r > 0 && o.x[r] == o.x[r - 1] && o.y[r] == o.y[r - 1] && o.z[r] == o.z[r - 1];
    if (!as_before) {
      throw_if_interrupted();
      try {
        values = compute_channels_or_throw(quantity.integral()->integral, plan_.material, {o.x[r], o.y[r], o.z[r]},
                                           plan_.options.tolerance, quantity.term);
      } catch (const AccuracyError& error) {
        n_ = r;
        return std::make_exception_ptr(AccuracyError(where(lines_[r]), error.what()));
      }
    }
    for (std::size_t k = 0; k < result.channels; ++k) result.values[k * result.stride + r] = values[k];
  }
  return nullptr;
}

void StreamEvaluator::evaluate_rows() {
  const Batch given{n_, columns_of(Letter::o), columns_of(Letter::i), columns_of(Letter::m)};
  const Batch of_half_vectors{n_, given.o, given.i, {}}; // g2 too is that of the half vector
  std::vector<Wanted> wanted, wanted_of_half_vectors;
  for (std::size_t q = 0; q < results_.size(); ++q) {
    const StreamQuantity& quantity = plan_.options.quantities[q];
    const QuantityInfo* info = quantity.closed_form();
    if (quantity.integral() != nullptr) continue;
    Result& result = results_[q];
    result.stride = n_;
    if (info == nullptr) {
      plan_.sampler->densities(n_, given.o, given.i, result.values.data());
      continue;
    }
    const bool halve = info->needs.i || !given.m;
    if (plan_.options.single_precision)
      evaluate(plan_.material, info->quantity, halve ? of_half_vectors : given, result.single.data(), quantity.term);
    else
      (halve ? wanted_of_half_vectors : wanted).push_back({info->quantity, result.values.data(), quantity.term});
  }
  evaluate(plan_.material, wanted, given);
  evaluate(plan_.material, wanted_of_half_vectors, of_half_vectors);
}

double StreamEvaluator::value_of(const Result& result, std::size_t index) const {
  return plan_.options.single_precision ? static_cast<double>(result.single[index]) : result.values[index];
}

std::exception_ptr StreamEvaluator::guard(const StreamQuantity& quantity, const Result& result) {
  for (std::size_t r = 0; r < n_; ++r)
    for (std::size_t k = 0; k < result.channels; ++k) {
      const double value = value_of(result, k * result.stride + r);
      // What is beyond float's range the kernels give as its largest number.
      const bool beyond = plan_.options.single_precision && value == std::numeric_limits<float>::max();
      const QuantityInfo* info = quantity.closed_form();
      if ((info == nullptr ? std::isfinite(value) : is_told(info->quantity, value)) && !beyond) continue;
      n_ = r;
      return std::make_exception_ptr(
          AccuracyError(where(lines_[r]),
                        "\"" + quantity.name + "\": found " + format_number(value) + ", accepted: a finite number"));
    }
  return nullptr;
}

Columns StreamEvaluator::columns_of(Letter letter) const {
  if (!plan_.columns.has(letter)) return {};
  const auto& components = directions_[static_cast<std::size_t>(letter)];
  return {components[0].data(), components[1].data(), components[2].data()};
}

void StreamEvaluator::append_value(std::string& out, const Result& result, std::size_t index) const {
  if (!plan_.options.single_precision) return append_number(out, result.values[index]);
  std::array<char, 16> buffer;
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), result.single[index]);
  out.append(buffer.data(), written.ptr);
}

void StreamEvaluator::append_rows(std::string& out) const {
  for (std::size_t r = 0; r < n_; ++r) {
    out += rows_[r];
    for (const Result& result : results_) {
      for (std::size_t k = 0; k < result.channels; ++k) {
        out += ',';
        append_value(out, result, k * result.stride + r);
      }
    }
    out += '\n';
  }
}

} // namespace brdfplot
