#include "analysis/integrals.hpp"
#include "choice/methods/problems.hpp"

#include <cmath>

namespace brdfplot::choice {

namespace {

Estimate weak_furnace_by(Integral integral, double alpha, double theta) {
  TermDescription term;
  term.distribution.type = "ggx";
  term.distribution.values.set("alpha", alpha);
  return compute(integral, build(term), from_angles(theta, 0));
}

Run<double> furnace_run(Integral integral) {
  return [integral](std::size_t n, const double* const* in, double* out) {
    for (std::size_t i = 0; i < n; ++i) out[i] = weak_furnace_by(integral, in[0][i], in[1][i]).value;
  };
}

} // namespace

Problem weak_furnace() {
  Problem p{
      .name = "weak_furnace",
      .doc = "Weak white furnace test of GGX with Smith's masking, which is 1",
      .source = "Heitz 2014, Eq. 36",
      .inputs = {{"alpha", "roughness", 1e-3, 1, Scale::logarithmic}, {"theta_o", "polar angle of the viewer", 0, 1.5}},
      .exact =
          [](std::span<const double>) {
            return Exact{1, 0};
          },
      .least = 0,
      .samples = 100};
  p.methods.push_back({.name = "grid",
                       .doc = "a sum over steps of 0.05 rad",
                       .source = "Heitz 2014, Appendix C",
                       .kind = Kind::quadrature,
                       .run = furnace_run(Integral::weak_furnace_grid)});
  p.methods.push_back({.name = "kernel",
                       .doc = "the quadrature of this program, in slopes scaled by the roughness",
                       .source = "Heitz 2014, Eq. 36",
                       .kind = Kind::kernel,
                       .run = furnace_run(Integral::weak_furnace),
                       .stated_error = [](std::span<const double> x) {
                         return weak_furnace_by(Integral::weak_furnace, x[0], x[1]).error;
                       }});
  return p;
}

} // namespace brdfplot::choice
