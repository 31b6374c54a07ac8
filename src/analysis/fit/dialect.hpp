/// \file
/// What differs between the languages in which a fit is written.
#pragma once

#include "analysis/fit/code.hpp"
#include "base/number.hpp"

namespace brdfplot {

using Texts = std::vector<std::string>;

inline std::string joined(const Texts& texts) {
  std::string out;
  for (const auto& text : texts) out += (out.empty() ? "" : ", ") + text;
  return out;
}

/// Expressions and declarations as text.
class FitDialect {
public:
  explicit FitDialect(FitLanguage language) : language_(language) {}

  bool cpp() const { return language_ == FitLanguage::cpp; }
  std::string real() const { return cpp() ? "Real" : "float"; }
  std::string local(const std::string& name) const {
    return "  " + (cpp() ? "const Real " : std::string("float ")) + name + " = ";
  }
  std::string output(const std::string& name) const { return cpp() ? "Real& " + name : "out float " + name; }
  std::string call(const std::string& function, const Texts& arguments) const {
    return (cpp() ? "std::" : "") + function + "(" + joined(arguments) + ")";
  }
  std::string max(const std::string& a, const std::string& b) const { return call("max", {a, b}); }
  std::string min(const std::string& a, const std::string& b) const { return call("min", {a, b}); }
  std::string sqrt(const std::string& x) const { return call("sqrt", {x}); }
  std::string arctangent(const std::string& y, const std::string& x) const {
    return call(language_ == FitLanguage::glsl ? "atan" : "atan2", {y, x});
  }
  std::string literal(std::string digits) const {
    if (digits.find_first_of(".e") == std::string::npos) digits += ".0";
    return cpp() ? "Real(" + digits + ")" : digits;
  }
  std::string number(double value) const { return literal(format_number(value)); }

private:
  FitLanguage language_;
};

} // namespace brdfplot
