#include "microfacet/distributions/custom.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "math/quadrature.hpp"
#include "microfacet/distributions/radial_structure.hpp"
#include "microfacet/remembered.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace brdfplot {

namespace {

const std::vector<std::string>& variables() {
  static const std::vector<std::string> names = {"t2", "t"};
  return names;
}

/// Why a shape is none.
struct ShapeProblem {
  std::string what;
};

constexpr double far = 1e30; ///< squared slope up to which a shape is looked at; what follows is a power of it

/// Values of f below this count as 0 where it is integrated: a formula underflows where its logarithm would not, and
/// loses its digits before.
constexpr double smallest = 1e-290;

/// f(t2).
double checked(const Formula& formula, double t2) {
  const std::array<double, 2> values = {t2, std::sqrt(t2)};
  const double f = formula(values);
  if (f >= 0 && f < infinity) return f;
  const std::string which = std::isnan(f) ? "not a number" : f < 0 ? "negative (" + format_number(f) + ")" : "infinite";
  throw ShapeProblem{"the shape is " + which + " at t2 = " + format_number(t2) +
                     "; accepted: finite and not negative from t2 = 0 on"};
}

/// f(t2) of a shape that was good wherever it was looked at.
double known(const Formula& formula, double t2) {
  try {
    return checked(formula, t2);
  } catch (const ShapeProblem& problem) {
    throw InputError("distribution", problem.what);
  }
}

/// f where the integrals may step over something: closely in ln t2, and in t2 around 1.
struct Samples : RadialSamples {
  explicit Samples(const Formula& formula) {
    density = [&formula](double t2) { return checked(formula, t2); };
    for (int k = -3000; k <= 3000; ++k) t2s.push_back(std::pow(10.0, k * 0.01));
    for (int k = 1; k <= 4000; ++k) t2s.push_back(k * 0.01);
    std::ranges::sort(t2s);
    t2s.erase(std::unique(t2s.begin(), t2s.end()), t2s.end()); // clang 14 cannot compile the one of ranges
    (void)checked(formula, 0);
    for (const double t2 : t2s) values.push_back(checked(formula, t2));
  }
  double mass_before(std::size_t k) const {
    return 0.5 * (mass_at(k - 1) + mass_at(k)) * std::log(t2s[k] / t2s[k - 1]);
  }
};

/// Where the mass per unit of ln t2 has its peaks, the `most` highest, and samples to both sides, each three times as
/// far as the one before, until nothing of the peak is left: a rule between two that are further apart might miss it.
std::vector<double> peaks(const Samples& samples, std::size_t most = 20) {
  const std::size_t size = samples.t2s.size();
  std::vector<std::size_t> found;
  for (std::size_t k = 1; k + 1 < size; ++k)
    if (samples.mass_at(k) > samples.mass_at(k - 1) && samples.mass_at(k) >= samples.mass_at(k + 1)) found.push_back(k);
  std::ranges::sort(found, std::greater{}, [&](std::size_t k) { return samples.mass_at(k); });
  if (found.size() > most) found.resize(most);
  std::vector<double> cuts;
  for (const std::size_t k : found) {
    const double left = 1e-17 * samples.mass_at(k);
    cuts.push_back(samples.t2s[k]);
    for (std::size_t at = k, step = 1; step < k && samples.mass_at(at) > left; step *= 3)
      cuts.push_back(samples.t2s[at = k - step]);
    for (std::size_t at = k, step = 1; k + step < size && samples.mass_at(at) > left; step *= 3)
      cuts.push_back(samples.t2s[at = k + step]);
  }
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// The norms at which an integral over slopes is to be cut; `sharp`: squared ones, at which f is not smooth.
std::vector<double> radii_of(const Samples& samples, const std::vector<double>& sharp) {
  std::vector<double> radii = cuts_between_scales(samples, sharp);
  radii.insert(radii.end(), sharp.begin(), sharp.end());
  constexpr std::size_t most = 64;
  if (radii.size() > most)
    throw ShapeProblem{"the shape has " + std::to_string(sharp.size()) + " jumps and corners, and " +
                       std::to_string(radii.size() - sharp.size()) +
                       " places where an integral would have to be cut besides; accepted: 64 of both"};
  for (double& r : radii) r = std::sqrt(r);
  std::ranges::sort(radii);
  return radii;
}

/// Integrals over slopes look around alpha.
void require_scale(const Samples& samples) {
  double whole = 0, sum = 0;
  for (std::size_t k = 1; k < samples.t2s.size(); ++k) whole += samples.mass_before(k);
  std::size_t median = 0;
  while (++median + 1 < samples.t2s.size() && sum < 0.5 * whole) sum += samples.mass_before(median);
  const double t2 = samples.t2s[median];
  if (!(t2 >= 1e-4 && t2 <= 1e4))
    throw ShapeProblem{"half of the shape is within t2 = " + format_number(std::pow(10, std::round(std::log10(t2)))) +
                       "; accepted: a number in [1e-04, 10000], and alpha for the scale"};
}

/// By which power f falls at last, f ~ t2^-power; infinite where nothing is left.
double falling_power(const Formula& formula) {
  const double near = checked(formula, 1e20), between = checked(formula, 1e25), last = checked(formula, far);
  if (last < smallest) return infinity;
  const double power = std::log(near / last) / std::log(1e10);
  const std::string falls =
      "the shape falls like t2^" + format_number(0.0 - std::round(power * 1e4) / 1e4) + " to infinity";
  if (power <= 1 + 1e-6) throw ShapeProblem{falls + ": its mass is infinite; accepted: faster than t2^-1.5"};
  if (power <= 1.5 + 1e-6) throw ShapeProblem{falls + ": its mean slope is infinite; accepted: faster than t2^-1.5"};
  // The slopes beyond 1e15 have the share 1e15^-(2 power - 3) of their mean, in a power that is uncertain by `drift`.
  const double excess = 2 * power - 3;
  const double drift = 2 * std::fabs(std::log(near / between) / std::log(1e5) - power) + 4e-15;
  if (std::exp(-excess * 0.5 * std::log(far)) * drift / excess > 3e-11)
    throw ShapeProblem{falls +
                       ", too slowly for its mean slope to be known to 1e-10; accepted: a power of t2 and faster "
                       "than t2^-1.5001"};
  return power;
}

/// int_0^inf f dt2, in x = ln t2.
double mass(const Formula& formula, const std::vector<double>& peaks, double power) {
  std::vector<double> cuts;
  for (int k = -80; k <= 69; ++k) cuts.push_back(k);
  for (const double t2 : peaks) cuts.push_back(std::log(t2));
  std::ranges::sort(cuts);
  cuts.push_back(std::log(far));
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  const auto integrand = [&](const double* x, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const double t2 = std::exp(x[k]);
      y[k] = t2 * checked(formula, t2);
    }
  };
  Estimate whole = integrate(integrand, cuts, {.relative = 1e-13}, 100000, Jumps::possible);
  if (power < infinity) whole.value += far * checked(formula, far) / (power - 1);
  if (!(whole.value >= 1e-50 && whole.value <= 1e50))
    throw ShapeProblem{whole.value == 0 ? "the shape is 0 wherever it was looked at"
                                        : "the integral of the shape: found " + format_number(whole.value) +
                                              ", accepted: a number in [1e-50, 1e+50]"};
  if (!(whole.error <= 1e-10 * whole.value))
    throw ShapeProblem{"the integral of the shape is uncertain by " + format_number(whole.error / whole.value) +
                       " of itself (accepted: 1e-10)"};
  return whole.value;
}

CustomShape make(const Formula& formula, bool normalised) {
  CustomShape::Tail tail;
  DensityHints hints;
  const Samples samples(formula);
  const std::vector<double> sharp = jumps_and_corners(samples);
  std::vector<double> radii = radii_of(samples, sharp);
  hints.cuts = peaks(samples);
  hints.cuts.insert(hints.cuts.end(), sharp.begin(), sharp.end());
  std::ranges::sort(hints.cuts);
  hints.power = tail.power = falling_power(formula);
  const double whole = mass(formula, hints.cuts, tail.power);
  const double scale = normalised ? std::numbers::inv_pi / whole : 1;
  require_scale(samples);
  tail.log_density = std::log(scale * checked(formula, far));
  const auto log_density = [=](double t2) {
    if (t2 > far) return tail.at(std::log(t2));
    const double f = known(formula, t2);
    return f < smallest ? -infinity : std::log(scale * f);
  };
  return {formula, scale, tail, std::move(radii), ALambdaTable(log_density, hints)};
}

} // namespace

