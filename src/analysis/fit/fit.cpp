#include "analysis/fit/fit.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

/// What the error may be on the grid of the fit, so that it is within the tolerance between its points too.
constexpr double margin_of_one = 0.998;
constexpr double margin_of_two = 0.98;

/// About where Lambda is 1, and from where on all Lambda are below the tolerance.
struct Landmarks {
  double unit = 1;
  double negligible = 0;
};

Landmarks landmarks(const FitSamples& samples, double tolerance) {
  Landmarks found;
  const std::size_t middle = samples.samples.size() / samples.per_line / 2 * samples.per_line;
  for (std::size_t k = middle; k < middle + samples.per_line; ++k)
    if (samples.samples[k].lambda > 1) found.unit = samples.samples[k].a;
  for (const FitSample& s : samples.samples)
    if (s.lambda > tolerance) found.negligible = std::max(found.negligible, s.a);
  return found;
}

/// Scales to begin with; the cut is nowhere below where Lambda is within the tolerance of 0.
std::vector<double> scales(const RationalForm& form, const Landmarks& at) {
  std::vector<double> out;
  if (!form.cut)
    for (double factor = 0.25; factor < 20; factor *= 2) out.push_back(at.unit * factor);
  else if (at.negligible < 40 * at.unit)
    for (double factor = 1.001; factor < 3; factor *= 1.15) out.push_back(at.negligible * factor);
  return out;
}

/// The best scale near one at which there is a fit, by golden section of the minimax error.
LambdaFit refined(const LambdaFit& start, double spread, double tolerance, const FitSamples& samples) {
  const auto fit_at = [&](double log_scale) {
    RationalForm form = start.form;
    form.scale = std::exp(log_scale);
    return minimax_fit(tolerance, form, samples);
  };
  constexpr double golden = 0.6180339887498949;
  std::optional<LambdaFit> best = minimax_fit(tolerance, start.form, samples);
  if (!best) return start;
  double least = largest_error(*best, samples).error;
  const auto error_at = [&](double log_scale) {
    const auto fit = fit_at(log_scale);
    if (!fit) return HUGE_VAL;
    const double error = largest_error(*fit, samples).error;
    if (error < least) {
      least = error;
      best = fit;
    }
    return error;
  };
  double low = std::log(start.form.scale) - spread;
  double high = std::log(start.form.scale) + spread;
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double at_left = error_at(left);
  double at_right = error_at(right);
  for (int step = 0; step < 9; ++step) {
    const bool go_left = at_left < at_right;
    (go_left ? high : low) = go_left ? right : left;
    (go_left ? right : left) = go_left ? left : right;
    (go_left ? at_right : at_left) = go_left ? at_left : at_right;
    (go_left ? left : right) = go_left ? high - golden * (high - low) : low + golden * (high - low);
    (go_left ? at_left : at_right) = error_at(go_left ? left : right);
  }
  return *best;
}

std::vector<RationalForm> forms_of_one() {
  std::vector<RationalForm> forms;
  for (const bool cut : {false, true})
    for (const int power : {1, 2, 3, 4, 6, 8})
      for (std::size_t nx = 0; nx <= 6; ++nx)
        for (std::size_t mx = 0; mx <= 6; ++mx) forms.push_back({cut, 1, power, nx, 0, mx, 0});
  std::ranges::stable_sort(forms, {}, [](const RationalForm& form) { return cost_of(form).total(); });
  return forms;
}

/// The most accurate of the cheapest forms in one variable that are within the tolerance.
std::optional<LambdaFit> cheapest_of_one(double tolerance, const FitSamples& samples, int threads) {
  const std::vector<RationalForm> forms = forms_of_one();
  for (std::size_t begin = 0; begin < forms.size();) {
    std::size_t end = begin;
    while (end < forms.size() && cost_of(forms[end]).total() == cost_of(forms[begin]).total()) ++end;
    std::vector<std::optional<LambdaFit>> fits(end - begin);
    parallel_for(fits.size(), threads,
                 [&](std::size_t k) { fits[k] = fit_form(forms[begin + k], tolerance, samples); });
    std::optional<LambdaFit> best;
    for (const auto& fit : fits)
      if (fit && (!best || largest_error(*fit, samples).error < largest_error(*best, samples).error)) best = fit;
    if (best) return best;
    begin = end;
  }
  return std::nullopt;
}

