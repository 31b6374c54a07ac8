/// \file
/// A figure before it is computed: which quantities of which materials are swept over what. The JSON of a figure is
/// read into this; compute() turns it into a Figure.
#pragma once

#include "brdf/material.hpp"
#include "draw/model.hpp"
#include "figure/numbers.hpp"
#include "simulation/store.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace brdfplot::plot {

/// An angle that follows another of the same configuration: sign times it, plus an offset (radians).
struct Tie {
  std::string to; ///< theta_o, phi_o, theta_i, phi_i, theta_m or phi_m
  double sign = 1;
  double offset = 0;
};

/// A variable with its value; what is set is not swept. Variables are
/// - directions: theta_o, phi_o, theta_i, phi_i, theta_m, phi_m (radians);
/// - or, instead of those of o and i, their half and difference angles: theta_h, phi_h, theta_d, phi_d (see
///   math/half_difference.hpp); the thetas both, a phi that is not set is 0;
/// - `a`: theta_o such that 1 / (alpha_o tan theta_o) = a; `slope`: theta_m = atan slope;
/// - transformations of the whole configuration, directions included: stretch_x, stretch_y (Heitz 2014, section 5.1),
///   shear_x, shear_y (section 5.5);
/// - any number among the material's parameters (alpha, exponent, gamma, f0, ...);
/// - with a tie: theta_o, phi_o, theta_i, phi_i, theta_m, phi_m;
/// - with text: `distribution`, `masking`, `shadowing`, `fresnel`, the type of the model; `channel`, of what is
/// coloured
///   (see channel.hpp); `strategy`, of what is said of samples.
struct Setting {
  std::string variable;
  std::variant<double, std::string, Tie> value;
};

/// How a quantity is simulated rather than computed: see simulated.hpp.
struct Simulate {
  std::string source;          ///< one of simulation_sources()
  std::string bounces = "all"; ///< which: "1" ... "4", "2+" or "all"
  std::string facets; ///< conductor, dielectric or diffuse, which the material's facet must be; none: conductor,
                      ///< or as the material says
  std::size_t paths = 100000;
  std::uint64_t seed = 1;
  int realisations = 8;       ///< surface: independent surfaces, among which the paths are shared
  int cells = 512;            ///< surface: along each side
  double half_width = 0.0873; ///< surface, brdf_cos: directions so far from the plane of incidence count as in it (rad)
  int samples = 61;           ///< evenly spaced points along x
};

/// A quantity of a material (see quantities() and integrals(), and simulated.hpp), with what is fixed.
struct Term {
  std::string quantity;
  MaterialDescription material;
  std::vector<Setting> at;
  std::optional<Simulate> simulate{};
};

/// A term, or a combination of expressions.
struct Expression {
  enum class Operation { term, difference, ratio, absolute } operation = Operation::term;
  Term term;                        ///< for Operation::term
  std::vector<Expression> operands; ///< two for difference and ratio, one for absolute
};

struct SeriesDescription {
  std::string label;
  Expression value;
  std::optional<double> ramp;
  std::optional<Hue> hue{}; ///< of a channel's curve
  std::string family{};     ///< hue: its curves look alike but for the colour
};

struct ContourDescription {
  std::string label;
  double level = 0;
};

/// A microsurface in profile (see profile_panel.hpp). Directions are signed angles from the normal, positive to the
/// right.
struct ProfileDescription {
  ModelChoice surface; ///< one of profile_surface.hpp's list
  std::uint64_t seed = 1;
  bool along_y = false;
  int cut = 0;    ///< which of the parallel cuts
  int from = 0;   ///< first facet drawn
  int cells = 64; ///< how many are drawn
  double stretch = 1;
  double shear = 0; ///< after the stretch; both move directions too
  std::optional<double> omega_o, omega_i;
  int normals = 0;                    ///< how many are drawn
  int rays = 0;                       ///< from so many points towards omega_o
  int paths = 0;                      ///< of light from omega_o, by mirrors, to so many points
  int bounces = 4;                    ///< of a path at most
  bool projection = false;            ///< what is visible is projected on a line across omega_o
  bool mesosurface = false;           ///< whether the mesosurface is drawn
  std::vector<std::string> arrows{};  ///< omega_o, omega_i, omega_g, omega_m
  double point = 0.5;                 ///< where they begin, as a fraction of what is drawn
  std::vector<std::string> numbers{}; ///< measured on the whole surface: see profile_numbers()
};

