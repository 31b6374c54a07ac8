#include "brdf/terms/rgl.hpp"

#include "base/threads/interrupt.hpp"
#include "brdf/measured/measured_file.hpp"
#include "brdf/measured/rgl_table.hpp"
#include "brdf/terms/diffuse/flat.hpp"
#include "math/cubature.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace brdfplot {

ModelSpec Rgl::spec() {
  return {.type = "rgl",
          .doc = "measured: a tensor file of the RGL material database, its array rgb",
          .source = "Dupuy and Jakob 2018",
          .parameters = {
              {.key = "file", .kind = ParameterKind::text, .doc = "RGL .bsdf, relative to the file that names it"}}};
}

Rgl Rgl::from(const TermDescription& description) {
  return {measured_file<RglTable>(completed_values<Rgl>(description).text("file"), read_rgl)};
}

bool Rgl::isotropic() const { return table->isotropic(); }

void Rgl::evaluate(const PairBlock& block, SurfaceBlock&, const ChannelRows& out) const {
  for (std::size_t k = 0; k < block.n; ++k) {
    const Direction o = block.o[k], i = block.i[k];
    const bool above = o.z > 0 && i.z > 0;
    const Rgb value = above ? table->value(o, i) : Rgb{};
    for (std::size_t c = 0; c < 3; ++c) out.rho[c][k] = block.times_cosine || !above ? value[c] : value[c] / i.z;
  }
}

ColourEstimate Rgl::reflected_light(const Direction& omega_o, double tolerance, const ChannelRange& channels,
                                    const std::function<double(const Direction& omega_i)>& weight) const {
  using std::numbers::pi;
  const double sin_o = std::hypot(omega_o.x, omega_o.y);
  const Direction along = sin_o > 0 ? (1 / sin_o) * Direction{omega_o.x, omega_o.y, 0} : Direction{1, 0, 0};
  // x: a part of what is above the horizon of u = sqrt(2 theta_h / pi); y: phi_h from the viewer's, in half turns.
  const PlaneFunction f = [&](std::size_t, const double* x, const double* y, double* out, std::size_t n) {
    throw_if_interrupted();
    for (std::size_t k = 0; k < n; ++k) {
      const double c = std::cos(pi * y[k]), s = std::sin(pi * y[k]);
      // i.z > 0: cos theta_o cos 2 theta_h + sin theta_o cos phi sin 2 theta_h > 0.
      const double last = std::sqrt(std::atan2(omega_o.z, -sin_o * c) / pi);
      const double u = x[k] * last, theta = 0.5 * pi * u * u, sin_h = std::sin(theta);
      const Direction h = {sin_h * (c * along.x - s * along.y), sin_h * (s * along.x + c * along.y), std::cos(theta)};
      const Direction i = reflected(omega_o, h);
      const double facing = dot(omega_o, h);
      const bool above = facing > 0 && i.z > 0;
      // d omega_i = 4 (o.h) sin theta_h dtheta_h dphi.
      const double scale = above ? 4 * facing * sin_h * pi * u * last * pi * weight(i) : 0;
      const Rgb value = above ? table->value(omega_o, i) : Rgb{};
      for (std::size_t channel = 0; channel < channels.count; ++channel)
        out[channel * n + k] = scale * value[channels.first + channel];
    }
  };
  constexpr int parts_x = 8, parts_y = 8;
  std::vector<Rectangle> rectangles;
  for (int p = 0; p < parts_x; ++p)
    for (int q = 0; q < parts_y; ++q)
      rectangles.push_back(
          {p * 1.0 / parts_x, (p + 1) * 1.0 / parts_x, q * 2.0 / parts_y - 1, (q + 1) * 2.0 / parts_y - 1});
  return integrate_plane(f, channels.count, rectangles, {.absolute = tolerance});
}

} // namespace brdfplot
