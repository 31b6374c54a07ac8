#include "analysis/fit_code.hpp"

#include "math/number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace brdfplot {

namespace {

std::string rounded_text(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// The shortest digits of a double, or of a float.
std::string digits(double value, bool single) {
  if (!single) return format_number(value);
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(value)).ptr;
  return {text, end};
}

/// Writes what differs between the languages.
class Writer {
public:
  Writer(const FitResult& result, FitLanguage language)
      : result_(result), language_(language), name_(fit_identifier(result.target.name)) {}

  std::string functions() {
    terms();
    function("lambda", "Smith's Lambda; 1e30 or more at grazing and below the horizon.", 1,
             {"return n / " + max("d", number(1e-30)) + ";"});
    function("g1", "Smith's masking function G1 = 1 / (1 + Lambda).", 1, {"return d / (d + n);"});
    function(
        "g2", "Height-correlated masking and shadowing G2 = 1 / (1 + Lambda_o + Lambda_i) (Heitz 2014, Eq. 99).", 2,
        {real() + " both = d_o * d_i;", "return both / " + max("both + n_o * d_i + n_i * d_o", number(1e-30)) + ";"});
    return out_;
  }

private:
  bool cpp() const { return language_ == FitLanguage::cpp; }
  std::string real() const { return cpp() ? "Real" : "float"; }
  std::string local() const { return cpp() ? "const Real" : "float"; }
  std::string parameter(const std::string& name) const { return real() + " " + name; }
  std::string output(const std::string& name) const { return cpp() ? "Real& " + name : "out float " + name; }
  std::string max(const std::string& a, const std::string& b) const {
    return (cpp() ? "std::max(" : "max(") + a + ", " + b + ")";
  }
  std::string sqrt(const std::string& x) const { return (cpp() ? "std::sqrt(" : "sqrt(") + x + ")"; }
  std::string number(double value) const {
    std::string text = digits(value, result_.single);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return cpp() ? "Real(" + text + ")" : text;
  }

  void line(const std::string& text) { out_ += text + "\n"; }
  void head(const std::string& signature) {
    if (cpp()) line("template <class Real>");
    line((cpp() ? "inline " : "") + signature + " {");
  }

  bool has_y() const { return result_.target.parameter.has_value(); }

  /// c0 + x * (c1 + x * c2), of texts.
  static std::string horner(const std::vector<std::string>& c, const std::string& x) {
    std::string text = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;)
      text = c[k] + " + " + x + " * " + (k + 2 == c.size() ? text : "(" + text + ")");
    return text;
  }

  /// The coefficients of the powers of x: numbers, or variables that are polynomials of y.
  std::vector<std::string> coefficients(const Polynomial& p, const std::string& variable) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i <= p.dx; ++i) {
      std::vector<std::string> of_y;
      for (std::size_t j = 0; j <= p.dy; ++j) of_y.push_back(number(p.at(i, j)));
      if (p.dy == 0) {
        out.push_back(of_y[0]);
        continue;
      }
      out.push_back(variable + std::to_string(i));
      line("  " + local() + " " + out.back() + " = " + horner(of_y, "y") + ";");
    }
    return out;
  }

  void power_of_u() {
    const int power = result_.fit.form.power;
    const std::string cube_or_square = power == 6 ? "u * u * u" : "u * u";
    if (power <= 3) line(power == 1 ? "  n = u;" : power == 2 ? "  n = u * u;" : "  n = u * u * u;");
    if (power <= 3) return;
    line("  " + local() + " v = " + cube_or_square + ";");
    if (power == 8) line("  " + local() + " w = v * v;");
    line(power == 8 ? "  n = w * w;" : "  n = v * v;");
  }

  void terms() {
    const RationalForm& form = result_.fit.form;
    const FitTarget& target = result_.target;
    const double scale = form.scale * (target.alpha == FitAlpha::constant ? target.alpha_value : 1);
    const std::string roughness = target.alpha == FitAlpha::constant ? "sin(theta)" : "alpha sin(theta)";
    line("// Lambda = n / d from c = cos(theta) and s = " + roughness + ", or both times the same positive factor" +
         (has_y() ? ";" : "."));
    if (target.alpha == FitAlpha::argument)
      line("// anisotropic: c = z, s = length(alpha_x x, alpha_y y) of a vector of any length" +
           std::string(has_y() ? ";" : "."));
    if (has_y()) line("// y in [0, 1] as below.");
    head("void " + name_ + "_terms(" + parameter("c") + ", " + parameter("s") + ", " +
         (has_y() ? parameter("y") + ", " : "") + output("n") + ", " + output("d") + ")");
    const std::string reach = number(scale) + " * s + " + number(1e-30);
    line("  " + local() + " r = " + (form.cut ? max("c", reach) : "c + (" + reach + ")") + ";");
    line("  " + local() + " q = " + number(1) + " / r;");
    line("  " + local() + " x = c * q;");
    line("  " + local() + " u = (r - c) * q;");
    power_of_u();
    if (form.nx + form.ny > 0) {
      const auto c = coefficients(result_.fit.n, "n");
      line("  n *= " + horner(c, "x") + ";");
    }
    const auto c = coefficients(result_.fit.m, "m");
    line("  d = x * " + (c.size() > 1 ? "(" + horner(c, "x") + ")" : c[0]) + ";");
    line("}\n");
  }

  /// The arguments beside the cosines.
  std::vector<std::string> arguments() const {
    std::vector<std::string> names;
    const FitTarget& target = result_.target;
    if (target.alpha == FitAlpha::argument) names.emplace_back("alpha");
    if (target.parameter) names.push_back(target.parameter->key);
    return names;
  }

  void set_y() {
    const FitParameter& p = *result_.target.parameter;
    const std::string q = p.reciprocal ? number(p.factor) + " / (" + p.key + " + " + number(p.shift) + ")"
                                       : number(p.factor) + " * " + p.key;
    const std::string y = p.offset != 0 ? number(p.offset) + " + " + q : q;
    line("  " + local() + " y = " + (cpp() ? "std::clamp<Real>(" : "clamp(") + y + ", " + number(0) + ", " + number(1) +
         ");");
  }

  void function(const std::string& what, const std::string& doc, int cosines, const std::vector<std::string>& body) {
    const FitTarget& target = result_.target;
    std::string signature = real() + " " + name_ + "_" + what + "(";
    const std::vector<std::string> ends =
        cosines == 1 ? std::vector<std::string>{""} : std::vector<std::string>{"_o", "_i"};
    for (const auto& end : ends) signature += (end == "_i" ? ", " : "") + parameter("cos_theta" + end);
    for (const auto& argument : arguments()) signature += ", " + parameter(argument);
    line("// " + doc);
    head(signature + ")");
    if (has_y()) set_y();
    for (const auto& end : ends) {
      const std::string c = "c" + end;
      line("  " + local() + " " + c + " = " + max("cos_theta" + end, number(0)) + ";");
      const std::string sin = sqrt(max(number(1) + " - " + c + " * " + c, number(0)));
      const std::string alpha = target.alpha == FitAlpha::constant    ? ""
                                : target.alpha == FitAlpha::root_of_y ? sqrt("y") + " * "
                                                                      : "alpha * ";
      line("  " + real() + " n" + end + ";");
      line("  " + real() + " d" + end + ";");
      line("  " + name_ + "_terms(" + c + ", " + alpha + sin + ", " + (has_y() ? "y, " : "") + "n" + end + ", d" + end +
           ");");
    }
    for (const auto& text : body) line("  " + text);
    line("}\n");
  }

  const FitResult& result_;
  FitLanguage language_;
  std::string name_;
  std::string out_;
};