/// The correlation of heights with those at a distance, of a surface that a profile may be cut from: a curve.
struct AutocorrelationDescription {
  ModelChoice surface; ///< with heights: see surface.hpp
  std::uint64_t seed = 1;
  bool along_y = false;
};

/// What lights a sphere. Directions go from it to the light: theta from the direction of the viewer, phi from the right
/// of the picture, counterclockwise (radians).
struct Light {
  enum class Type { directional, sphere, environment } type = Type::directional;
  double theta = 0, phi = 0;
  double radius = 0; ///< sphere: the angle under which its radius is seen
  Colour colour;     ///< directional: irradiance across its direction; else radiance
};

/// A lit sphere (see spheres/panel.hpp).
struct SphereDescription {
  MaterialDescription material;
  std::vector<Setting> at{}; ///< of the material only
  std::vector<Light> lights{};
  double exposure = 1; ///< radiance times it is what is shown, 1 as white
  int pixels = 256;    ///< along each side of the picture
};

struct PanelDescription {
  std::string title;
  Axis x; ///< swept: `column` is the variable, from and to are given
  Axis y; ///< the value, or (heat map) swept too
  std::vector<SeriesDescription> series;
  std::vector<Arrow> arrows; ///< polar
  int samples = 0;           ///< evenly spaced points along x; 0: where the curve bends (see sampling.hpp)
  std::optional<Axis> value; ///< heat map: the value of series[0]
  std::vector<ContourDescription> contours;
  std::optional<Term> compare_to;              ///< a simulated lobe with which series[0] is compared: see compare.hpp
  std::optional<ProfileDescription> profile{}; ///< profile: instead of series
  std::optional<SphereDescription> sphere{};   ///< spheres: instead of series
  std::optional<AutocorrelationDescription> autocorrelation{}; ///< lines: instead of series
  bool drawn = true;          ///< else for the CSV and the numbers of the caption alone
  std::optional<Kind> kind{}; ///< where it is not the figure's
};

struct FigureDescription {
  std::string id;
  std::string title;
  std::string caption; ///< {name} in it is one of `numbers`
  std::vector<NumberDescription> numbers;
  Kind kind = Kind::lines;
  int columns = 1;
  Share share = Share::none;
  double tolerance = 1e-7; ///< of integrals
  int cells = 96;          ///< heat map: cells along each axis
  std::vector<PanelDescription> panels;
};

/// How a panel of the figure is drawn.
inline Kind kind_in(const FigureDescription& figure, const PanelDescription& panel) {
  return panel.kind.value_or(figure.kind);
}

/// Names of the variables that are not material parameters.
const std::vector<std::string>& direction_variables();

/// Evaluates everything. Lines and lobes are sampled adaptively: see sampling.hpp.
/// \throws InputError when a series cannot be evaluated (a missing direction, a parameter out of its bounds), naming
/// it; AccuracyError when an integral misses the figure's tolerance.
/// Simulated series have the points that they ask for; their results come from `store` where it has them, else they are
/// simulated on up to `threads` threads. The figure is the same for any number of them.
Figure compute(const FigureDescription& description, simulation::Store& store, int threads = 1);

/// The same with a store of its own.
Figure compute(const FigureDescription& description);

/// A simulation that a figure needs: computing it puts its result into the store.
struct SimulationTask {
  std::string key; ///< tasks of one key are the same
  std::string name;
  std::function<void(simulation::Store& store, int threads)> run;
  double work = 0; ///< roughly, in paths on a surface
};

/// Everything that compute() will want from the store, once each.
std::vector<SimulationTask> simulations(const FigureDescription& description);

} // namespace brdfplot::plot
