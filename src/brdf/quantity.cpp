#include "brdf/quantity.hpp"

#include <cmath>

namespace brdfplot {

const std::vector<QuantityInfo>& quantities() {
  static const std::vector<QuantityInfo> all = {
      {Quantity::lambda, "lambda", "Lambda(o), Smith's auxiliary function", {.o = true}, Owner::microsurface},
      {Quantity::p22, "p22", "density of slopes at the slope of m", {.m = true}, Owner::microsurface},
      {Quantity::d, "d", "D(m), distribution of normals, 1/sr", {.m = true}, Owner::microsurface},
      {Quantity::d_cos, "d_cos", "(m.g) D(m), 1/sr", {.m = true}, Owner::microsurface},
      {Quantity::g1, "g1", "G1(o, m), masking", {.o = true, .m = true}, Owner::microsurface},
      {Quantity::g2, "g2", "G2(o, i, m), masking and shadowing", {.o = true, .i = true}, Owner::microsurface},
      {Quantity::d_visible,
       "d_visible",
       "D_o(m), distribution of visible normals, 1/sr",
       {.o = true, .m = true},
       Owner::microsurface},
      {Quantity::fresnel, "fresnel", "F(o.m)", {.o = true, .m = true}, Owner::fresnel},
      {Quantity::brdf, "brdf", "rho(o, i), 1/sr", {.o = true, .i = true}, Owner::material},
      {Quantity::brdf_cos, "brdf_cos", "rho(o, i) cos theta_i, 1/sr", {.o = true, .i = true}, Owner::material},
  };
  return all;
}

const QuantityInfo& info_of(Quantity quantity) { return quantities()[static_cast<std::size_t>(quantity)]; }

bool is_told(Quantity quantity, double value) {
  return std::isfinite(value) || (quantity == Quantity::lambda && value == infinity);
}

Batch used_by(Quantity quantity, const Batch& batch) {
  Batch used = batch;
  if (quantity == Quantity::brdf || quantity == Quantity::brdf_cos) used.m = {};
  return used;
}

} // namespace brdfplot
