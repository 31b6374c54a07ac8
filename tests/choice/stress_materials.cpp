#include "../sample.hpp"
#include "brdf/material.hpp"
#include "choice/stress/material_problems.hpp"
#include "choice/stress/stress.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brdfplot;
using namespace brdfplot::choice;

namespace {

/// "quantity kind" of everything that is found of a material; of all its quantities or of some.
std::vector<std::string> found_of(const MaterialDescription& material, const std::vector<std::string>& of = {}) {
  std::vector<std::string> all;
  for (const auto& problem : material_problems(material)) {
    if (!of.empty() && std::ranges::find(of, problem.methods.front().name) == of.end()) continue;
    for (const auto& report : stress(problem))
      for (const auto& finding : report.findings) all.push_back(report.method + " " + std::string(finding.kind->name));
  }
  return all;
}

bool has(const std::vector<std::string>& found, const std::string& what) {
  return std::ranges::find(found, what) != found.end();
}

TermDescription facets(const std::string& distribution, double alpha) {
  TermDescription term;
  term.name = distribution;
  term.distribution.type = distribution;
  term.distribution.values.set("alpha", alpha);
  return term;
}

TermDescription flat(const std::string& type, const std::vector<std::pair<std::string, Value>>& values) {
  TermDescription term;
  term.name = term.type = type;
  for (const auto& [key, value] : values) term.values.set(key, value);
  return term;
}

TermDescription custom_masking(const std::string& key, const std::string& formula) {
  TermDescription term = facets("ggx", 0.01);
  term.masking.type = "custom";
  term.masking.values.set(key, formula);
  return term;
}

std::string joined(const std::vector<std::string>& all) {
  std::string out;
  for (const auto& one : all) out += one + "; ";
  return out;
}

} // namespace

TEST_CASE("stress: nothing of microfacet materials, however narrow") {
  for (const auto& material :
       test::sample_of(std::vector<TermDescription>{facets("ggx", 0.3), facets("beckmann", 0.3), facets("ggx", 1e-3),
                                                    facets("beckmann", 0.02)},
                       1)) {
    const auto found = found_of(material);
    INFO(material.name << ": " << joined(found));
    CHECK(found.empty());
  }
}

TEST_CASE("stress: diffuse terms that reflect more than all light") {
  CHECK(has(found_of(flat("oren_nayar", {{"albedo", 1.0}, {"sigma", 0.3}})), "albedo energy_above_1"));
  if (test::sampled()) return;
  CHECK(has(found_of(flat("disney_diffuse", {{"albedo", 1.0}, {"roughness", 1.0}})), "albedo energy_above_1"));
  CHECK(
      has(found_of(flat("hammon_diffuse", {{"albedo", 1.0}, {"alpha", 1.0}, {"f0", 0.04}})), "albedo energy_above_1"));
  CHECK(has(found_of(flat("velvet_cloth", {{"albedo", 1.0}, {"f0", 1.0}, {"alpha", 0.1}, {"amplitude", 100.0}})),
            "albedo energy_above_1"));
  CHECK(!has(found_of(flat("lambert", {{"albedo", 1.0}})), "albedo energy_above_1"));
}

TEST_CASE("stress: a formula of one's own is a method like any other") {
  const auto naive = found_of(custom_masking("lambda", "(sqrt(1 + 1/(a*a)) - 1) / 2"), {"lambda", "g1"});
  INFO(joined(naive));
  CHECK(has(naive, "lambda digits_unseen"));
  CHECK(!has(naive, "lambda digits_lost"));
  const auto good = found_of(custom_masking("lambda", "0.5 / (a * (a + sqrt(a*a + 1)))"), {"lambda", "g1"});
  INFO(joined(good));
  CHECK(!has(good, "lambda digits_unseen"));
  const auto wrong = found_of(custom_masking("lambda", "0.1 - 1 / (1 + a)"), {"lambda", "g1"});
  CHECK(has(wrong, "lambda negative"));
  CHECK(has(wrong, "g1 above_1"));
  CHECK(has(found_of(custom_masking("lambda", "0 * a"), {"lambda", "g1"}), "lambda nan"));
}
