#include "brdf/measured/merl_writer.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/parallel.hpp"
#include "brdf/blocks/viewer_rows.hpp"
#include "brdf/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace brdfplot {

namespace {

std::string place_of(const HalfDifference& at) {
  return " at theta_h " + format_number(at.theta_h) + ", theta_d " + format_number(at.theta_d) + ", phi_d " +
         format_number(at.phi_d);
}

void require_isotropic(const Material& material) {
  for (const WeightedTerm& term : material.terms) {
    if (!term.is_isotropic())
      throw InputError(material.name, "found the term \"" + term.name +
                                          "\", which is not isotropic, or not known to be; accepted: an isotropic "
                                          "BRDF, since a MERL file has no phi_h");
  }
  if (!material.mesosurface().centred())
    throw InputError(material.name, "found a mean slope; accepted: (0, 0), since a MERL file has no phi_h");
}

/// rho of some cells. `exchanged`: with viewer and light in each other's place.
void evaluate_cells(const Material& material, std::span<const HalfDifference> at, bool exchanged,
                    std::span<std::array<double, 3>> rho) {
  const std::size_t n = at.size();
  const auto channels = static_cast<std::size_t>(material.channels());
  DirectionArrays o, i;
  o.resize(n);
  i.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const ViewerAndLight pair = pair_of(at[k]);
    o.set(k, exchanged ? pair.i : pair.o);
    i.set(k, exchanged ? pair.o : pair.i);
  }
  std::vector<double> values(channels * n);
  evaluate(material, Quantity::brdf, {n, o.view(), i.view(), {}}, values.data());
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t c = 0; c < 3; ++c) rho[k][c] = values[(channels > 1 ? c : 0) * n + k];
}

void require_finite(const Material& material, const HalfDifference& at, const std::array<double, 3>& rho) {
  for (const double value : rho)
    if (!std::isfinite(value) || value < 0)
      throw AccuracyError(material.name,
                          "found " + format_number(value) + place_of(at) + "; accepted: a finite number >= 0");
}

void require_reciprocal(const Material& material, const std::vector<HalfDifference>& at,
                        const std::vector<std::array<double, 3>>& rho) {
  constexpr std::size_t step = 101;
  constexpr double tolerance = 1e-6;
  std::vector<HalfDifference> some;
  for (std::size_t k = 0; k < at.size(); k += step) some.push_back(at[k]);
  std::vector<std::array<double, 3>> back(some.size());
  evaluate_cells(material, some, true, back);
  for (std::size_t k = 0; k < some.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double there = rho[k * step][c];
      if (std::fabs(there - back[k][c]) > tolerance * (there + back[k][c]))
        throw InputError(material.name, "found " + format_number(there) + ", and " + format_number(back[k][c]) +
                                            " with viewer and light exchanged," + place_of(some[k]) +
                                            "; accepted: a reciprocal BRDF, since a MERL file has half of phi_d");
    }
}

} // namespace

std::string merl_bytes(const Material& material, int threads, const MerlGrid& grid) {
  require_isotropic(material);
  return merl_bytes(grid, [&](const std::vector<HalfDifference>& at, std::vector<std::array<double, 3>>& rho) {
    rho.resize(at.size());
    constexpr std::size_t part = 1024;
    parallel_for((at.size() + part - 1) / part, threads, [&](std::size_t k) {
      const std::size_t first = k * part, count = std::min(part, at.size() - first);
      const auto out = std::span(rho).subspan(first, count);
      evaluate_cells(material, std::span(at).subspan(first, count), false, out);
      for (std::size_t n = 0; n < count; ++n) require_finite(material, at[first + n], out[n]);
    });
    require_reciprocal(material, at, rho);
  });
}

} // namespace brdfplot
