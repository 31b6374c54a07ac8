#include "analysis/fit/code.hpp"

#include "analysis/fit/dialect.hpp"

#include <cmath>

namespace brdfplot {

namespace {

/// Writes the functions one after the other.
class Writer : private FitDialect {
public:
  Writer(const FitResult& result, FitLanguage language)
      : FitDialect(language), result_(result), target_(result.target), name_(fit_identifier(result.target.name)) {}

  std::string functions() {
    terms();
    const bool vectors = !target_.by_cosine();
    if (vectors) project();
    if (!vectors || target_.slopes.centred()) masking(false);
    if (vectors) masking(true);
    shadowing(vectors);
    return out_;
  }

private:
  std::string coefficient(double value) const { return literal(shortest_digits(value, result_.single)); }

  void line(const std::string& text) { out_ += text + "\n"; }
  void head(const std::string& signature) {
    if (cpp()) line("template <class Real>");
    line((cpp() ? "inline " : "") + signature + " {");
  }

  bool has_y() const { return target_.parameter.has_value(); }

  /// c0 + t * (c1 + t * c2), of texts.
  static std::string horner(const Texts& c, const std::string& t) {
    std::string text = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;)
      text = c[k] + " + " + t + " * " + (k + 2 == c.size() ? text : "(" + text + ")");
    return text;
  }

  /// A polynomial; where it has powers of y, its coefficients are variables of which that is the beginning of the name.
  std::string polynomial(const CodePolynomial& p, const std::string& variable) {
    Texts coefficients;
    for (std::size_t i = 0; i <= p.of.dx; ++i) {
      Texts of_y;
      for (std::size_t j = 0; j <= p.of.dy; ++j) of_y.push_back(coefficient(p.of.at(i, j)));
      if (p.of.dy == 0) {
        coefficients.push_back(of_y[0]);
        continue;
      }
      coefficients.push_back(variable + std::to_string(i));
      line(local(coefficients.back()) + horner(of_y, "y") + ";");
    }
    return horner(coefficients, p.in_u ? "u" : "x");
  }

  void power_of_u() {
    const int power = result_.code.power;
    if (power <= 3) return line(power == 1 ? "  n = u;" : power == 2 ? "  n = u * u;" : "  n = u * u * u;");
    line(local("v") + (power == 6 ? "u * u * u;" : "u * u;"));
    if (power == 8) line(local("w") + "v * v;");
    line(power == 8 ? "  n = w * w;" : "  n = v * v;");
  }

  void terms() {
    const FitCode& code = result_.code;
    const std::string s = target_.alpha == FitAlpha::constant ? "sin(theta)" : "alpha sin(theta)";
    line("// Lambda = n / d from " +
         (target_.by_cosine() ? "c = cos(theta) and s = " + s + ", both >= 0" : "c and s of " + name_ + "_project") +
         (has_y() ? ", and y in [0, 1] as above." : "."));
    head("void " + name_ + "_terms(" + real() + " c, " + real() + " s, " + (has_y() ? real() + " y, " : "") +
         output("n") + ", " + output("d") + ")");
    line(local("k") + coefficient(code.scale) + " * s + " + number(code_tiny) + ";");
    line(local("r") + (code.cut ? max("c", "k") : "c + k") + ";");
    line(local("q") + number(1) + " / r;");
    line(local("x") + "c * q;");
    line(local("u") + (code.cut ? "(r - c) * q;" : "k * q;"));
    power_of_u();
    if (code.n.of.dx + code.n.of.dy > 0) line("  n *= " + polynomial(code.n, "n") + ";");
    const std::string m = polynomial(code.m, "m");
    line("  d = x * " + (code.m.of.dx > 0 ? "(" + m + ")" : m) + ";");
    line("}\n");
  }

  /// Arguments that say what the surface is, for project().
  Texts of_surface() const {
    Texts names = {"alpha_x", "alpha_y"};
    if (target_.slopes.correlation != 0) names.emplace_back("correlation");
    if (!target_.slopes.centred()) names.insert(names.end(), {"mean_x", "mean_y"});
    return names;
  }