std::string polynomial_text(char name, bool two) { return std::string(1, name) + (two ? "(x, y)" : "(x)"); }

std::string formula(const FitResult& result) {
  const RationalForm& form = result.fit.form;
  const bool two = result.target.parameter.has_value();
  const std::string scale = digits(form.scale, result.single);
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
  std::string text = "cos(theta) in [0, 1]";
  if (target.alpha == FitAlpha::argument) text += ", alpha > 0";
  if (!target.parameter) return text;
  const FitParameter& p = *target.parameter;
  return text + ", " + p.key +
         (p.to < infinity ? " in [" + format_number(p.from) + ", " + format_number(p.to) + "]"
                          : " >= " + format_number(p.from));
}

std::string place(const FitResult& result) {
  const FitSample& at = result.relative.where;
  std::string text = "a = " + rounded_text(at.a, 3);
  if (const auto& p = result.target.parameter) text += ", " + p->key + " = " + rounded_text(p->value(at.y), 3);
  return text;
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
                                        target.masking,
                                    formula(result), variables(target), "domain: " + domain(target)};
  std::string degrees = "degree: ";
  if (form.nx + form.ny > 0) degrees += "n " + degree(form.nx, form.ny, two) + ", ";
  lines.push_back(degrees + "m " + degree(form.mx, form.my, two) +
                  (result.single ? "; coefficients are floats" : "; coefficients need double precision"));
  lines.push_back("G1: relative error " + rounded_text(result.relative.error, 3) + " at " + place(result) +
                  " (asked: " + format_number(tolerance) + "), absolute error " + rounded_text(result.absolute, 3));
  lines.push_back("Lambda: relative error " + rounded_text(result.lambda_error, 3) + " where Lambda >= 0.01");
  lines.emplace_back("proved: no pole, G1 in [0, 1] and increasing with cos(theta)");
  lines.push_back("cost of G1: " + std::to_string(cost.operations) + " multiply-adds and " +
                  std::to_string(cost.divisions) + " divisions, from cos(theta) and " +
                  (target.alpha == FitAlpha::constant ? "sin(theta)" : "alpha sin(theta)") + " on");
  if (target.closed_form()) lines.emplace_back("exact: Lambda = (sqrt(1 + 1 / a^2) - 1) / 2, at one square root");
  return lines;
}

std::string fit_code(const FitResult& result, double tolerance, FitLanguage language) {
  std::string out;
  for (const auto& line : describe(result, tolerance)) out += "// " + line + "\n";
  out += "// A rational fit of Smith's masking, made by brdfplot. Below the horizon G1 and G2 are 0.\n";
  if (result.target.parameter)
    out += "// Beyond its domain, " + result.target.parameter->key + " counts as at its end.\n";
  if (language == FitLanguage::cpp) out += "#pragma once\n\n#include <algorithm>\n#include <cmath>\n";
  out += "\n" + Writer(result, language).functions();
  out.pop_back();
  return out;
}

} // namespace brdfplot
