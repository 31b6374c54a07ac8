// What tells one series from another: first values are computed once for all that are defined alike.
#include "figure/series/defining_text.hpp"
#include "../materials.hpp"

#include <doctest/doctest.h>

using namespace test;

TEST_CASE("series: terms of other terms are told from each other by these") {
  const auto text = [](const TermDescription& other, const std::string& name = "") {
    TermDescription term;
    term.type = "multiple_bounce";
    term.of_name = name;
    if (name.empty()) term.of = {other};
    return plot::defining_text({"albedo", MaterialDescription(term), {}}, {"theta_o"});
  };
  const TermDescription smooth = describe("ggx", 0.4);
  CHECK(text(smooth) == text(smooth));
  CHECK(text(smooth) != text(describe("ggx", 0.8)));
  CHECK(text(smooth) != text(describe("beckmann", 0.4)));
  CHECK(text(smooth) != text(describe("ggx", 0.4, "v_cavity")));
  CHECK(text(smooth, "one") != text(smooth, "other"));
}
