/// \file
/// A weighted sum of distributions (Cook and Torrance 1982; Kulla and Conty 2017).
#pragma once

#include "microfacet/slopes.hpp"
#include "models/registry.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace brdfplot {

/// D = sum w_k D_k, over the distributions of `List`, with weights that are divided by their sum. The visible area is
/// linear in D, and so is Smith's c Lambda (Heitz 2014, Eqs. 41-43). The parts may lie on mesosurfaces of their own, as
/// normals that are averaged do: that of the whole has the mean of their slopes, sum w_k mean_k, which is where
/// int <o,m> D dm over all normals is c_o (Akenine-Moller et al. 2018, Eq. 9.22). A part may be seen from below its
/// own; its area is then c_k + c_k Lambda_k of a c_k < 0, as masked_area() has it.
template <class List>
struct MixtureOf {
  struct Part {
    double weight = 1; ///< of a sum of 1
    List distribution;

    const SlopeMap& slopes() const {
      return std::visit([](const auto& d) -> const SlopeMap& { return d.slopes; }, distribution);
    }
  };

  SlopeMap slopes; ///< the mesosurface; the roughness is a scale to start from: that of the smoothest part
  std::vector<Part> parts;

  static ModelSpec spec() {
    return {.type = "mixture",
            .doc = "weighted sum of other distributions",
            .source = "Cook and Torrance 1982; Kulla and Conty 2017; Heitz 2014, Eq. 41",
            .parameters = {{.key = "components",
                            .kind = ParameterKind::components,
                            .bounds = {.min = 1e-100, .max = 1e100},
                            .doc = "what is summed; the weights are divided by their sum",
                            .models = []() -> const std::vector<ModelSpec>& { return specs_of<List>(); }}}};
  }

  static Made<MixtureOf> from(const Values& values) {
    MixtureOf mixture;
    double sum = 0;
    for (const WeightedChoice& component : values.components("components")) {
      const std::string at = "components/" + std::to_string(mixture.parts.size());
      auto made = make_model<List>(component.model);
      if (const auto* error = std::get_if<ParameterError>(&made))
        return ParameterError{at + "/distribution" + (error->key.empty() ? "" : "/" + error->key), error->what};
      mixture.parts.push_back({component.weight, std::get<List>(std::move(made))});
      sum += component.weight;
    }
    for (Part& part : mixture.parts) part.weight /= sum;
    mixture.slopes = mixture.common_slopes();
    return mixture;
  }
  static constexpr bool shape_invariant = false;

  bool has_one_mesosurface() const {
    const SlopeMap& first = parts.front().slopes();
    return std::ranges::all_of(parts, [&](const Part& part) {
      return part.slopes().mean_x == first.mean_x && part.slopes().mean_y == first.mean_y;
    });
  }

  double p22(double slope_x, double slope_y) const {
    return summed([&](const auto& d) { return d.p22(slope_x, slope_y); });
  }
  double density(const Direction& omega_m) const {
    return summed([&](const auto& d) { return d.density(omega_m); });
  }
  void densities(const kernels::Vectors<double>& m, double* d, std::size_t n) const {
    std::fill_n(d, n, 0.0);
    std::vector<double> of_part(n);
    for (const Part& part : parts) {
      std::visit([&](const auto& distribution) { distribution.densities(m, of_part.data(), n); }, part.distribution);
      for (std::size_t k = 0; k < n; ++k) d[k] += part.weight * of_part[k];
    }
  }

private:
  template <class F>
  double summed(const F& f) const {
    double sum = 0;
    for (const Part& part : parts) sum += part.weight * std::visit(f, part.distribution);
    return sum;
  }
  SlopeMap common_slopes() const {
    // Smoothest among those that are not isotropic, if any, so that the mixture never seems to be.
    const auto order = [](const Part& part) {
      const SlopeMap& map = part.slopes();
      return std::pair(map.alpha_x == map.alpha_y && map.correlation == 0, map.determinant());
    };
    SlopeMap common = std::ranges::min_element(parts, {}, order)->slopes();
    if (has_one_mesosurface()) return common;
    common.mean_x = common.mean_y = 0;
    for (const Part& part : parts) {
      common.mean_x += part.weight * part.slopes().mean_x;
      common.mean_y += part.weight * part.slopes().mean_y;
    }
    return common;
  }
};

} // namespace brdfplot
