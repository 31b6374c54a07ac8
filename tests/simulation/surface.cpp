#include "simulation/scenes.hpp"

#include "microfacet/microsurface.hpp"
#include "models/registry.hpp"
#include "simulation/surface.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

using namespace test;

namespace {

/// The table of the surface alone.
Table statistics(const ModelChoice& choice, int realisations = 1) {
  SceneDescription description;
  description.surface = choice;
  description.realisations = realisations;
  return run(description).surface;
}

ModelChoice general(const std::string& type, double samples, double correlation_length) {
  ModelChoice choice{.type = type, .values = {}};
  choice.values.set("alpha_x", 0.3);
  choice.values.set("alpha_y", 0.8);
  choice.values.set("correlation", -0.4);
  choice.values.set("mean_slope", Vec2{0.2, -0.1});
  choice.values.set("samples", samples);
  choice.values.set("correlation_length", correlation_length);
  return choice;
}

/// Five standard deviations of chi^2 above its mean, of independent slopes. Where the waves' amplitudes are fixed the
/// histogram as a whole scatters less than its tiles do.
void check_histogram(const Table& table, std::size_t row) {
  const double degrees = at(table, row, "degrees_of_freedom");
  CHECK(at(table, row, "chi2") < degrees + 5 * std::sqrt(2 * degrees));
  CHECK(at(table, row, "independent_slopes") > 1000);
}

template <class List>
bool is_listed(const std::string& type) {
  const auto names = names_of(specs_of<List>());
  return std::ranges::find(names, type) != names.end();
}

} // namespace

TEST_CASE("surfaces and shadowing that models declare are listed") {
  const auto check_masking = []<class M>(std::type_identity<M>) {
    if constexpr (requires { M::exact_for_surface; }) CHECK(is_listed<simulation::Surface>(M::exact_for_surface));
    if constexpr (requires { M::default_shadowing; }) CHECK(is_listed<Shadowing>(M::default_shadowing));
    return requires { M::exact_for_surface; };
  };
  CHECK(types_that<Masking>(check_masking) == "v_cavity");
  const auto check_distribution = []<class D>(std::type_identity<D>) {
    if constexpr (requires { D::UnitShape::simulated_surface; })
      CHECK(is_listed<simulation::Surface>(D::UnitShape::simulated_surface));
    return requires { D::UnitShape::simulated_surface; };
  };
  CHECK(types_that<Distribution>(check_distribution) == "beckmann and ggx");
}

TEST_CASE("a Gaussian surface has the slopes that are asked, on facets") {
  for (const double alpha : {0.1, 0.6, 1.0})
    for (const double cells : {4.0, 8.0}) {
      const Table table = statistics(mesh("gaussian", alpha, 256, cells), 2);
      for (std::size_t row = 0; row < 2; ++row) {
        CHECK(relative(at(table, row, "alpha_x"), alpha) < 1e-5); // heights are floats
        CHECK(relative(at(table, row, "alpha_y"), alpha) < 1e-5);
        CHECK(std::fabs(at(table, row, "correlation")) < 1e-5);
        check_histogram(table, row);
      }
    }
}

