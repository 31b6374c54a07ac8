#include "choice/advise/shader/sampling_cost.hpp"

#include "base/errors.hpp"
#include "choice/advise/shader/cost.hpp"
#include "choice/advise/shader/mirror.hpp"
#include "choice/advise/shader/sampling_forms.hpp"
#include "choice/methods/newton_slope.hpp"

namespace brdfplot::choice {

namespace {

using forms::Counted3;

const Counted u1 = 0.3, u2 = 0.6, alpha_x = 0.3, alpha_y = 0.4;

/// A normal as facets cover the ground, and o mirrored there with D(m) m.g / (4 o.m).
void draw_ground(bool ggx) {
  const auto [x, y] = forms::polar(ggx ? forms::ground_slope_ggx(u1) : forms::ground_slope_beckmann(u1), u2);
  const Counted3 o = forms::viewer(), m = forms::stretched_normal({x, y}, Counted(1), Counted(0), alpha_x, alpha_y);
  (void)forms::mirrored(o, m);
  (void)(Counted(0.5) * m.z / (Counted(4) * forms::dot(o, m)));
}

/// A normal as it is seen, and o mirrored there with D(m) / (4 (c + c Lambda)).
void draw_visible(bool ggx, bool on_disc) {
  const Counted3 o = forms::viewer();
  const forms::StretchedViewer<Counted> v(o, alpha_x, alpha_y);
  forms::UnitSlopes<Counted> slopes{};
  if (!ggx) {
    const NewtonSlope newton{3};
    slopes = {newton(std::array{acos(v.c), u1}), erf_inverse(Counted(2) * u2 - Counted(1))};
  } else {
    slopes = on_disc ? forms::visible_slopes_ggx_2018(v.c, v.s, u1, u2) : forms::visible_slopes_ggx(v.c, v.s, u1, u2);
  }
  (void)forms::mirrored(o, forms::stretched_normal(slopes, v.x, v.y, alpha_x, alpha_y));
  (void)(Counted(0.25) * Counted(0.5) / (o.z + Counted(0.5)));
}

/// Draws a direction, with its density of what the BRDF has anyhow.
void draw(const std::string& strategy, bool ggx) {
  if (strategy == "half_vector") return draw_ground(ggx);
  if (strategy != "cosine") return draw_visible(ggx, strategy == "heitz_2018");
  (void)(forms::cosine_lobe(u1, u2).z * Counted(std::numbers::inv_pi));
}

} // namespace

Operations sampling_operations(const MaterialDescription& material, const std::string& strategy) {
  const TermDescription& term = material.terms.front();
  const bool ggx = term.distribution.type == "ggx";
  const std::string kind = strategy == "default" ? "visible_normals" : strategy;
  const bool known =
      kind == "cosine" || kind == "half_vector" || kind == "visible_normals" || (kind == "heitz_2018" && ggx);
  if (material.terms.size() != 1 || term.type != "mirror" || !(ggx || term.distribution.type == "beckmann") || !known)
    throw InputError(material.name, "the cost of a sample is counted for one mirror of ggx or beckmann by cosine, "
                                    "half_vector or visible_normals, of ggx by heitz_2018 too");
  const ShaderOperations brdf = shader_operations(material);
  Operations all = counted([&] {
    draw(kind, ggx);
    return Counted(1) / Counted(0.5);
  });
  all += brdf.view;
  all += brdf.light;
  return all;
}

} // namespace brdfplot::choice