constexpr std::size_t largest_square = 6;

RationalForm square_form(int power, double scale, std::size_t degree) {
  const std::size_t in_y = std::min<std::size_t>(degree, 5);
  return {false, scale, power, degree, in_y, degree, in_y};
}

/// The forms with one degree lowered by one, cheapest first.
std::vector<RationalForm> lowered(const RationalForm& form) {
  std::vector<RationalForm> out;
  for (std::size_t RationalForm::*degree :
       {&RationalForm::nx, &RationalForm::ny, &RationalForm::mx, &RationalForm::my}) {
    if (form.*degree == 0) continue;
    out.push_back(form);
    --(out.back().*degree);
  }
  std::ranges::stable_sort(out, {}, [](const RationalForm& f) { return cost_of(f).total(); });
  return out;
}

/// The power and scale for two variables: those with the smallest error at a low degree.
RationalForm promising(const FitSamples& samples, const Landmarks& at, int threads) {
  std::vector<RationalForm> forms;
  for (const int power : {1, 2, 4})
    for (const double factor : {0.6, 1.5, 4.0}) forms.push_back(square_form(power, factor * at.unit, 2));
  std::vector<double> errors(forms.size(), HUGE_VAL);
  parallel_for(forms.size(), threads, [&](std::size_t k) {
    const auto fit = minimax_fit(0.05, forms[k], samples);
    if (fit) errors[k] = largest_error(*fit, samples).error;
  });
  return forms[static_cast<std::size_t>(std::ranges::min_element(errors) - errors.begin())];
}

/// The first square degree within the tolerance, then with its degrees lowered as far as that stays so; the last of
/// these that is sound.
std::optional<LambdaFit> cheapest_of_two(double tolerance, const FitSamples& samples, int threads) {
  const RationalForm start = promising(samples, landmarks(samples, tolerance), threads);
  std::vector<RationalForm> within;
  for (std::size_t degree = 1; degree <= largest_square && within.empty(); ++degree) {
    const RationalForm form = square_form(start.power, start.scale, degree);
    if (fit_within(tolerance, form, samples)) within.push_back(form);
  }
  for (bool lower = !within.empty(); lower;) {
    const std::vector<RationalForm> next = lowered(within.back());
    std::vector<char> fits(next.size());
    parallel_for(next.size(), threads,
                 [&](std::size_t k) { fits[k] = fit_within(tolerance, next[k], samples).has_value() ? 1 : 0; });
    const auto first = std::ranges::find(fits, 1);
    lower = first != fits.end();
    if (lower) within.push_back(next[static_cast<std::size_t>(first - fits.begin())]);
  }
  for (std::size_t k = within.size(); k-- > 0;)
    if (auto fit = sound_fit(tolerance, within[k], samples)) return fit;
  return std::nullopt;
}

/// The best error that the largest forms reach, for the message.
double best_error(const FitSamples& samples, const Landmarks& at, bool two) {
  double best = HUGE_VAL;
  const auto attempt = [&](const RationalForm& form) {
    if (const auto fit = minimax_fit(0.5, form, samples)) best = std::min(best, largest_error(*fit, samples).error);
  };
  if (two)
    attempt(square_form(2, 1.5 * at.unit, largest_square));
  else
    for (const bool cut : {false, true})
      for (const int power : {2, 4, 8})
        for (const double scale : scales({cut, 1, power}, at)) attempt({cut, scale, power, 6, 0, 6, 0});
  return best;
}

/// Whether the numbers of the code are proved sound as double and as float have them.
bool sound(const FitCode& code, const FitTarget& target) {
  return without_rounding(code, target).proved_sound() && without_rounding(in_floats(code), target).proved_sound();
}