TEST_CASE("alpha = 2 h / L, less what a facet averages away") {
  // The variance of a difference over a cell is (1 - exp(-1/L^2)) L^2 of the derivative's.
  const double length = 8;
  const Table table = statistics(mesh("gaussian", 0.5, 256, length));
  const double of_derivative = 2 * at(table, 0, "rms_height") / length;
  CHECK(of_derivative * std::sqrt(-std::expm1(-1 / (length * length))) * length == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("anisotropic, correlated and sheared surfaces") {
  const Table gaussian = statistics(general("gaussian", 256, 6));
  CHECK(at(gaussian, 0, "alpha_x") == doctest::Approx(0.3).epsilon(1e-4));
  CHECK(at(gaussian, 0, "alpha_y") == doctest::Approx(0.8).epsilon(1e-4));
  CHECK(at(gaussian, 0, "correlation") == doctest::Approx(-0.4).epsilon(1e-4));
  CHECK(at(gaussian, 0, "mean_x") == doctest::Approx(0.2).epsilon(1e-5));
  CHECK(at(gaussian, 0, "mean_y") == doctest::Approx(-0.1).epsilon(1e-5));
  check_histogram(gaussian, 0);
  const Table ggx = statistics(general("ggx", 512, 8));
  CHECK(at(ggx, 0, "alpha_x") == doctest::Approx(0.3).epsilon(0.02));
  CHECK(at(ggx, 0, "alpha_y") == doctest::Approx(0.8).epsilon(0.02));
  CHECK(at(ggx, 0, "correlation") == doctest::Approx(-0.4).epsilon(0.05));
}

TEST_CASE("an exponential autocorrelation, whose slopes the cells decide") {
  ModelChoice choice = mesh("gaussian", 0.4, 256, 16);
  choice.values.set("autocorrelation", std::string("exponential"));
  const Table table = statistics(choice);
  CHECK(relative(at(table, 0, "alpha_x"), 0.4) < 1e-5);
  CHECK(relative(at(table, 0, "alpha_y"), 0.4) < 1e-5);
  check_histogram(table, 0);
}

TEST_CASE("the slopes of a GGX surface are GGX's") {
  const Table table = statistics(mesh("ggx", 0.5, 512, 8), 2);
  for (std::size_t row = 0; row < 2; ++row) {
    CHECK(relative(at(table, row, "alpha_x"), 0.5) < 0.01);
    CHECK(relative(at(table, row, "alpha_y"), 0.5) < 0.01);
    // No further from GGX than so many independent slopes are by chance, and half as far again.
    CHECK(at(table, row, "slope_distance") < 1.5 * at(table, row, "slope_distance_expected"));
    check_histogram(table, row);
  }
}

TEST_CASE("chi^2 sees a distribution that is not the one asked") {
  // GGX slopes held against Beckmann's, and a roughness wrong by a twentieth.
  const Surface gaussian = build_surface(mesh("gaussian", 0.5, 256, 8));
  CHECK(std::get<GaussianSurface>(gaussian).unit_slopes().share_within(1) == doctest::Approx(1 - std::exp(-1.0)));
  const Surface ggx = build_surface(mesh("ggx", 0.5, 256, 8));
  CHECK(std::get<GgxSurface>(ggx).unit_slopes().share_within(1) == 0.5);
  const Table coarse = statistics(mesh("ggx", 0.5, 512, 2));
  const double degrees = at(coarse, 0, "degrees_of_freedom");
  CHECK(at(coarse, 0, "chi2") > degrees + 5 * std::sqrt(2 * degrees)); // cells of half a correlation length
}

TEST_CASE("V-cavities have the normals of their distribution") {
  for (const char* slopes : {"beckmann", "ggx"}) {
    ModelChoice choice = surface("v_cavity", 0.6);
    choice.values.set("slopes", std::string(slopes));
    choice.values.set("pairs", 4096.0);
    const Table table = statistics(choice);
    CHECK(relative(at(table, 0, "alpha_x"), 0.6) < 0.03);
    CHECK(relative(at(table, 0, "alpha_y"), 0.6) < 0.03);
    check_histogram(table, 0);
  }
}

TEST_CASE("what is wrong with a surface") {
  const auto problem = [](const ModelChoice& choice) -> std::string {
    try {
      build_surface(choice);
    } catch (const SceneError& error) {
      return error.pointer() + ": " + error.reason();
    }
    return "";
  };
  CHECK(problem(mesh("gaussian", 0.5, 64, 8)) == "");
  CHECK(problem(mesh("gausian", 0.5, 64, 8)).starts_with("/surface/type: unknown type \"gausian\"; did you mean"));
  CHECK(problem(mesh("gaussian", -1, 64, 8)) == "/surface/alpha: found -1, accepted: a number in [1e-06, 1e+06]");
  CHECK(problem(mesh("gaussian", 0.5, 64.5, 8)).starts_with("/surface/samples: found 64.5, accepted: a whole number"));
  CHECK(problem(mesh("gaussian", 0.5, 64, 17)).starts_with("/surface/correlation_length: found 17, accepted: "));
}