  void project() {
    const SlopeMap& map = target_.slopes;
    line("// c and s of a unit vector: the projected area of the mesosurface and the projected roughness, alpha_o "
         "sin(theta)");
    line("// (Heitz 2014, Eqs. 80, 96, 97). This material has alpha_x = " + format_number(map.alpha_x) +
         ", alpha_y = " + format_number(map.alpha_y) +
         (map.correlation != 0 ? ", correlation = " + format_number(map.correlation) : "") +
         (map.centred() ? ""
                        : ", mean_x = " + format_number(map.mean_x) + ", mean_y = " + format_number(map.mean_y) +
                              " (mean_slope)") +
         ".");
    if (!map.centred()) {
      line("// The terms of c cancel towards the horizon of the mesosurface: in float its relative error is up to");
      line("// 2.4e-07 (|z| + |x mean_x| + |y mean_y|) / c, and that of G1 as much more.");
    }
    Texts arguments;
    for (const auto& name : Texts{"x", "y", "z"}) arguments.push_back(real() + " " + name);
    for (const auto& name : of_surface()) arguments.push_back(real() + " " + name);
    head("void " + name_ + "_project(" + joined(arguments) + ", " + output("c") + ", " + output("s") + ")");
    const bool correlated = map.correlation != 0;
    line(local("u") + "alpha_x * x" + (correlated ? " + correlation * alpha_y * y;" : ";"));
    line(local("v") +
         (correlated ? sqrt("(" + number(1) + " - correlation) * (" + number(1) + " + correlation)") + " * " : "") +
         "alpha_y * y;");
    line("  c = " + max(map.centred() ? "z" : "z - x * mean_x - y * mean_y", number(0)) + ";");
    line("  s = " + sqrt("u * u + v * v") + ";");
    line("}\n");
  }

  /// The arguments of a function: what says the directions, the surface, the parameter, and what else it needs.
  std::string arguments(bool vectors, const Texts& ends, bool azimuth) const {
    Texts names;
    for (const auto& end : ends)
      for (const auto& name : vectors ? Texts{"x", "y", "z"} : Texts{"cos_theta"}) names.push_back(name + end);
    if (vectors)
      for (const auto& name : of_surface()) names.push_back(name);
    else if (target_.alpha == FitAlpha::argument)
      names.emplace_back("alpha");
    if (has_y()) names.push_back(target_.parameter->key);
    if (azimuth) names.emplace_back("phi");
    for (auto& name : names) name = real() + " " + name;
    return joined(names);
  }

  /// Of y where it may stand beside that of a vector.
  std::string name_of_y() const { return "y_" + target_.parameter->key; }

  /// y, of the parameter within its domain; code_y().
  void set_y() {
    const FitParameter& p = *target_.parameter;
    const std::string above = max(p.key, number(p.from));
    line(local("within") + (p.to < infinity ? min(above, number(p.to)) : above) + ";");
    const std::string shifted = std::string("within") + (p.shift < 0 ? " - " : " + ") + number(std::abs(p.shift));
    line(local(name_of_y()) + (p.reciprocal ? number(p.factor) + " / (" + shifted + ");"
                                            : number(p.offset) + " + " + number(p.factor) + " * within;"));
  }

  /// c of a direction, and s, code_roughness(), where `whole`.
  void project_side(bool vectors, const std::string& end, bool whole) {
    if (vectors) {
      line("  " + real() + " c" + end + ";");
      line("  " + real() + " s" + end + ";");
      line("  " + name_ + "_project(x" + end + ", y" + end + ", z" + end + ", " + joined(of_surface()) + ", c" + end +
           ", s" + end + ");");
      return;
    }
    const std::string c = "c" + end;
    line(local(c) + max("cos_theta" + end, number(0)) + ";");
    if (!whole) return;
    const std::string one = number(1);
    const std::string sine = sqrt(max("(" + one + " - " + c + ") * (" + one + " + " + c + ")", number(0)));
    std::string alpha;
    if (target_.alpha == FitAlpha::argument) alpha = "alpha * ";
    if (target_.alpha == FitAlpha::root_of_y) alpha = sqrt(name_of_y()) + " * ";
    if (target_.alpha == FitAlpha::parameter) alpha = "within * ";
    line(local("s" + end) + alpha + sine + ";");
  }

  /// n and d of a direction.
  void terms_of_side(bool vectors, const std::string& end) {
    project_side(vectors, end, true);
    line("  " + real() + " n" + end + ";");
    line("  " + real() + " d" + end + ";");
    line("  " + name_ + "_terms(c" + end + ", s" + end + (has_y() ? ", " + name_of_y() : "") + ", n" + end + ", d" +
         end + ");");
  }

  /// Lambda and G1.
  void masking(bool vectors) {
    const bool overloaded = !vectors && !target_.by_cosine();
    const std::string of = vectors ? " of a unit vector" : "";
    line("// Smith's Lambda" + of + "; about 1e30 at grazing and below the horizon." +
         (overloaded ? " alpha = alpha_o = s / sin(theta)." : ""));
    function_of_one("lambda", vectors, "n / " + max("d", number(code_tiny)));
    line("// Smith's masking function G1 = 1 / (1 + Lambda)" + of + "." +
         (overloaded ? " alpha = alpha_o = s / sin(theta)." : ""));
    function_of_one("g1", vectors, "d / (d + n)");
  }

