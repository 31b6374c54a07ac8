#include "microfacet/microsurface.hpp"

#include <algorithm>

namespace brdfplot {

namespace {

std::string default_shadowing(const Masking& masking) {
  return std::visit(
      []<class M>(const M& m) -> std::string {
        if constexpr (requires { M::default_shadowing; })
          return M::default_shadowing;
        else
          return m.has_lambda ? "height_correlated" : "separable";
      },
      masking);
}

/// A published fit is for one distribution alone.
void require_own_distribution(const MicrosurfaceDescription& description, const Microsurface& surface) {
  std::visit(
      [&]<class M>(const M&) {
        if constexpr (requires { typename M::FitsOnly; })
          if (!std::holds_alternative<typename M::FitsOnly>(surface.distribution))
            throw MaterialError("/masking/type", "\"" + description.masking.type +
                                                     "\" is a fit for the distribution \"" + M::FitsOnly::spec().type +
                                                     "\" alone, found \"" + description.distribution.type +
                                                     "\"; accepted with any: smith");
      },
      surface.masking);
}

template <class D>
bool mean_slope_is_infinite(const D& distribution) {
  if constexpr (requires { distribution.parts; })
    return std::ranges::any_of(distribution.parts, [](const auto& part) {
      return std::visit([](const auto& d) { return mean_slope_is_infinite(d); }, part.distribution);
    });
  else
    return requires { distribution.profile.infinite_mean_slope; };
}

void require_finite_lambda(const Microsurface& surface) {
  const bool takes_lambda = std::visit(
      [](const auto& m) {
        if constexpr (requires { m.takes_lambda_of_distribution(); })
          return m.takes_lambda_of_distribution();
        else
          return false;
      },
      surface.masking);
  if (!takes_lambda) return;
  if (has_infinite_mean_slope(surface.distribution))
    throw MaterialError("/masking/type", "\"smith\" has an infinite Lambda with this distribution, whose mean slope is "
                                         "infinite (\"oren_nayar\"); accepted with any: v_cavity");
}

void require_lambda_of_shadowing(const MicrosurfaceDescription& description, const std::string& shadowing,
                                 const Microsurface& surface) {
  const bool needs_lambda = std::visit([](const auto& s) { return s.needs_lambda; }, surface.shadowing);
  if (needs_lambda && !surface.has_lambda())
    throw MaterialError("/shadowing/type", "\"" + shadowing + "\" needs a masking function with a Lambda, and \"" +
                                               description.masking.type +
                                               "\" has none; accepted: none, separable, minimum, direction_correlated");
}

} // namespace

bool has_infinite_mean_slope(const Distribution& distribution) {
  return std::visit([](const auto& d) { return mean_slope_is_infinite(d); }, distribution);
}

bool Microsurface::has_lambda() const {
  return std::visit([](const auto& m) { return m.has_lambda; }, masking);
}

const SlopeMap& Microsurface::slopes() const {
  return std::visit([](const auto& d) -> const SlopeMap& { return d.slopes; }, distribution);
}

Microsurface build_microsurface(const MicrosurfaceDescription& description) {
  Microsurface surface{make_or_throw<Distribution>("distribution", description.distribution),
                       make_or_throw<Masking>("masking", description.masking),
                       {}};
  require_own_distribution(description, surface);
  require_finite_lambda(surface);
  const ModelChoice shadowing = description.shadowing.value_or(ModelChoice{.type = default_shadowing(surface.masking)});
  surface.shadowing = make_or_throw<Shadowing>("shadowing", shadowing);
  require_lambda_of_shadowing(description, shadowing.type, surface);
  return surface;
}

} // namespace brdfplot
