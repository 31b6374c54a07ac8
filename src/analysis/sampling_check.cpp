#include "analysis/sampling_check.hpp"

#include "analysis/integrals.hpp"
#include "analysis/sampling_parts.hpp"
#include "base/number.hpp"
#include "base/random.hpp"
#include "brdf/evaluate.hpp"
#include "sampling/points.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace brdfplot {

namespace {

std::vector<Direction> listed(const DirectionArrays& arrays) {
  std::vector<Direction> all;
  for (std::size_t k = 0; k < arrays.x.size(); ++k) all.push_back(arrays.view()[k]);
  return all;
}

/// What is looked at: the sampler at one viewer, and the density that it is held to.
class Trial {
public:
  Trial(const Material& material, const Sampler& sampler, const Direction& omega_o, const SamplingTest& test,
        const PairDensity& density)
      : material_(material), omega_o_(omega_o), test_(test), density_(density), parts_(parts_of(sampler, omega_o)) {
    DirectionArrays lights;
    sampler.sample(omega_o, points(PointKind::random, test.seed, 0, 0, test.samples), lights);
    lights_ = listed(lights);
  }

  SamplingFindings run() {
    SamplingFindings found;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      found.integral.add(parts_[p].integral(share_of(p), 0.1 * test_.integral_tolerance));
    test_cells(found);
    test_weights(found);
    test_cover(found);
    return found;
  }

private:
  void densities(const std::vector<Direction>& lights, std::vector<double>& out) const {
    ViewerRows rows(omega_o_);
    const Batch batch = rows.with_lights(lights.size(), [&](std::size_t k) { return lights[k]; });
    out.resize(lights.size());
    density_(batch.n, batch.o, batch.i, out.data());
  }

  /// What each part has of the density at each light, by what it adds to the sampler's own.
  std::vector<std::vector<double>> shares(const std::vector<Direction>& lights) const {
    std::vector<std::vector<double>> shares(parts_.size());
    std::vector<double> sums(lights.size(), 0);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      parts_[p].densities(lights, shares[p]);
      for (std::size_t k = 0; k < lights.size(); ++k) sums[k] += shares[p][k];
    }
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (std::size_t k = 0; k < lights.size(); ++k)
        shares[p][k] = sums[k] > 0 ? shares[p][k] / sums[k] : p == 0 ? 1 : 0;
    return shares;
  }

  LightDensity share_of(std::size_t p) const {
    return [this, p](const std::vector<Direction>& lights, std::vector<double>& out) {
      densities(lights, out);
      if (parts_.size() == 1) return;
      const std::vector<double> share = shares(lights)[p];
      for (std::size_t k = 0; k < lights.size(); ++k) out[k] *= share[k];
    };
  }

