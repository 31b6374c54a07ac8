#include "analysis/properties.hpp"
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/property_tests.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace test;

namespace {

const PropertySearch quick{{0.3, 1.2, 1.5}, 1e-6};

Verdict verdict(Property property, const TermDescription& description, const PropertySearch& search = quick) {
  return measure(property, {description}, search).verdict;
}

} // namespace

TEST_CASE("Table 3: Smith and V-cavities hold, the three others fail, from residuals") {
  PropertyTableDescription table;
  table.maskings = {"smith", "v_cavity", "implicit", "schlick_smith", "kelemen"};
  ModelChoice gtr{"gtr", {}};
  gtr.values.set("gamma", 1.5);
  table.distributions = {{"beckmann", {}}, {"ggx", {}}, gtr};
  table.alpha = {0.1, 0.6};
  table.theta_o = {0.3, 1.2, 1.5};
  const auto rows = families(table);
  REQUIRE(rows.size() == 15);
  CHECK(rows[2].label == "gtr (gamma 1.5)");
  CHECK(rows[2].members.size() == 2);
  for (const PropertyFamily& family : rows) {
    const PropertyRow row = measure(family, table3_properties(), table.search());
    INFO(row.masking << ", " << row.label);
    const bool based = row.masking == "smith" || row.masking == "v_cavity";
    CHECK(row.physically_based() == (based ? Verdict::holds : Verdict::fails));
    CHECK(row.verdict("physically_based") == row.physically_based());
    // The four say the same of every masking function, as section 3 of the paper derives.
    for (const auto& [property, residual] : row.residuals)
      CHECK(residual.verdict == (based ? Verdict::holds : Verdict::fails));
  }
}

TEST_CASE("alpha_x alpha_y in place of alpha_o^2: the bug is caught, and the right formula passes") {
  const auto anisotropic = general("ggx", 0.2, 0.6, 0);
  const auto right = with_formula(anisotropic, "lambda", "(sqrt(1 + alpha^2 * tan_theta^2) - 1) / 2");
  const auto wrong = with_formula(anisotropic, "lambda", "(sqrt(1 + alpha_x * alpha_y * tan_theta^2) - 1) / 2");
  for (const Property property : table3_properties()) {
    CHECK(verdict(property, right) == Verdict::holds);
    const Residual residual = measure(property, {wrong}, quick);
    CHECK(residual.verdict == Verdict::fails);
    // At grazing G1 is off by the factor alpha_o / sqrt(alpha_x alpha_y), largest where that is: along y.
    CHECK(residual.phi_o == doctest::Approx(90 * degree));
    CHECK(residual.theta_o == 1.5);
    CHECK(residual.max_residual > 0.5);
    CHECK(residual.error < 1e-7);
  }
  CHECK(verdict(Property::stretch_invariance, right) == Verdict::holds);
  CHECK(verdict(Property::stretch_invariance, wrong) == Verdict::fails);
  // Where both are the same function, nothing is to be found.
  const auto isotropic =
      with_formula(describe("ggx", 0.4), "lambda", "(sqrt(1 + alpha_x * alpha_y * tan_theta^2) - 1) / 2");
  CHECK(verdict(Property::eq36, isotropic) == Verdict::holds);
  // It is a masking function all the same: in [0, 1], decreasing, 1 at the normal, reciprocal.
  for (const Property property :
       {Property::g1_range, Property::g1_decreasing, Property::g1_normal, Property::reciprocity, Property::normalized})
    CHECK(verdict(property, wrong) == Verdict::holds);
}

TEST_CASE("each property is told from the others") {
  struct Case {
    Property property;
    TermDescription bad;
  };
  const auto ggx = describe("ggx", 0.5);
  const std::vector<Case> cases = {{Property::g1_range, with_formula(ggx, "g1", "1 + 0.1 * sin(theta)^2")},
                                   {Property::g1_range, with_formula(ggx, "lambda", "-0.01 * tan_theta")},
                                   {Property::g1_decreasing, with_formula(ggx, "g1", "0.9 + 0.1 * cos(7 * theta)")},
                                   {Property::g1_normal, with_formula(ggx, "g1", "0.99 * cos_theta")},
                                   {Property::stretch_invariance, describe("ggx", 0.5, "implicit")},
                                   {Property::reciprocity, shadowed(ggx, "none")},
                                   {Property::energy, with_formula(ggx, "g1", "min(1, 4 * cos_theta)")},
                                   {Property::eq37, with_formula(ggx, "g1", "1")}};
  const PropertySearch search{sample_of<double>({1.5, 1.2, 0.3}, 3), 1e-6};
  for (const auto& one : cases) {
    const auto& property = one.property; // Clang 14 has no structured binding in the lambda of INFO
    const auto& bad = one.bad;
    INFO(properties()[static_cast<std::size_t>(property)].name << ", " << bad.masking.type);
    CHECK(verdict(property, ggx, search) == Verdict::holds);
    CHECK(verdict(property, bad, search) == Verdict::fails);
  }
  // Kelemen's masking is above 1 where the facet is tilted from the viewer (Heitz 2014, Eq. 59 as printed).
  CHECK(verdict(Property::g1_range, describe("ggx", 0.5, "kelemen")) == Verdict::fails);
  CHECK(verdict(Property::stretch_invariance, describe("phong", 0.5)) == Verdict::not_applicable);
}

