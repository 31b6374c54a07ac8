/// \file
/// The material and the directions of a term, as its settings and what is swept make them.
#pragma once

#include "figure/description.hpp"
#include "figure/series/channel.hpp"
#include "math/half_difference.hpp"
#include "sampling/sampler.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::plot {

/// Values of the swept variables: for each a column, all of one length. Where nothing is swept there is one row.
using SweptColumns = std::vector<std::vector<double>>;

/// Directions, where they are set.
struct Directions {
  std::optional<Direction> o, i, m;
};

/// A configuration being set up: a material and directions.
class Configuration {
public:
  explicit Configuration(MaterialDescription material) : material_(std::move(material)) {}

  /// \throws InputError (MaterialError) when nothing has this variable.
  void set(const Setting& setting);

  /// What directions fall on: the material after the transformations, and its slopes before them.
  struct Surface {
    MaterialDescription description;
    Material material;
    SlopeMap before;
  };
  Surface surface() const;

  /// Directions after the transformations, on the surface() of this configuration.
  Directions directions(const Surface& surface) const;

  /// Where everything stands after the transformations.
  struct Ready {
    MaterialDescription description;
    Material material;
    std::optional<Direction> o, i, m;
    std::optional<Channel> channel;
  };
  Ready ready() const;

  std::optional<Channel> channel() const { return channel_; }
  /// How directions are drawn, of quantities that say how well that is done.
  const std::string& strategy() const { return strategy_; }

  /// theta_o, phi_o, ... phi_m, where it is set or follows what is.
  std::optional<double> angle(const std::string& variable) const;

  /// Where slopes have their means before the transformations: of the distributions of all terms, or of the parts that
  /// a mixture has; [0, 0] where none is inclined.
  std::vector<Vec2> mean_slopes() const;

private:
  void set_model(const std::string& variable, const std::string& type);
  void set_tie(const std::string& variable, const Tie& tie);
  std::optional<double> angle(std::size_t which) const;
  std::optional<Direction> direction(std::size_t which) const;
  /// Of half and difference angles, where they are set. \throws InputError beside other angles of viewer or light
  std::optional<ViewerAndLight> pair() const;
  bool is_transformed() const { return stretch_ != Vec2{1, 1} || shear_ != Vec2{0, 0}; }
  /// The material after the transformations.
  MaterialDescription transformed(const Material& material) const;

  MaterialDescription material_;
  std::optional<Channel> channel_;
  std::string strategy_ = "default";
  std::array<std::optional<double>, 6> angle_; ///< theta and phi of o, i, m
  std::array<std::optional<Tie>, 6> tie_;      ///< what follows another of them instead
  std::array<std::optional<double>, 4> half_;  ///< theta and phi of the half vector and of the difference
  std::optional<double> a_;
  std::optional<double> slope_;
  Vec2 stretch_{1, 1};
  Vec2 shear_{0, 0};
};

/// The configuration of a term at given values of the swept variables.
class SweptConfiguration {
public:
  /// \throws MaterialError when what is swept leaves the material as it is, and it cannot be built.
  SweptConfiguration(const Term& term, std::vector<std::string> swept);
  Configuration::Ready at(const std::vector<double>& values) const;
  const Configuration& fixed() const { return fixed_; }

  /// Whether nothing changes with what is swept.
  bool is_constant() const;

  /// Calls `visit` once for every surface, with the rows that lie on it and their directions, as many at a time as a
  /// batch should have. Surfaces are built once a call, and that which no swept variable changes once and for all.
  using Visitor = std::function<void(const Configuration::Surface& surface, const std::vector<std::size_t>& rows,
                                     const std::vector<Directions>& directions)>;
  void for_each_surface(const SweptColumns& columns, const Visitor& visit) const;

private:
  using Rows = std::vector<std::size_t>;
  /// The rows of equal surfaces, in the order in which these appear.
  std::vector<Rows> rows_by_surface(const SweptColumns& columns) const;

  Configuration fixed_;
  std::vector<std::string> swept_;
  /// The swept variables that the term's own settings leave free: those that change the surface, and those that move
  /// directions on it.
  std::vector<std::size_t> changing_, moving_;
  std::optional<Configuration::Surface> surface_; ///< where nothing changes it
};

} // namespace brdfplot::plot