  /// Pearson's test. Samples fall to a part by chance, as its share says.
  void test_cells(SamplingFindings& found) const {
    std::vector<std::vector<Estimate>> expected;
    std::vector<std::vector<double>> counts;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      expected.push_back(parts_[p].integrals_over_cells(share_of(p)));
      counts.emplace_back(parts_[p].cell_count(), 0.0);
    }
    const auto of_part = shares(lights_);
    Random random(test_.seed, 1);
    std::vector<double> chances(parts_.size());
    for (std::size_t k = 0; k < lights_.size(); ++k) {
      for (std::size_t p = 0; p < parts_.size(); ++p) chances[p] = of_part[p][k];
      double u = random.uniform();
      const std::size_t p = chosen(chances, u);
      counts[p][parts_[p].cell_of(lights_[k])] += 1;
    }
    sum_cells(expected, counts, found);
  }

  /// The variance of a count is what is expected, and the square of its error.
  void sum_cells(const std::vector<std::vector<Estimate>>& expected, const std::vector<std::vector<double>>& counts,
                 SamplingFindings& found) const {
    constexpr double fewest = 10;
    const auto n = static_cast<double>(lights_.size());
    Estimate rest;
    double rest_count = 0;
    const auto add = [&](double mean, double error, double count) {
      found.chi_squared += (count - mean) * (count - mean) / (mean + error * error);
      ++found.cells;
    };
    for (std::size_t p = 0; p < expected.size(); ++p)
      for (std::size_t k = 0; k < expected[p].size(); ++k) {
        const Estimate& cell = expected[p][k];
        if (n * cell.value >= fewest) {
          add(n * cell.value, n * cell.error, counts[p][k]);
          continue;
        }
        rest.add(cell);
        rest_count += counts[p][k];
      }
    // What there is in cells of few counts as one; where hardly anything is expected, one sample is not yet a fault.
    if (rest_count > 0 || rest.value > 0) add(std::fmax(n * rest.value, 1.0), n * rest.error, rest_count);
    const double freedom = std::fmax(static_cast<double>(found.cells) - 1, 1.0);
    found.p_value = std::isfinite(found.chi_squared) ? boost::math::gamma_q(0.5 * freedom, 0.5 * found.chi_squared) : 0;
  }

  void test_weights(SamplingFindings& found) const {
    const std::size_t n = lights_.size();
    const auto channels = static_cast<std::size_t>(material_.channels());
    std::vector<double> pdf, brdf_cos(channels * n);
    densities(lights_, pdf);
    ViewerRows rows(omega_o_);
    evaluate(material_, Quantity::brdf_cos, rows.with_lights(n, [&](std::size_t k) { return lights_[k]; }),
             brdf_cos.data());
    count_faults(pdf, brdf_cos, found);
    constexpr double accuracy = 1e-7;
    const ColourEstimate albedo = compute_channels(Integral::albedo, material_, omega_o_, accuracy);
    for (std::size_t c = 0; c < channels; ++c) {
      double sum = 0, squares = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const double f = brdf_cos[c * n + k], weight = f > 0 && pdf[k] > 0 ? f / pdf[k] : 0;
        sum += weight;
        squares += weight * weight;
        found.largest_weight = std::fmax(found.largest_weight, weight);
      }
      const auto count = static_cast<double>(n);
      const double mean = sum / count, variance = std::fmax(squares / count - mean * mean, 0.0);
      const double error = std::sqrt(variance / (count - 1));
      // Rare samples may all be missing, and the error from those there are be too small: it is at least one of them.
      const double least = std::hypot(error, mean / count);
      const double apart = std::fabs(mean - albedo.value[c]) / std::hypot(least, albedo.error[c], 1e-300);
      if (c > 0 && !(apart > found.errors_apart)) continue;
      found.mean_weight = mean;
      found.standard_error = least;
      found.albedo = albedo.value[c];
      found.errors_apart = apart;
    }
    if (found.uncovered == 0) test_squares(pdf, brdf_cos, found);
  }

  /// The second moment, of the first channel.
  void test_squares(const std::vector<double>& pdf, const std::vector<double>& brdf_cos,
                    SamplingFindings& found) const {
    const auto count = static_cast<double>(lights_.size());
    double squares = 0, fourths = 0, largest = 0;
    for (std::size_t k = 0; k < lights_.size(); ++k) {
      const double weight = brdf_cos[k] > 0 && pdf[k] > 0 ? brdf_cos[k] / pdf[k] : 0;
      squares += weight * weight;
      fourths += weight * weight * weight * weight;
      largest = std::fmax(largest, weight);
    }
    found.mean_square = squares / count;
    constexpr double accuracy = 1e-4;
    found.expected_square = weight_moment(2, material_, density_, omega_o_, accuracy * (1 + found.mean_square));
    // Few samples may weigh most, and all of them may be missing: then the samples know too little of how much their
    // mean square varies, and the fourth moment by quadrature says it. One sample of the largest weight is no fault.
    const double square = found.expected_square.value;
    const Estimate fourth =
        weight_moment(4, material_, density_, omega_o_, 0.05 * std::fmax(fourths / count, square * square));
    const double expected_fourth = std::isfinite(fourth.value) ? fourth.value - fourth.error : 0;
    const double variance =
        std::fmax(fourths / count - found.mean_square * found.mean_square, expected_fourth - square * square);
    largest = std::fmax(largest, largest_where_bright());
    found.largest_weight = std::fmax(found.largest_weight, largest);
    found.square_error = std::hypot(std::sqrt(std::fmax(variance, 0.0) / (count - 1)), largest * largest / count);
    found.squares_apart = std::fabs(found.mean_square - found.expected_square.value) /
                          std::hypot(found.square_error, found.expected_square.error, 1e-300);
  }

  /// The largest weight of the first channel that the density gives to directions that the default strategy draws.
  double largest_where_bright() const {
    DirectionArrays bright;
    Sampler(material_, "default").sample(omega_o_, points(PointKind::sobol, test_.seed, 3, 0, 4096), bright);
    std::vector<double> pdf, brdf_cos(static_cast<std::size_t>(material_.channels()) * bright.x.size());
    const std::vector<Direction> lights = listed(bright);
    densities(lights, pdf);
    ViewerRows rows(omega_o_);
    evaluate(material_, Quantity::brdf_cos, rows.with_lights(lights.size(), [&](std::size_t k) { return lights[k]; }),
             brdf_cos.data());
    double largest = 0;
    for (std::size_t k = 0; k < lights.size(); ++k)
      if (brdf_cos[k] > 0 && pdf[k] > 0) largest = std::fmax(largest, brdf_cos[k] / pdf[k]);
    return largest;
  }

  /// Directions all over the sphere that the sampler may not have drawn.
  void test_cover(SamplingFindings& found) const {
    std::vector<Direction> lights;
    for (const SamplePoint& point : points(PointKind::sobol, test_.seed, 2, 0, 1024)) {
      const double z = 2 * point[0] - 1, phi = 2 * std::numbers::pi * point[1], r = std::sqrt((1 - z) * (1 + z));
      lights.push_back({r * std::cos(phi), r * std::sin(phi), z});
    }
    std::vector<double> pdf, brdf_cos(static_cast<std::size_t>(material_.channels()) * lights.size());
    densities(lights, pdf);
    ViewerRows rows(omega_o_);
    evaluate(material_, Quantity::brdf_cos, rows.with_lights(lights.size(), [&](std::size_t k) { return lights[k]; }),
             brdf_cos.data());
    count_faults(pdf, brdf_cos, found);
  }

  static void count_faults(const std::vector<double>& pdf, const std::vector<double>& brdf_cos,
                           SamplingFindings& found) {
    for (std::size_t k = 0; k < pdf.size(); ++k) {
      if (!(pdf[k] >= 0 && pdf[k] < infinity)) ++found.untold;
      if (brdf_cos[k] > underflow_of_densities && pdf[k] == 0) ++found.uncovered;
    }
  }

  const Material& material_;
  Direction omega_o_;
  const SamplingTest& test_;
  const PairDensity& density_;
  std::vector<SamplingPart> parts_;
  std::vector<Direction> lights_;
};

} // namespace

