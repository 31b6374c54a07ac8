#include "figure/series/simulated.hpp"
#include "analysis/integrals.hpp"
#include "materials.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace test;
using namespace brdfplot::plot;
using simulation::Store;

namespace {

Term walked(const std::string& quantity, const std::string& bounces, std::vector<Setting> at) {
  Term term{quantity, describe("ggx", 0.7), std::move(at), Simulate{}};
  term.simulate->source = "smith_walk";
  term.simulate->bounces = bounces;
  term.simulate->paths = 20000;
  term.simulate->samples = 7;
  return term;
}

Expression expression(const Term& term) {
  Expression out;
  out.term = term;
  return out;
}

FigureDescription figure(const std::string& variable, double from, double to, const std::vector<Term>& terms,
                         Kind kind = Kind::lines) {
  FigureDescription out;
  out.id = "fig";
  out.kind = kind;
  PanelDescription panel;
  panel.x.column = variable;
  panel.x.from = from;
  panel.x.to = to;
  for (const Term& term : terms) panel.series.push_back({term.quantity, expression(term), {}});
  out.panels.push_back(panel);
  return out;
}

} // namespace

TEST_CASE("a simulated series has the points it asks for, with errors about the computed ones") {
  const Term computed{"albedo", describe("ggx", 0.7), {}, {}};
  const auto series = compute(figure("theta_o", 0, 1.2, {walked("albedo", "1", {}), computed})).panels.at(0).series;
  REQUIRE(series.size() == 2);
  REQUIRE(series[0].x.size() == 7);
  CHECK(series[0].x.front() == 0);
  CHECK(series[0].x.back() == 1.2);
  CHECK(series[1].error.empty());
  for (std::size_t k = 0; k < 7; ++k) {
    const double truth = compute_or_throw(Integral::albedo, material("ggx", 0.7), from_angles(series[0].x[k], 0), 1e-7);
    CHECK(series[0].error.at(k) > 0);
    CHECK(std::fabs(series[0].y[k] - truth) < 4 * series[0].error[k]);
  }
}

TEST_CASE("figures are the same for any number of threads and with what a store remembers") {
  const auto description =
      figure("theta_i", -1.5, 1.5,
             {walked("brdf_cos", "1", {{"theta_o", 1.0}}), walked("brdf_cos", "2+", {{"theta_o", 1.0}})}, Kind::polar);
  Store store, other;
  const std::string first = to_csv(compute(description, store, 1));
  CHECK(to_csv(compute(description, store, 1)) == first);
  CHECK(to_csv(compute(description, other, 3)) == first);
  CHECK(to_svg(compute(description, store)).find("fill-opacity=\"0.35\"") != std::string::npos);
}

TEST_CASE("the simulations of a figure are listed once each, and fill the store") {
  const auto lobes =
      figure("theta_i", -1.5, 1.5,
             {walked("brdf_cos", "1", {{"theta_o", 1.0}}), walked("brdf_cos", "2+", {{"theta_o", 1.0}})});
  CHECK(simulations(lobes).size() == 1);
  const auto energies = figure("alpha", 0.2, 1, {walked("albedo", "1", {{"theta_o", 1.0}})});
  const auto tasks = simulations(energies);
  REQUIRE(tasks.size() == 7);
  Store store;
  for (const auto& task : tasks) task.run(store, 1);
  bool computed_again = false;
  for (const auto& task : tasks) store.get(task.key, [&] { return computed_again = true, simulation::Result{}; });
  CHECK_FALSE(computed_again);
  const auto series = compute(energies, store).panels.at(0).series.at(0);
  CHECK(series.y.front() > series.y.back());
}

TEST_CASE("what defines a simulation is in its key, and nothing else") {
  const Term base = walked("albedo", "1", {{"theta_o", 1.0}});
  const auto key = [](const Term& term) { return simulations(figure("phi_o", 0, 0.1, {term})).at(0).key; };
  std::set<std::string> keys = {key(base)};
  const auto differs = [&](const Term& term) { return keys.insert(key(term)).second; };
  Term changed = base;
  changed.simulate->bounces = "2+";
  CHECK_FALSE(differs(changed));
  changed.material.name = "another name";
  CHECK_FALSE(differs(changed));
  changed.simulate->seed = 2;
  CHECK(differs(changed));
  changed.simulate->paths = 30000;
  CHECK(differs(changed));
  Term diffuse = changed;
  diffuse.material.terms[0].type = "facet_diffuse";
  CHECK(differs(diffuse));
  diffuse.simulate->facets = "diffuse";
  CHECK_FALSE(differs(diffuse));
  changed.material.terms[0].distribution.values.set("alpha", 0.700001);
  CHECK(differs(changed));
  changed.material.terms[0].distribution.type = "beckmann";
  CHECK(differs(changed));
  changed.material.terms[0].fresnel = {.type = "schlick", .values = {}};
  changed.material.terms[0].fresnel.values.set("f0", 0.1);
  CHECK(differs(changed));
  changed.at = {{"theta_o", 1.1}};
  CHECK(differs(changed));
}

