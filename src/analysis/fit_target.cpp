#include "analysis/fit_target.hpp"

#include "brdf/evaluate.hpp"
#include "math/errors.hpp"
#include "math/number.hpp"
#include "math/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

struct Swept {
  std::string type;
  FitParameter parameter;
  FitAlpha alpha;
};

/// The ends of y, 0 and 1, are those of the domain.
std::optional<Swept> swept_parameter(const std::string& type) {
  const std::vector<Swept> all = {
      {"phong", {"exponent", 0, infinity, true, 2, 0, 2}, FitAlpha::root_of_y},
      {"gtr", {"alpha", 0.05, 1, false, 0, -0.05 / 0.95, 1 / 0.95}, FitAlpha::parameter},
      {"student_t", {"gamma", 1.75, infinity, true, -1, 0, 0.75}, FitAlpha::argument},
  };
  const auto found = std::ranges::find(all, type, &Swept::type);
  return found == all.end() ? std::nullopt : std::optional<Swept>(*found);
}

/// Lambda at a = cot theta / alpha in the plane of the x axis.
double lambda_of(const Material& material, double a) {
  const double cot_theta = a * material.slopes().alpha_x;
  const double norm = std::hypot(1.0, cot_theta);
  const double lambda =
      evaluate(material, Quantity::lambda, Direction{1 / norm, 0, cot_theta / norm}, std::nullopt, std::nullopt);
  if (!is_told(Quantity::lambda, lambda))
    throw AccuracyError(material.name, "\"lambda\": found " + format_number(lambda) + " at a = " + format_number(a));
  return lambda;
}

Material unit_material(const MaterialDescription& description, bool shape_invariant) {
  Material material = build(description);
  if (shape_invariant) std::visit([](auto& d) { d.slopes = SlopeMap{}; }, material.distribution);
  return material;
}

void require_isotropic(const Material& material, const std::string& where) {
  const SlopeMap& slopes = material.slopes();
  if (slopes.centred() && slopes.alpha_x == slopes.alpha_y && slopes.correlation == 0) return;
  throw InputError(where + ": /distribution", "its Lambda depends on the azimuth by more than a roughness; accepted: "
                                              "isotropic ones, and shape-invariant ones of any anisotropy");
}

/// Where Lambda is 1, about: the a around which samples are spread.
double middle(const std::function<double(double)>& lambda) {
  double low = 1e-9;
  double high = 1e9;
  for (int step = 0; step < 60; ++step) {
    const double a = std::sqrt(low * high);
    (lambda(a) > 1 ? low : high) = a;
  }
  return std::sqrt(low * high);
}

/// The numbers and formulas among the given parameters that are no arguments of the fit.
std::string constants_of(const ModelChoice& distribution, const FitTarget& target) {
  const std::vector<std::string> of_slopes = {"alpha",       "alpha_x",           "alpha_y",
                                              "roughness",   "disney_anisotropy", "imageworks_anisotropy",
                                              "correlation", "mean_slope"};
  std::string out;
  for (const auto& [key, value] : distribution.values.map()) {
    if (target.parameter && (target.parameter->key == key || target.alpha == FitAlpha::root_of_y)) continue;
    if (target.alpha == FitAlpha::argument && std::ranges::find(of_slopes, key) != of_slopes.end()) continue;
    const double* number = std::get_if<double>(&value);
    const std::string* text = std::get_if<std::string>(&value);
    if (number || text) out += (out.empty() ? "" : ", ") + key + " = " + (number ? format_number(*number) : *text);
  }
  return out;
}

} // namespace

double FitParameter::y(double value) const { return offset + factor * (reciprocal ? 1 / (value + shift) : value); }

double FitParameter::value(double y) const {
  const double q = (y - offset) / factor;
  if (!reciprocal) return std::clamp(q, from, to);
  // The limit at infinity is approached like 1 / parameter: this near to it, the difference is no more seen.
  constexpr double largest = 1e7;
  return std::clamp(q > 0 ? 1 / q - shift : largest, from, std::min(to, largest));
}

FitTarget fit_target(const MaterialDescription& description, bool fixed) {
  FitTarget target{.name = description.name,
                   .type = description.distribution.type,
                   .masking = description.masking.type,
                   .lambda_at = {}};
  const Material given = build(description);
  if (!given.has_lambda())
    throw InputError(description.name + ": /masking/type",
                     "found \"" + target.masking + "\", which has no Lambda; accepted: a masking function that has");
  const bool shape_invariant = std::visit([](const auto& d) { return d.shape_invariant; }, given.distribution);
  if (!shape_invariant) require_isotropic(given, description.name);
  const auto swept = fixed ? std::nullopt : swept_parameter(target.type);
  if (swept) {
    target.parameter = swept->parameter;
    target.alpha = swept->alpha;
    target.constants = constants_of(description.distribution, target);
    target.lambda_at = [description, shape_invariant, parameter = swept->parameter](double y) {
      MaterialDescription changed = description;
      set_parameter(changed, parameter.key, parameter.value(y));
      return [material = unit_material(changed, shape_invariant)](double a) { return lambda_of(material, a); };
    };
    return target;
  }
  const Material material = unit_material(description, shape_invariant);
  target.alpha = shape_invariant ? FitAlpha::argument : FitAlpha::constant;
  target.alpha_value = material.slopes().alpha_x;
  target.constants = constants_of(description.distribution, target);
  target.lambda_at = [material](double) { return [material](double a) { return lambda_of(material, a); }; };
  return target;
}

FitSamples sample(const FitTarget& target, std::size_t per_line, std::size_t lines, int threads) {
  const double unit = middle(target.lambda_at(0.5));
  FitSamples out{per_line, std::vector<FitSample>(per_line * lines)};
  const auto place = [](double k, double n) { return 0.5 - 0.5 * std::cos(std::numbers::pi * k / n); };
  parallel_for(lines, threads, [&](std::size_t line) {
    const double y = lines > 1 ? place(static_cast<double>(line), static_cast<double>(lines - 1)) : 0;
    const auto lambda = target.lambda_at(y);
    for (std::size_t i = 0; i < per_line; ++i) {
      const double t = place(static_cast<double>(i) + 0.5, static_cast<double>(per_line));
      const double a = unit * t / (1 - t);
      out.samples[line * per_line + i] = {a, y, lambda(a)};
    }
  });
  return out;
}

} // namespace brdfplot
