/// Reflectances against complex arithmetic in multiprecision.
#include "accuracy/measure.hpp"
#include "microfacet/fresnel.hpp"

#include <doctest/doctest.h>

namespace {

using namespace brdfplot;
using namespace brdfplot::accuracy;

/// Cosines uniform, grazing and near the normal.
double draw_cosine(Random& random) {
  const double kind = random.uniform();
  if (kind < 0.5) return random.uniform();
  return kind < 0.75 ? random.log_uniform(1e-300, 1) : 1 - random.log_uniform(1e-16, 1);
}

} // namespace

TEST_CASE("accuracy: Fresnel") {
  Row schlick("Fresnel (Schlick)", "double", "scalar", "f0 in [0; 1]", bounds::schlick);
  Row dielectric("Fresnel (dielectric)", "double", "scalar", "eta in [1.3; 4]", bounds::dielectric);
  Row conductor("Fresnel (conductor)", "double", "scalar", "eta in [0.05; 5]; k in [0.5; 10]", bounds::conductor);
  Random random(6);
  for (std::size_t n = 0; n < inputs_per_row(); ++n) {
    const double c = draw_cosine(random), f0 = random.uniform(), eta = random.uniform(1.3, 4);
    const double n_metal = random.log_uniform(0.05, 5), k = random.uniform(0.5, 10);
    schlick.add(ulp_error(schlick_reflectance(c, f0, 1, 5), reference::schlick(Quad(c), Quad(f0), Quad(1), Quad(5))),
                [&] { return "c = " + text(c) + " f0 = " + text(f0); });
    dielectric.add(ulp_error(dielectric_reflectance(c, eta), reference::dielectric(Quad(c), Quad(eta))),
                   [&] { return "c = " + text(c) + " eta = " + text(eta); });
    conductor.add(
        ulp_error(conductor_reflectance(c, n_metal, k), reference::conductor(Quad(c), Quad(n_metal), Quad(k))),
        [&] { return "c = " + text(c) + " eta = " + text(n_metal) + " k = " + text(k); });
  }
  finish(schlick);
  finish(dielectric);
  finish(conductor);
}