TEST_CASE("everything holds of what is physically based, tilted, correlated and stretched") {
  for (const auto& description : {general("ggx", 0.2, 0.7, 0.5, {0.3, -0.2}), general("beckmann", 0.4, 0.3, -0.6),
                                  general("beckmann", 0.3, 0.5, 0.2, {0.1, 0.1}, "v_cavity")})
    for (const auto& info : properties()) {
      const Residual residual = measure(info.property, {description}, {{0.0, 0.9, 1.4}, 1e-6});
      INFO(description.name << ", " << info.name << ": " << residual.max_residual << " at " << residual.theta_o);
      CHECK(residual.verdict == Verdict::holds);
    }
}

TEST_CASE("what the error does not allow to tell is not told") {
  WorstResidual worst(1e-6);
  CHECK(worst.residual().verdict == Verdict::not_applicable);
  worst.take(1e-9, 1e-10, 0.1, 0);
  CHECK(worst.residual().verdict == Verdict::holds);
  worst.take(1e-10, 1e-5, 0.2, 0); // a smaller residual, but no one knows
  CHECK(worst.residual().verdict == Verdict::unknown);
  CHECK(worst.residual().theta_o == 0.1);
  worst.take(1e-4, 1e-5, 0.3, 0.5);
  CHECK(worst.residual().verdict == Verdict::fails);
  CHECK(worst.residual().phi_o == 0.5);
  WorstResidual nan(1e-6);
  nan.take(std::nan(""), 0, 0, 0);
  nan.take(0, 0, 0, 0);
  CHECK(nan.residual().verdict == Verdict::unknown);
  CHECK(std::isnan(nan.residual().max_residual));
  // A tolerance below what the quadrature of an integral can reach.
  CHECK(verdict(Property::eq36, describe("beckmann", 0.5), {{1.0}, 1e-17}) == Verdict::unknown);
}

TEST_CASE("claims are names of properties") {
  const auto names = claim_names();
  CHECK(names.front() == "physically_based");
  for (const auto& info : properties()) {
    CHECK(std::ranges::find(names, info.name) != names.end());
    CHECK(static_cast<std::size_t>(info.property) == static_cast<std::size_t>(&info - properties().data()));
    CHECK(PropertyRow{}.verdict(info.name) == Verdict::unknown);
  }
}

TEST_CASE("Eq. 9.22 holds of every distribution whose mean slope is finite") {
  for (const TermDescription& description : every_distribution()) {
    const Residual residual = measure(Property::eq9_22, {description}, quick);
    INFO(description.name << ": " << residual.max_residual << " +- " << residual.error);
    if (description.distribution.type == "oren_nayar") {
      CHECK(residual.verdict == Verdict::not_applicable);
      CHECK(residual.reason == "the mean slope is infinite");
    } else {
      CHECK(residual.verdict == Verdict::holds);
    }
  }
}

TEST_CASE("Eq. 9.22 fails of what is no density of a heightfield's normals, by as much as it is off") {
  // D = (n + 1) / (2 pi) cos^n, normalised over solid angle, as a lobe of the half vector may be; D cos^4 with cos^2 =
  // 1 / (1 + t2). The integral of D cos is (n + 1) / (n + 2).
  const auto lobe = [](bool normalised) {
    TermDescription description = custom("21 / (2 * pi) * (1 + t2)^-12", 1);
    description.distribution.values.set("normalised", normalised);
    return description;
  };
  const Residual wrong = measure(Property::eq9_22, {lobe(false)}, quick);
  CHECK(wrong.verdict == Verdict::fails);
  CHECK(wrong.max_residual == doctest::Approx(1.0 / 22).epsilon(1e-8));
  CHECK(verdict(Property::normalized, lobe(false)) == Verdict::fails);
  CHECK(verdict(Property::eq9_22, lobe(true)) == Verdict::holds);
  const Direction m = from_angles(0.4, 1);
  CHECK(value_at_normal(build(lobe(false)), Quantity::d, m, m) ==
        doctest::Approx(21 / (2 * std::numbers::pi) * std::pow(std::cos(0.4), 20)).epsilon(1e-13));
}
