#include "analysis/fit/form.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

/// Products in (1 - x)^power, power in {1, 2, 3, 4, 6, 8}: u, u^2, u^2 u, (u^2)^2, (u^2 u)^2, ((u^2)^2)^2.
int products_of_power(int power) { return power <= 2 ? power - 1 : power <= 4 ? 2 : 3; }

int horner(std::size_t dx, std::size_t dy) { return static_cast<int>(dx + (dx + 1) * dy); }

} // namespace

double RationalForm::x(double a) const { return cut ? std::min(a / scale, 1.0) : a / (scale + a); }

double RationalForm::vanishing(double a) const {
  return std::pow(cut ? std::max(1 - a / scale, 0.0) : scale / (scale + a), power);
}

FitCost cost_of(const RationalForm& form) {
  // k = scale s + tiny; r = max(c, k) or c + k; 1 / r; x = c / r; 1 - x = (r - c) / r or k / r
  FitCost cost{form.cut ? 5 : 4, 1};
  cost.operations += products_of_power(form.power);
  if (form.nx + form.ny > 0) cost.operations += 1 + horner(form.nx, form.ny);
  cost.operations += 1 + horner(form.mx, form.my); // x m
  cost.operations += 1;                            // the sum
  cost.divisions += 1;
  return cost;
}

double LambdaFit::lambda(double a, double y) const {
  const double x = form.x(a);
  return form.vanishing(a) * n(x, y) / (x * m(x, y));
}

double LambdaFit::relative_error(double a, double y, double truth) const {
  const double x = form.x(a);
  const double numerator = form.vanishing(a) * n(x, y);
  const double denominator = x * m(x, y);
  return (denominator * truth - numerator) / (denominator + numerator);
}

Polynomial LambdaFit::scaled_slope() const {
  // -Lambda' (x m)^2 / (1 - x)^(power - 1), by x.
  const Polynomial x{1, 0, {0, 1}};
  const Polynomial rest{1, 0, {1, -1}};
  const Polynomial xm = x * m;
  return add(rest * add(n * derivative_x(xm), derivative_x(n) * xm, -1), n * xm, form.power);
}

bool LambdaFit::proved_sound() const {
  return proved_positive(n) && proved_positive(m) && proved_positive(scaled_slope());
}

} // namespace brdfplot
