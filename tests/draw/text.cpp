#include "draw/text.hpp"

#include <doctest/doctest.h>

#include <string>

#include "draw/number_text.hpp"

namespace {

using namespace brdfplot::plot;
using Level = Run::Level;
using Runs = std::vector<Run>;

std::string escaped(std::string_view text) {
  std::string out;
  append_escaped(out, text);
  return out;
}

std::string html(std::string_view label) {
  std::string out;
  append_html(out, label);
  return out;
}

std::string tspans(std::string_view label) {
  std::string out;
  append_tspans(out, label, 10);
  return out;
}

} // namespace

TEST_CASE("markup is split into runs") {
  CHECK(parse_markup("θ_o = 3") == Runs{{"θ", Level::base}, {"o", Level::sub}, {" = 3", Level::base}});
  CHECK(parse_markup("10^{-3}") == Runs{{"10", Level::base}, {"-3", Level::super}});
  CHECK(parse_markup("D_{GGX}^2") == Runs{{"D", Level::base}, {"GGX", Level::sub}, {"2", Level::super}});
  CHECK(parse_markup("x_α") == Runs{{"x", Level::base}, {"α", Level::sub}});
  CHECK(parse_markup("a_{b{c}d}e") == Runs{{"a", Level::base}, {"b{c}d", Level::sub}, {"e", Level::base}});
  CHECK(parse_markup("").empty());
}

TEST_CASE("underscores that are no markup stay") {
  for (const char* label :
       {"heitz2014_x", "white_furnace", "v_cavity", "of v_cavity.", "r_xy", "_x", "a _b", "a_", "a_ b", "^", "x^"}) {
    CAPTURE(label);
    CHECK(parse_markup(label) == Runs{{label, Level::base}});
  }
  CHECK(parse_markup("E_o(θ_o)")[1] == Run{"o", Level::sub});
  CHECK(parse_markup("a\\_b\\^c") == Runs{{"a_b^c", Level::base}});
  CHECK(parse_markup("log_2 n")[1] == Run{"2", Level::sub});
  CHECK(parse_markup("heitz2014_{x}")[1] == Run{"x", Level::sub});
  CHECK(parse_markup("x_{open") == Runs{{"x", Level::base}, {"{", Level::sub}, {"open", Level::base}});
}

TEST_CASE("stripping takes the braces only") {
  CHECK(strip_markup("θ_o") == "θ_o");
  CHECK(strip_markup("10^{-3} of D_{GGX}") == "10^-3 of D_GGX");
  CHECK(strip_markup("a\\_b {set}") == "a_b {set}");
}

TEST_CASE("escaping makes any bytes well-formed") {
  CHECK(escaped("a<b & \"c\" > 'd'") == "a&lt;b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  CHECK(escaped("α ≤ 𝛼") == "α ≤ 𝛼");
  CHECK(escaped(std::string("a\x01"
                            "b\xFF"
                            "c\xC3")) == "a�b�c�");
  CHECK(escaped("\xED\xA0\x80") == "���");
}

TEST_CASE("scripts are shifted and the baseline restored") {
  CHECK(tspans("θ_o = 1") == "θ<tspan dy=\"2.4\" font-size=\"7.5\">o</tspan><tspan dy=\"-2.4\"> = 1</tspan>");
  CHECK(tspans("10^{-3}") == "10<tspan dy=\"-3.6\" font-size=\"7.5\">-3</tspan>");
  CHECK(html("f_r < 10^{-3}") == "f<sub>r</sub> &lt; 10<sup>-3</sup>");
}

TEST_CASE("widths grow with the text and do not count markup") {
  CHECK(text_width("θ_{o}", 10) == text_width("θ_o", 10));
  CHECK(text_width("θ_o", 10) < text_width("θo", 10));
  CHECK(text_width("WWW", 10) > text_width("iii", 10));
  CHECK(text_width("abc", 10, true) > text_width("abc", 10));
  CHECK(text_width("", 10) == 0);
  CHECK(text_width("ω", 10) == doctest::Approx(8.37)); // as DejaVu Sans has it
  CHECK(text_width("Λ", 10) == doctest::Approx(6.84));
}

TEST_CASE("long labels are wrapped, shrunk, and cut only where nothing else helps") {
  const auto wrapped = fit_text("a title of quite some words that does not fit", 16, 150, 4);
  CHECK(wrapped.lines.size() > 1);
  CHECK(wrapped.width() <= 150);
  CHECK(fit_text("a somewhat long one", 16, 140, 1).size < 16);
  CHECK(fit_text("a somewhat long one", 16, 20, 1).size >= smallest_font);
  CHECK(fit_text(std::string(200, 'x'), 16, 100, 2).width() <= 100);
  CHECK(fit_text("", 16, 100, 1).lines.empty());
}

TEST_CASE("a literal label shows every character of a name") {
  for (const std::string name : {"rational_2_float", "x^2_i", "v_cavity", "plain", "", "a_", "_b"})
    CHECK(parse_markup(literal_label(name)) == (name.empty() ? Runs{} : Runs{{name, Level::base}}));
  CHECK(html(literal_label("rational_2")) == "rational_2");
}

TEST_CASE("coordinates are short") {
  const auto fixed = [](double value) {
    std::string out;
    append_fixed(out, value);
    return out;
  };
  CHECK(fixed(12.5) == "12.5");
  CHECK(fixed(-0.254) == "-0.25");
  CHECK(fixed(-0.001) == "0");
  CHECK(fixed(3) == "3");
  CHECK(fixed(0.05) == "0.05");
  std::string path;
  append_hundredths(path, -7);
  CHECK(path == "-.07");
  CHECK(decimal_label(-0.0001, 2) == "0.00");
}
