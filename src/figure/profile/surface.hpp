/// \file
/// The surfaces that a profile may be cut from: those that are generated for rays, and two that only a model has.
#pragma once

#include "figure/profile/profile.hpp"
#include "simulation/surfaces/gaussian.hpp"
#include "simulation/surfaces/ggx.hpp"
#include "simulation/surfaces/v_cavity.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace brdfplot::plot {

/// What can be asked of a surface, whatever its parameters.
struct SurfaceFacts {
  bool joined = true;       ///< else it stops no rays
  bool has_heights = false; ///< random ones, that correlate, and that Smith's model is of
  bool cavities = false;    ///< each cut is of a surface of its own, with two normals
};

/// The surface of Smith's model (Heitz 2014, section 4.1): facets of unit width whose heights and slopes are
/// independent of each other and of their neighbours', both Gaussian.
struct UncorrelatedSurface {
  static constexpr SurfaceFacts facts{.joined = false, .has_heights = true};
  static constexpr const char* slopes = "beckmann";

  double alpha = 1;
  double rms_height = 1;
  double samples = 4096;

  static ModelSpec spec();
  static UncorrelatedSurface from(const Values& values);
  std::optional<ParameterError> problem() const;
};

/// The geometric surface itself.
struct FlatSurface {
  static constexpr SurfaceFacts facts{};

  static ModelSpec spec() {
    return {.type = "flat", .doc = "the geometric surface", .source = "Heitz 2014, section 2.2"};
  }
  static FlatSurface from(const Values&) { return {}; }
  std::optional<ParameterError> problem() const { return std::nullopt; }
};

using ProfileSurface = std::variant<simulation::GaussianSurface, //
                                    simulation::GgxSurface,      //
                                    simulation::VCavitySurface,  //
                                    UncorrelatedSurface,         //
                                    FlatSurface>;

/// Of a surface without a problem.
SurfaceFacts facts_of(const ModelChoice& choice);

/// What is wrong with the choice of a surface, if anything is.
std::optional<ParameterError> problem_of(const ModelChoice& choice);

/// How many parallel cuts there are of a surface without a problem.
std::size_t cut_count(const ModelChoice& choice);

/// An autocorrelation of heights: exp(-(d / length)^2), or exp(-d / length).
struct HeightLaw {
  simulation::Autocorrelation shape = simulation::Autocorrelation::gaussian;
  double length = 1; ///< in facets

  [[nodiscard]] double at(double distance) const;
};

/// The parallel cuts through one surface.
class Cuts {
public:
  /// Cuts along x, or along y. V-cavities have one cut for each pair of normals, across its ridges.
  /// \throws InputError for what problem_of() tells.
  Cuts(const ModelChoice& choice, std::uint64_t seed, bool along_y);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Profile profile(std::size_t k) const;
  /// Which cuts are of one surface with cut k: all of them, but each pair of V-cavities is a surface of its own.
  [[nodiscard]] std::vector<std::size_t> surface_of(std::size_t k) const;

  /// What the model of the profile has for G1 of the facets of cut k that face theta, on the distorted surface:
  /// 1 / (1 + Lambda) (Smith; Heitz 2014, Eq. 43), of V-cavities Eq. 49; none for a flat surface.
  [[nodiscard]] std::optional<double> g1(std::size_t k, double theta, const Distortion& distortion) const;
  [[nodiscard]] bool cavities() const { return cavities_; }
  /// Of V-cavities: the angle of both normals of pair k from the geometric one.
  [[nodiscard]] double theta_m(std::size_t k) const;
  [[nodiscard]] bool is_independent() const { return only_.independent.has_value(); }

  /// The autocorrelation that the surface is made with, along the cuts; none where it has no closed form.
  [[nodiscard]] const std::optional<HeightLaw>& law() const { return law_; }

  /// The distance at which the autocorrelation of heights is 1/e, in facets; of independent ones that of neighbours, 1.
  [[nodiscard]] std::size_t correlation_length() const;

private:
  [[nodiscard]] std::vector<double> heights(std::size_t k) const;

  std::shared_ptr<const simulation::Realisation> realised_; ///< none: the profile is `only_`
  Profile only_;
  std::string slopes_; ///< type of the distribution, none for cavities and the flat surface
  double alpha_ = 0;   ///< in the plane of the cut
  bool cavities_ = false;
  bool along_y_ = false;
  std::size_t count_ = 1;
  std::optional<HeightLaw> law_{};
};

/// Mean of h(x) h(x + distance) over that of h^2, over all cuts, for each distance in facets.
std::vector<double> autocorrelation(const Cuts& cuts, const std::vector<std::size_t>& distances);

} // namespace brdfplot::plot