TEST_CASE("a simulated series of diffuse facets shows diffuse facets") {
  Term term = walked("brdf_cos", "1", {{"theta_o", 30 * degree}, {"theta_i", -40 * degree}});
  term.material = describe("ggx", 0.5);
  term.material.terms[0].type = "facet_diffuse";
  const double truth = evaluate(build(term.material), Quantity::brdf_cos, from_angles(30 * degree, 0),
                                from_angles(-40 * degree, 0), std::nullopt);
  CHECK(truth == doctest::Approx(0.169).epsilon(0.01));
  for (const char* facets : {"", "diffuse"}) {
    term.simulate->facets = facets;
    const Series series = compute(figure("phi_o", 0, 1e-9, {term})).panels.at(0).series.at(0);
    CHECK(std::fabs(series.y.at(0) - truth) < 4 * series.error.at(0));
    CHECK(series.error[0] < 0.01 * truth);
  }
}

namespace {

std::string refusal(const Term& term) {
  try {
    SimulatedTerm(term, {}).check({});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("facets that are not simulated are refused by name") {
  Term term = walked("albedo", "1", {{"theta_o", 0.5}});
  term.simulate->facets = "diffuse";
  CHECK(refusal(term).find("accepted: conductor, dielectric") != std::string::npos);
  term.material.terms[0].type = "facet_diffuse";
  CHECK(refusal(term).empty());
  for (const char* facets : {"conductor", "dielectric"}) {
    term.simulate->facets = facets;
    CHECK(refusal(term).find("accepted: diffuse") != std::string::npos);
  }
  term.simulate->facets.clear();
  term.simulate->source = "surface";
  CHECK(refusal(term).find("found \"facet_diffuse\", accepted: one term, mirror") != std::string::npos);
  term.material.terms[0].type = "mirror";
  CHECK(refusal(term).empty());
}

TEST_CASE("the walk on a coloured material is that of the channel which is named") {
  Term term = walked("albedo", "all", {{"theta_o", 0.5}});
  term.material.terms[0].fresnel.type = "schlick";
  term.material.terms[0].fresnel.values.set("f0", Rgb{0.9, 0.5, 0.1});
  CHECK(refusal(term).find("\"r\", \"g\", \"b\"") != std::string::npos);
  const auto albedo = [](const Term& one) { return compute(figure("phi_o", 0, 0.1, {one})).panels[0].series[0].y[0]; };
  Term grey = term;
  const std::vector<std::pair<std::string, double>> channels = {{"r", 0.9}, {"g", 0.5}, {"b", 0.1}};
  std::set<std::string> keys;
  for (const auto& [channel, f0] : channels) {
    Term named = term;
    named.at.push_back({"channel", channel});
    grey.material.terms[0].fresnel.values.set("f0", f0);
    CHECK(albedo(named) == albedo(grey));
    CHECK(keys.insert(simulations(figure("phi_o", 0, 0.1, {named})).at(0).key).second);
  }
  term.at.push_back({"channel", "luminance"});
  CHECK(refusal(term).find("no luminance") != std::string::npos);
}

TEST_CASE("differences and ratios of simulated terms carry their errors") {
  const Term one = walked("albedo", "1", {}), more = walked("albedo", "2+", {});
  auto description = figure("theta_o", 0, 1, {one, more, one, one});
  auto& series = description.panels[0].series;
  const auto combine = [&](Expression::Operation operation, const Term& b) {
    Expression out;
    out.operation = operation;
    out.operands = {expression(one), expression(b)};
    return out;
  };
  series[2].value = combine(Expression::Operation::difference, more);
  series[3].value = combine(Expression::Operation::ratio, Term{"albedo", describe("ggx", 0.7), {}, {}});
  const auto out = compute(description).panels.at(0).series;
  CHECK(out[2].y[3] == doctest::Approx(out[0].y[3] - out[1].y[3]).epsilon(1e-14));
  CHECK(out[2].error[3] == doctest::Approx(std::hypot(out[0].error[3], out[1].error[3])).epsilon(1e-12));
  CHECK(std::fabs(out[3].y[3] - 1) < 4 * out[3].error[3]);
}

TEST_CASE("a lobe is compared in numbers with rays on surfaces") {
  Term rays{"brdf_cos", describe("beckmann", 1), {{"theta_o", 1.5}}, Simulate{}};
  rays.simulate->source = "surface";
  rays.simulate->bounces = "1";
  rays.simulate->paths = 40000;
  rays.simulate->realisations = 4;
  rays.simulate->cells = 128;
  rays.simulate->samples = 18;
  const auto compared = [&](const std::string& masking) {
    Term lobe{"brdf_cos", describe("beckmann", 1, masking), {{"theta_o", 1.5}}, {}};
    auto description = figure("theta_i", -std::numbers::pi / 2, std::numbers::pi / 2, {lobe}, Kind::polar);
    description.panels[0].compare_to = rays;
    CHECK(simulations(description).size() == 1);
    const Figure out = compute(description);
    CHECK(to_csv(out).find(",distance,,") != std::string::npos);
    CHECK(to_svg(out).find("distance") != std::string::npos);
    return out.panels.at(0).notes;
  };
  // Heitz 2014, Fig. 11: Smith's lobe is the one that rays find; the V-cavity's stays low, away from the viewer.
  const auto smith = compared("smith"), v_cavity = compared("v_cavity");
  REQUIRE(smith.size() == 2);
  for (const Note& note : smith) CHECK(note.error > 0);
  CHECK(smith[0].value + 5 * smith[0].error < v_cavity[0].value);
  CHECK(v_cavity[1].value < -10 * degree);
  CHECK(std::fabs(smith[1].value) < 10 * degree);
}

TEST_CASE("a lobe is compared with rays in its own plane, where phi_i follows phi_o") {
  // Anisotropic, so that the azimuth counts.
  const TermDescription material = general("beckmann", 1, 0.5, 0);
  const auto notes = [&](const std::vector<Setting>& azimuths) {
    std::vector<Setting> at = {{"theta_o", 1.2}};
    at.insert(at.end(), azimuths.begin(), azimuths.end());
    Term rays{"brdf_cos", material, at, Simulate{}};
    rays.simulate->source = "surface";
    rays.simulate->bounces = "1";
    rays.simulate->paths = 20000;
    rays.simulate->realisations = 3;
    rays.simulate->cells = 128;
    rays.simulate->samples = 18;
    auto description = figure("theta_i", -std::numbers::pi / 2, std::numbers::pi / 2,
                              {Term{"brdf_cos", material, at, {}}}, Kind::polar);
    description.panels[0].compare_to = rays;
    return compute(description).panels.at(0).notes;
  };
  const double phi = 50 * degree;
  const auto fixed = notes({{"phi_o", phi}, {"phi_i", phi}});
  const auto tied = notes({{"phi_o", phi}, {"phi_i", Tie{"phi_o", 1, 0}}});
  const auto turned = notes({{"phi_o", phi}, {"phi_i", Tie{"phi_o", 1, std::numbers::pi}}});
  const auto viewer = notes({{"phi_i", phi}, {"phi_o", Tie{"phi_i", 1, 0}}});
  REQUIRE(fixed.size() == 2);
  CHECK(fixed[0].value < 0.3); // of what is another lobe on the wrong side: near 2
  for (std::size_t k = 0; k < 2; ++k)
    for (const auto& other : {tied, turned, viewer}) {
      CHECK(other[k].value == doctest::Approx(fixed[k].value).epsilon(1e-6));
      CHECK(other[k].error == doctest::Approx(fixed[k].error).epsilon(1e-6));
    }
}

TEST_CASE("rays on an anisotropic surface keep the azimuth, from the normal and on either side of the viewer") {
  // Smoother along y, and stretched along the diagonal: azimuths of opposite sign differ.
  const auto measured = [](const TermDescription& material, double theta_o, double phi_i) {
    Term term{"g2", material, {{"theta_o", theta_o}, {"theta_i", 75 * degree}}, Simulate{}};
    term.simulate->source = "surface";
    term.simulate->paths = 20000;
    term.simulate->realisations = 2;
    term.simulate->cells = 128;
    return SimulatedTerm(term, {"phi_i"}).measure({phi_i}, *std::make_unique<Store>(), 2).at(0).value;
  };
  const auto along_x = general("beckmann", 1, 0.5, 0);
  CHECK(measured(along_x, 0, 0) < 0.7);
  CHECK(measured(along_x, 0, 90 * degree) > 0.75);
  const auto diagonal = general("beckmann", 1, 1, 0.95);
  CHECK(measured(diagonal, 1 * degree, 45 * degree) < 0.8);
  CHECK(measured(diagonal, 1 * degree, -45 * degree) > 0.95);
}