/// The code of a fit in the basis in which float loses least; coefficients are floats where the fit then is within the
/// tolerance and sound.
void write_code(FitResult& result, const LambdaFit& fit, double tolerance, const FitSamples& samples) {
  bool found = false;
  for (const bool single : {true, false}) {
    for (const bool n_in_u : {false, true}) {
      for (const bool m_in_u : {false, true}) {
        const FitCode code = as_code(fit, result.target, n_in_u, m_in_u, single);
        const LambdaFit exact = without_rounding(code, result.target);
        if (!(single ? largest_error(exact, samples).error <= tolerance && sound(code, result.target)
                     : exact.proved_sound()))
          continue;
        const FitAccuracy in_float = accuracy_of(result.target, code, samples, true);
        if (found && !(in_float.relative.error < result.in_float.relative.error)) continue;
        found = true;
        result.code = code;
        result.fit = exact;
        result.in_float = in_float;
        result.single = single;
      }
    }
    if (found) break;
  }
  result.in_double = accuracy_of(result.target, result.code, samples, false);
}

/// The cheapest fit within `tolerance`, as code; nothing where there is none.
std::optional<FitResult> cheapest(const FitTarget& target, double tolerance, const FitSamples& samples,
                                  const FitSamples& dense, int threads) {
  const bool two = target.parameter.has_value();
  const double asked = tolerance * (two ? margin_of_two : margin_of_one);
  const auto fit = two ? cheapest_of_two(asked, samples, threads) : cheapest_of_one(asked, samples, threads);
  if (!fit) return std::nullopt;
  FitResult result{.target = target, .code = {}, .fit = {}, .in_double = {}, .in_float = {}};
  write_code(result, *fit, tolerance, dense);
  return result;
}

} // namespace

std::optional<LambdaFit> fit_form(RationalForm form, double tolerance, const FitSamples& samples) {
  const Landmarks at = landmarks(samples, tolerance);
  std::optional<LambdaFit> best;
  double least = HUGE_VAL;
  for (const double scale : scales(form, at)) {
    form.scale = scale;
    const auto fit = fit_within(tolerance, form, samples);
    if (!fit || largest_error(*fit, samples).error >= least) continue;
    least = largest_error(*fit, samples).error;
    best = fit;
  }
  if (!best) return best;
  best = refined(*best, std::log(form.cut ? 1.15 : 2.0), tolerance, samples);
  return best->proved_sound() ? best : sound_fit(tolerance, best->form, samples);
}

FitResult fit_lambda(const MaterialDescription& description, const FitOptions& options) {
  const FitTarget target = fit_target(description, options.fixed);
  const bool two = target.parameter.has_value();
  const FitSamples samples = two ? sample(target, 120, 25, options.threads) : sample(target, 800, 1, options.threads);
  const FitSamples dense = two ? sample(target, 311, 145, options.threads) : sample(target, 4001, 1, options.threads);
  const auto fail = [&](double reached) {
    throw AccuracyError("", "the rational fits of Lambda reached a relative error of G1 of " + format_number(reached) +
                                " (asked: " + format_number(options.tolerance) + ")");
  };
  auto result = cheapest(target, options.tolerance, samples, dense, options.threads);
  if (result && result->in_double.relative.error > options.tolerance) // between the points of the fit
    result = cheapest(target, 0.95 * options.tolerance, samples, dense, options.threads);
  if (!result) fail(best_error(samples, landmarks(samples, options.tolerance), two));
  if (!(result->in_double.relative.error <= options.tolerance)) fail(result->in_double.relative.error);
  const double left = options.tolerance - 1.2 * result->in_float.rounding;
  if (result->in_float.relative.error > options.tolerance && left >= 0.5 * options.tolerance) {
    const auto stricter = cheapest(target, left, samples, dense, options.threads);
    if (stricter && stricter->in_float.relative.error <= options.tolerance) result = stricter;
  }
  return *result;
}

} // namespace brdfplot