  void function_of_one(const std::string& what, bool vectors, const std::string& value) {
    head(real() + " " + name_ + "_" + what + "(" + arguments(vectors, {""}, false) + ")");
    if (has_y()) set_y();
    terms_of_side(vectors, "");
    line("  return " + value + ";");
    line("}\n");
  }

  std::string doc_of_shadowing(bool azimuth) const {
    const std::string& form = target_.shadowing;
    if (form == "none") return "Masking alone: G2 = G1(o) (Heitz 2014, Eq. 35), 0 where i is below the horizon.";
    if (form == "separable") return "Masking and shadowing, separable: G2 = G1(o) G1(i) (Heitz 2014, Eq. 98).";
    if (form == "minimum") return "Masking and shadowing: G2 = min(G1(o), G1(i)), as of V-cavities.";
    if (form == "height_correlated")
      return "Height-correlated masking and shadowing G2 = 1 / (1 + Lambda_o + Lambda_i) (Heitz 2014, Eq. 99).";
    const std::string of = target_.factor + "'s lambda of " +
                           (azimuth ? "phi = |phi_o - phi_i| in [0, pi]." : "the difference in azimuth, phi.");
    if (form == "direction_correlated")
      return "G2 = lambda G1(o) G1(i) + (1 - lambda) min(G1(o), G1(i)) (Heitz 2014, Eq. 100),\n// " + of;
    return "G2 = 1 / (1 + max(Lambda_o, Lambda_i) + lambda min(Lambda_o, Lambda_i)) (Heitz 2014, Eq. 101),\n// " + of;
  }

  /// rest = 1 - lambda of the factor.
  void set_rest(bool vectors) {
    if (vectors)
      line(local("phi") +
           arctangent(max(call(cpp() ? "fabs" : "abs", {"x_o * y_i - y_o * x_i"}), number(code_tiny)),
                      "x_o * x_i + y_o * y_i") +
           ";");
    line(local("rest") +
         (target_.factor == "ashikhmin" ? call("exp", {number(-7.3) + " * phi * phi"})
                                        : number(1) + " / (" + number(1) + " + " + number(4.41) + " * phi)") +
         ";");
  }

  /// The last lines of G2, of n and d of both sides.
  void combine() {
    const std::string& form = target_.shadowing;
    const std::string g1_o = "d_o / (d_o + n_o)", g1_i = "d_i / (d_i + n_i)";
    const auto result = [&](const std::string& value) {
      const std::string faces = target_.slopes.centred() ? "" : "z_o + z_i > " + number(0) + " ? ";
      line("  return " + faces + value + (faces.empty() ? ";" : " : " + number(0) + ";"));
    };
    const auto correlated = [&](const std::string& sum) {
      line(local("both") + "d_o * d_i;");
      result("both / " + max("both + " + sum, number(code_tiny)));
    };
    if (form == "none") return result("(c_i > " + number(0) + " ? " + g1_o + " : " + number(0) + ")");
    if (form == "separable") return result("(" + g1_o + ") * (" + g1_i + ")");
    if (form == "minimum") return result(min(g1_o, g1_i));
    if (form == "height_correlated") return correlated("n_o * d_i + n_i * d_o");
    if (form == "direction_correlated") {
      line(local("g1_o") + g1_o + ";");
      line(local("g1_i") + g1_i + ";");
      return result("(" + number(1) + " - rest) * g1_o * g1_i + rest * " + min("g1_o", "g1_i"));
    }
    line(local("o") + "n_o * d_i;");
    line(local("i") + "n_i * d_o;");
    correlated(max("o", "i") + " + (" + number(1) + " - rest) * " + min("o", "i"));
  }

  void shadowing(bool vectors) {
    const bool azimuth = !target_.factor.empty() && !vectors;
    line("// " + doc_of_shadowing(azimuth));
    if (!target_.slopes.centred())
      line("// 0 where the half vector of the two is not above the geometric surface, where no facets are.");
    head(real() + " " + name_ + "_g2(" + arguments(vectors, {"_o", "_i"}, azimuth) + ")");
    if (has_y()) set_y();
    terms_of_side(vectors, "_o");
    if (target_.shadowing == "none")
      project_side(vectors, "_i", false);
    else
      terms_of_side(vectors, "_i");
    if (!target_.factor.empty()) set_rest(vectors);
    combine();
    line("}\n");
  }

  const FitResult& result_;
  const FitTarget& target_;
  std::string name_;
  std::string out_;
};

} // namespace

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