ModelSpec CustomShape::about() {
  return {.type = "custom",
          .doc = "a shape of your own: a formula of t2, the squared slope over alpha^2, and of its root t",
          .source = "Heitz 2014, Eqs. 73, 87; Akenine-Moller et al. 2018, Eqs. 9.36, 9.49-9.50; normalised and Lambda "
                    "by quadrature",
          .parameters = {
              {.key = "shape",
               .kind = ParameterKind::formula,
               .doc = "density of slopes up to a factor, such as exp(-t2): finite from t2 = 0 on, not "
                      "negative, falling faster than t2^-1.5, with up to 64 jumps, corners and changes of scale, "
                      "none of them narrower than a hundredth of t2; values below 1e-290 count as 0 in Lambda",
               .choices = variables()},
              {.key = "normalised",
               .kind = ParameterKind::boolean,
               .fallback = true,
               .doc = "whether the density is the shape over its integral, or at alpha = 1 the shape itself: "
                      "D cos^4 with t2 = tan^2, which has to have the integral 1"}}};
}

Made<CustomShape> CustomShape::from(const Values& values) {
  const std::string text = values.text("shape");
  try {
    const bool normalised = values.flag("normalised");
    return remembered<CustomShape>((normalised ? "" : "as written: ") + text,
                                   [&] { return make(Formula(text, variables()), normalised); });
  } catch (const ShapeProblem& problem) {
    return ParameterError{"shape", problem.what};
  }
}

double CustomShape::Tail::at(double log_t2) const {
  return power < infinity ? log_density - power * (log_t2 - std::log(far)) : -infinity;
}

double CustomShape::density(double t2) const {
  return t2 > far ? std::exp(tail.at(std::log(t2))) : scale * known(formula, t2);
}

double CustomShape::scaled_density(double n2, double z2) const {
  const double z2_above = std::max(z2, 1e-300);
  const double log_t2 = std::log(n2) - std::log(z2_above);
  if (log_t2 > std::log(far)) return std::exp(tail.at(log_t2) - 2 * std::log(z2_above));
  return density(n2 / z2_above) / z2_above / z2_above;
}

} // namespace brdfplot