std::vector<std::string> SamplingFindings::faults(const SamplingTest& test) const {
  std::vector<std::string> all;
  if (!(std::fabs(integral.value - 1) <= test.integral_tolerance && integral.error <= test.integral_tolerance))
    all.push_back("the density integrates to " + format_number(integral.value) + ", with an error of " +
                  format_number(integral.error));
  if (!(p_value >= test.significance))
    all.push_back("samples do not follow the density: chi-square " + format_number(chi_squared) + " in " +
                  std::to_string(cells) + " cells, p = " + format_number(p_value));
  if (!(errors_apart <= test.most_errors))
    all.push_back("the mean weight is " + format_number(mean_weight) + ", " + format_number(errors_apart) +
                  " standard errors from the albedo " + format_number(albedo));
  if (!(squares_apart <= test.most_errors))
    all.push_back("the mean square of the weights is " + format_number(mean_square) + ", " +
                  format_number(squares_apart) + " standard errors from " + format_number(expected_square.value) +
                  " by quadrature");
  if (untold > 0) all.push_back(std::to_string(untold) + " densities are negative or no number");
  if (uncovered > 0) all.push_back(std::to_string(uncovered) + " directions have a density of 0 and a BRDF above 0");
  return all;
}

bool SamplingFindings::holds(const SamplingTest& test) const { return faults(test).empty(); }

SamplingFindings check_sampling(const Material& material, const Sampler& sampler, const Direction& omega_o,
                                const SamplingTest& test, const PairDensity& density) {
  return Trial(material, sampler, omega_o, test, density).run();
}

SamplingFindings check_sampling(const Material& material, const Sampler& sampler, const Direction& omega_o,
                                const SamplingTest& test) {
  return check_sampling(material, sampler, omega_o, test, density_of(sampler));
}

double sidak(double significance, std::size_t n) {
  return -std::expm1(std::log1p(-significance) / static_cast<double>(n));
}

} // namespace brdfplot
