#include "integrate/slope_domain.hpp"

#include "../materials.hpp"
#include "brdf/blocks/surface_quantities.hpp"
#include "brdf/blocks/viewer_rows.hpp"
#include "brdf/integrals/kinks.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace brdfplot;
using namespace test;

TEST_CASE("a kink of a masking function is found by its switch as well as by the line that it is") {
  // The V-cavity's is both: the charts that know the line, and the rays that are cut where the switch changes its sign.
  for (const double alpha : {0.05, 0.4, 1.5})
    for (const double theta : {0.0, 0.3, 1.2, 1.55}) {
      const Material m = material("beckmann", alpha, "v_cavity");
      const Microsurface& surface = m.surface();
      const Direction o = from_angles(theta, 0.4);
      ViewerRows rows(o);
      FacingIntegrand f;
      f.value = [&](const std::vector<Direction>& normals, std::vector<double>& out) {
        evaluate(surface, Quantity::d_visible,
                 rows.with_normals(normals.size(), [&](std::size_t k) { return normals[k]; }), out.data());
      };
      f.symmetric = true;
      f.kink = true;
      const SlopeFrame frame(surface.slopes(), o);
      const Estimate by_line = integrate_facing(frame, f, 1e-10);
      f.kink = false;
      f.switches = {{[&](const std::vector<Direction>& normals, std::vector<double>& out) {
        for (std::size_t k = 0; k < normals.size(); ++k)
          out[k] = VCavity::kink(surface.slopes().project(o), dot(o, normals[k]), normals[k].z);
      }}};
      const Estimate by_switch = integrate_facing(frame, f, 1e-10);
      CAPTURE(alpha);
      CAPTURE(theta);
      CHECK(by_line.error <= 1e-10);
      CHECK(by_switch.error <= 1e-10);
      CHECK(std::fabs(by_switch.value - by_line.value) <= by_switch.error + by_line.error);
      CHECK(std::fabs(by_switch.value - 1) <= by_switch.error + 1e-14);
    }
}
