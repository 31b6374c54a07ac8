#include "analysis/fit/code.hpp"
#include "base/number.hpp"

#include <cmath>
#include <cstdio>

namespace brdfplot {

namespace {

std::string rounded_text(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// Three digits that are not below the value, for a bound.
std::string bound_text(double bound) {
  if (!(bound > 0 && std::isfinite(bound))) return rounded_text(bound, 3);
  const double unit = std::pow(10, std::floor(std::log10(bound)) - 2);
  return rounded_text(std::ceil(bound / unit * (1 - 1e-12)) * unit, 3);
}

std::string polynomial_text(char name, bool two) { return std::string(1, name) + (two ? "(x, y)" : "(x)"); }

std::string formula(const FitResult& result) {
  const RationalForm& form = result.fit.form;
  const bool two = result.target.parameter.has_value();
  const std::string scale = shortest_digits(form.scale, result.single);
  std::string text = "Lambda = (1 - x)";
  if (form.power > 1) text += "^" + std::to_string(form.power);
  if (form.nx + form.ny > 0) text += " " + polynomial_text('n', two);
  text += " / (x " + polynomial_text('m', two) + "), x = ";
  return text + (form.cut ? "min(a / " + scale + ", 1)" : "a / (a + " + scale + ")");
}

std::string degree(std::size_t in_x, std::size_t in_y, bool two) {
  return std::to_string(in_x) + (two ? " in x and " + std::to_string(in_y) + " in y" : "");
}

std::string variables(const FitTarget& target) {
  std::string text = "a = cot(theta)";
  if (target.alpha != FitAlpha::constant) text += " / alpha";
  if (!target.by_cosine()) text = "a = c / s, of a direction by " + fit_identifier(target.name) + "_project";
  if (target.alpha == FitAlpha::constant && target.alpha_value != 1) text += " / " + format_number(target.alpha_value);
  if (target.alpha == FitAlpha::root_of_y) text += ", alpha = sqrt(y)";
  if (!target.parameter) return text;
  const FitParameter& p = *target.parameter;
  text += ", y = " + (p.offset != 0 ? rounded_text(p.offset, 9) + " + " : "") + rounded_text(p.factor, 9) +
          (p.reciprocal ? " / (" + p.key + (p.shift < 0 ? " - " : " + ") + format_number(std::abs(p.shift)) + ")"
                        : " " + p.key);
  return text;
}

std::string domain(const FitTarget& target) {
  std::string text = target.by_cosine() ? "cos(theta) 0 or in [1e-12, 1]" : "unit vectors with c 0 or above 1e-12";
  if (target.alpha == FitAlpha::argument)
    text += target.by_cosine() ? ", alpha in [1e-06, 1e+06]" : ", alpha_x and alpha_y in [1e-06, 1e+06]";
  return text + (target.parameter ? ", " + target.parameter->domain() : "");
}

std::string place(const FitTarget& target, const FitSample& at) {
  std::string text = "a = " + rounded_text(at.a, 3);
  if (const auto& p = target.parameter) text += ", " + p->key + " = " + rounded_text(p->value(at.y), 3);
  return text;
}

/// Of the form of shadowing, in those of G1, as d ln G2 <= |d ln G1(o)| + |d ln G1(i)|; and four roundings.
double error_of_g2(const FitTarget& target, const FitAccuracy& accuracy, double unit) {
  const bool one = target.shadowing == "none" || target.shadowing == "minimum";
  return (one ? 1 : 2) * accuracy.relative.error + (one ? 0 : 12 * unit);
}

std::string accuracy_line(const FitTarget& target, const FitAccuracy& accuracy, bool single, double tolerance) {
  const double unit = single ? 0x1p-24 : 0x1p-53;
  std::string text = std::string("in ") + (single ? "float: " : "double: ") + "G1 within a relative " +
                     bound_text(accuracy.relative.error) + (target.slopes.centred() ? "" : " from c and s on") +
                     ", at " + place(target, accuracy.relative.where);
  if (accuracy.relative.error > tolerance) text += ", above what was asked: sure in double alone";
  return text + "; absolute " + bound_text(accuracy.absolute) + "; Lambda within " + bound_text(accuracy.lambda) +
         " where it is 0.01 or more; G2 within " + bound_text(error_of_g2(target, accuracy, unit)) +
         (target.factor.empty() ? "" : ", beside the error of phi");
}

} // namespace

std::string fit_identifier(const std::string& name) {
  std::string out;
  for (const char letter : name) {
    const bool upper = letter >= 'A' && letter <= 'Z';
    const bool kept = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || upper;
    if (kept)
      out += upper ? static_cast<char>(letter - 'A' + 'a') : letter;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  while (out.ends_with('_')) out.pop_back();
  return out.empty() || (out[0] >= '0' && out[0] <= '9') ? "material_" + out : out;
}

std::vector<std::string> describe(const FitResult& result, double tolerance) {
  const FitTarget& target = result.target;
  const RationalForm& form = result.fit.form;
  const FitCost cost = cost_of(form);
  const bool two = target.parameter.has_value();
  std::vector<std::string> lines = {target.name + ": distribution " + target.type +
                                        (target.constants.empty() ? "" : " (" + target.constants + ")") + ", masking " +
                                        target.masking + ", shadowing " + target.shadowing +
                                        (target.factor.empty() ? "" : " (" + target.factor + ")"),
                                    formula(result), variables(target), "domain: " + domain(target)};
  std::string degrees = "degree: ";
  if (form.nx + form.ny > 0) degrees += "n " + degree(form.nx, form.ny, two) + ", ";
  lines.push_back(degrees + "m " + degree(form.mx, form.my, two) +
                  (result.single ? "; coefficients are floats" : "; coefficients need double precision"));
  lines.push_back("asked: G1 within a relative " + format_number(tolerance));
  lines.push_back(accuracy_line(target, result.in_double, false, tolerance));
  lines.push_back(accuracy_line(target, result.in_float, true, tolerance));
  lines.emplace_back("proved, in exact arithmetic: no pole, G1 in [0, 1] and increasing with " +
                     std::string(target.slopes.centred() ? "cos(theta)" : "a"));
  if (result.in_float.in_range)
    lines.push_back("in float: G1 in [0, 1]; from one direction to the next, rounding lets it fall by less than " +
                    bound_text(2 * result.in_float.rounding) + " of itself");
  lines.push_back(
      "cost of G1: " + std::to_string(cost.operations) + " multiply-adds and " + std::to_string(cost.divisions) +
      " divisions, from " +
      (target.by_cosine()
           ? "cos(theta) and " + std::string(target.alpha == FitAlpha::constant ? "sin(theta)" : "alpha sin(theta)")
           : "c and s") +
      " on");
  if (target.closed_form()) lines.emplace_back("exact: Lambda = (sqrt(1 + 1 / a^2) - 1) / 2, at one square root");
  return lines;
}

} // namespace brdfplot
