#include "microfacet/masking/custom.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brdfplot {

namespace {

const std::vector<std::string>& variables_of_lambda() {
  static const std::vector<std::string> names = {"theta", "phi",     "cos_theta", "tan_theta",  "a",
                                                 "alpha", "alpha_x", "alpha_y",   "correlation"};
  return names;
}

const std::vector<std::string>& variables_of_g1() {
  static const std::vector<std::string> names = [] {
    auto all = variables_of_lambda();
    for (const char* name : {"theta_m", "phi_m", "cos_theta_m", "o_dot_m"}) all.emplace_back(name);
    return all;
  }();
  return names;
}

/// The direction as the mesosurface sees it: after the shear that levels it (Heitz 2014, section 5.5), theta is its
/// angle to the normal. alpha is alpha_o of Eq. 80, and a = 1 / (alpha tan theta); at the normal, where tan theta = 0,
/// a is infinite.
std::array<double, 9> values_of(const SlopeMap& map, const Projection& p, const Direction& omega) {
  const double across = std::hypot(omega.x, omega.y);
  const double y = omega.y + 0.0; // of y = -0 atan2 would make -pi where x < 0
  const double tan_theta = across / p.c;
  return {std::atan2(across, p.c),
          across > 0 ? std::atan2(y, omega.x) : 0,
          p.c / std::hypot(across, p.c),
          tan_theta,
          p.s > 0 ? p.c / p.s : infinity,
          across > 0 ? p.s / across : map.alpha_x,
          map.alpha_x,
          map.alpha_y,
          map.correlation};
}

double number_or_throw(const Formula& formula, double value, const std::array<double, 9>& at) {
  if (std::isnan(value))
    throw InputError("masking", "the formula \"" + echo(formula.text()) + "\" is not a number at theta = " +
                                    format_number(at[0]) + ", phi = " + format_number(at[1]));
  return value;
}

} // namespace

ModelSpec CustomMasking::spec() {
  return {.type = "custom",
          .doc =
              "a formula of your own, to see what `check` says of it: Lambda, or G1 of facing normals, of the masked "
              "direction (theta, phi; alpha is its projected roughness, a = 1 / (alpha tan theta)) and, for G1, of "
              "the normal",
          .source = "Heitz 2014, Eqs. 43, 80, 86; Akenine-Moller et al. 2018, Eqs. 9.37, 9.51",
          .parameters = {{.key = "lambda",
                          .kind = ParameterKind::formula,
                          .doc = "Lambda of the masked direction",
                          .choices = variables_of_lambda()},
                         {.key = "g1",
                          .kind = ParameterKind::formula,
                          .doc = "G1 of the masked direction and the normal",
                          .choices = variables_of_g1()}},
          .alternatives = {{"lambda"}, {"g1"}}};
}

CustomMasking CustomMasking::from(const Values& values) {
  CustomMasking masking;
  if (values.has("lambda")) masking.lambda.emplace(values.text("lambda"), variables_of_lambda());
  if (values.has("g1")) masking.g1.emplace(values.text("g1"), variables_of_g1());
  masking.has_lambda = masking.lambda.has_value();
  return masking;
}

double CustomMasking::masked_area(const SlopeMap& map, const Projection& p, const Direction& omega) const {
  const auto values = values_of(map, p, omega);
  return p.c * number_or_throw(*lambda, (*lambda)(values), values);
}

double CustomMasking::unmasked_area(const SlopeMap& map, const Projection& p, const Direction& omega,
                                    const Direction& omega_m, double o_dot_m) const {
  const auto values = values_of(map, p, omega);
  std::array<double, 13> all{};
  std::copy(values.begin(), values.end(), all.begin());
  const double across = std::hypot(omega_m.x, omega_m.y);
  all[9] = std::atan2(across, omega_m.z);
  all[10] = across > 0 ? std::atan2(omega_m.y + 0.0, omega_m.x) : 0;
  all[11] = omega_m.z;
  all[12] = o_dot_m;
  return p.c / number_or_throw(*g1, (*g1)(all), values);
}

} // namespace brdfplot
