#include "figure/numbers.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "draw/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::plot {

namespace {

template <class Items>
[[noreturn]] void fail_unknown(const std::string& what, const std::string& name, const Items& items) {
  std::string accepted;
  for (const auto& item : items) accepted += (accepted.empty() ? "\"" : ", \"") + item.label + "\"";
  throw InputError("", "found " + what + " \"" + name + "\"; accepted: " + (accepted.empty() ? "none" : accepted));
}

template <class Items>
const auto& labelled(const std::string& what, const std::string& name, const Items& items) {
  const auto found = std::ranges::find_if(items, [&](const auto& item) { return item.label == name; });
  if (found == items.end()) fail_unknown(what, name, items);
  return *found;
}

/// Along the straight line that is drawn between the points on both sides, which on a logarithmic axis of y is one of
/// ln y.
double interpolated(const Series& series, double x, Scale scale = Scale::linear) {
  const auto after = std::ranges::lower_bound(series.x, x);
  if (after == series.x.end() || (after == series.x.begin() && series.x.front() > x))
    throw InputError("", "x = " + format_number(x) + " of series \"" + series.label + "\" is not drawn");
  const auto k = static_cast<std::size_t>(after - series.x.begin());
  if (series.x[k] <= x) return series.y[k];
  const double t = (x - series.x[k - 1]) / (series.x[k] - series.x[k - 1]);
  const double before = series.y[k - 1], next = series.y[k];
  if (scale == Scale::logarithmic && before > 0 && next > 0) return before * std::pow(next / before, t);
  return before + t * (next - before);
}

/// The value at x. Beyond the ends of the axis, where nobody sees them, curves are not sampled finely enough for that.
double value_at(const Panel& panel, const Series& series, double x) {
  const double y = interpolated(series, x, panel.y.scale);
  if (y < panel.y.from || y > panel.y.to)
    throw InputError("", "series \"" + series.label + "\" at x = " + format_number(x) + " is " + format_number(y) +
                             ", beyond the axis of y, where it is not drawn");
  return y;
}

/// Keeps the extreme of what it is offered, and where it is.
class Extreme {
public:
  explicit Extreme(const Reading& reading) : reading_(reading) {}

  void offer(double x, double y) {
    const double value = reading_.magnitude ? std::abs(y) : y;
    if (!std::isfinite(value) || (reading_.take == Reading::Take::largest ? value <= best_ : value >= best_)) return;
    best_ = value;
    place_ = x;
  }

  /// The points within the range, and those at its ends.
  void offer(const Series& series) {
    for (std::size_t k = 0; k < series.y.size(); ++k)
      if (series.x[k] >= reading_.from && series.x[k] <= reading_.to) offer(series.x[k], series.y[k]);
    for (const double x : {reading_.from, reading_.to})
      if (!series.x.empty() && x >= series.x.front() && x <= series.x.back()) offer(x, interpolated(series, x));
  }

  double result() const {
    if (std::isnan(best_)) throw InputError("", "series \"" + reading_.series + "\" has no value there");
    return reading_.place ? place_ : best_;
  }

private:
  const Reading& reading_;
  double best_ = std::numeric_limits<double>::quiet_NaN(), place_ = best_;
};

double value_of(const Reading& reading, const Figure& figure) {
  const Panel& panel = figure.panels.at(reading.panel);
  if (reading.take == Reading::Take::note) return labelled("note", reading.series, panel.notes).value;
  if (reading.take == Reading::Take::at)
    return value_at(panel, labelled("series", reading.series, panel.series), reading.x);
  Extreme extreme(reading);
  if (!reading.any_series) {
    extreme.offer(labelled("series", reading.series, panel.series));
    return extreme.result();
  }
  if (panel.grid)
    for (const double value : panel.grid->value) extreme.offer(0, value);
  for (const Series& series : panel.series) extreme.offer(series);
  return extreme.result();
}

} // namespace

double value_of(const NumberExpression& number, const Figure& figure) {
  if (number.operation == NumberExpression::Operation::reading) return value_of(number.reading, figure);
  const double first = value_of(number.operands.at(0), figure), second = value_of(number.operands.at(1), figure);
  return number.operation == NumberExpression::Operation::ratio ? first / second : first - second;
}

std::string text_of(double value, NumberDescription::Form form, int digits) {
  if (form == NumberDescription::Form::percent)
    return text_of(100 * value, NumberDescription::Form::plain, digits) + " %";
  if (form == NumberDescription::Form::degrees)
    return text_of(value * 180 / std::numbers::pi, NumberDescription::Form::plain, digits) + "°";
  if (value == 0) return "0"; // NOLINT(clang-diagnostic-float-equal)
  // Rounding may bring it to the next power of ten.
  const auto exponent_of = [](double of) { return static_cast<int>(std::floor(std::log10(std::abs(of)))); };
  const double unit = std::pow(10.0, exponent_of(value) - digits + 1), rounded = std::round(value / unit) * unit;
  const int exponent = exponent_of(rounded * (1 + 1e-12));
  if (exponent < -4 || exponent >= 6) return power_label(rounded, exponent, digits - 1);
  return decimal_label(rounded, std::max(0, digits - 1 - exponent));
}

namespace {

/// Where {name} begins next, from `at` on; npos: nowhere. The groups of sub- and superscripts are not names.
std::size_t find_name(const std::string& text, std::size_t at) {
  for (at = text.find('{', at); at != std::string::npos; at = text.find('{', at + 1))
    if (at == 0 || (text[at - 1] != '_' && text[at - 1] != '^')) break;
  return at;
}

} // namespace

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (auto at = find_name(text, 0); at != std::string::npos; at = find_name(text, at + 1)) {
    const auto end = text.find('}', at);
    if (end == std::string::npos) break;
    names.push_back(text.substr(at + 1, end - at - 1));
  }
  return names;
}

std::string caption_with(const std::string& caption, const std::vector<NumberDescription>& numbers,
                         const Figure& figure) {
  std::string out = caption;
  for (auto at = find_name(out, 0); at != std::string::npos; at = find_name(out, at + 1)) {
    const auto length = out.find('}', at) - at + 1;
    const auto named = [&](const NumberDescription& number) {
      return out.substr(at, length) == "{" + number.name + "}";
    };
    const auto found = std::ranges::find_if(numbers, named);
    if (found != numbers.end())
      out.replace(at, length, text_of(value_of(found->value, figure), found->form, found->digits));
  }
  return out;
}

} // namespace brdfplot::plot
