#include "analysis/written_density.hpp"

#include "base/echo.hpp"
#include "base/errors.hpp"

#include <array>
#include <cmath>

namespace brdfplot {

namespace {

const std::vector<std::string>& variables() {
  static const std::vector<std::string> names = {"pdf", "x_o", "y_o",     "z_o",     "theta_o", "phi_o",
                                                 "x_i", "y_i", "z_i",     "theta_i", "phi_i",   "x_h",
                                                 "y_h", "z_h", "theta_h", "phi_h",   "o_h"};
  return names;
}

/// A formula, or the error that names what it may use.
Formula formula_of(const std::string& text, const std::string& where) {
  const auto wrong = Formula::problem(text, variables());
  if (!wrong) return {text, variables()};
  std::vector<std::string> accepted = variables();
  for (const std::string& name : names_in_formulas()) accepted.push_back(name);
  throw InputError(where, "formula \"" + echo(text) + "\": " +
                              (wrong->unknown.empty() ? wrong->what : unknown_name("name", wrong->unknown, accepted)));
}

double theta_of(const Direction& d) { return std::atan2(std::hypot(d.x, d.y), d.z); }
double phi_of(const Direction& d) { return std::atan2(d.y, d.x); }

} // namespace

WrittenDensity::WrittenDensity(const Sampler& sampler, const std::string& text, const std::string& where)
    : sampler_(&sampler), formula_(formula_of(text, where)) {}

void WrittenDensity::operator()(std::size_t n, const Columns& omega_o, const Columns& omega_i, double* out) const {
  sampler_->densities(n, omega_o, omega_i, out);
  for (std::size_t k = 0; k < n; ++k) {
    const Direction o = omega_o[k], i = omega_i[k], h = half_vector(o, i);
    if (dot(h, h) == 0) {
      out[k] = 0;
      continue;
    }
    const std::array<double, 17> values = {out[k], o.x, o.y,         o.z,         theta_of(o), phi_of(o),
                                           i.x,    i.y, i.z,         theta_of(i), phi_of(i),   h.x,
                                           h.y,    h.z, theta_of(h), phi_of(h),   dot(o, h)};
    out[k] = formula_(values);
  }
}

} // namespace brdfplot
