#include "brdf/blocks/kernel_choice.hpp"

#include "microfacet/masking/sheen_fit_coefficients.hpp"

namespace brdfplot {

std::optional<kernels::Distribution> density_kernel(const Distribution& distribution) {
  return std::visit(
      []<class D>(const D&) -> std::optional<kernels::Distribution> {
        if constexpr (requires { D::UnitShape::kernel; })
          return D::UnitShape::kernel;
        else
          return std::nullopt;
      },
      distribution);
}

std::optional<kernels::Distribution> smith_kernel(const Microsurface& surface) {
  const auto* smith = std::get_if<Smith>(&surface.masking);
  if (smith == nullptr || smith->lambda_of != Smith::LambdaOf::itself) return std::nullopt;
  return density_kernel(surface.distribution);
}

std::optional<WholeKernel> whole_kernel(const Microsurface& surface) {
  const auto distribution = smith_kernel(surface);
  if (!distribution) return std::nullopt;
  return std::visit(
      [&]<class S>(const S&) -> std::optional<WholeKernel> {
        if constexpr (requires { S::kernel; })
          return WholeKernel(*distribution, S::kernel);
        else
          return std::nullopt;
      },
      surface.shadowing);
}

std::optional<SheenKernel> sheen_kernel(const Microsurface& surface) {
  const auto* sheen = std::get_if<Sheen>(&surface.distribution);
  if (sheen == nullptr) return std::nullopt;
  const SheenFitCoefficients fit(sheen->profile.alpha);
  const kernels::SheenParameters parameters{sheen->profile.half_power(), fit.a, fit.b, fit.power, fit.d, fit.e};
  if (std::holds_alternative<Neubelt>(surface.shadowing))
    return SheenKernel{kernels::SheenMasking::unmasked, parameters};
  if (std::holds_alternative<SheenFit>(surface.masking) && std::holds_alternative<HeightCorrelated>(surface.shadowing))
    return SheenKernel{kernels::SheenMasking::fitted, parameters};
  return std::nullopt;
}

} // namespace brdfplot
