/// \file
/// A term of a figure as a function of what is swept.
#pragma once

#include "analysis/integrals.hpp"
#include "plot/description.hpp"

#include <array>
#include <optional>
#include <utility>

namespace brdfplot::plot {

/// A configuration being set up: a material and directions.
class Configuration {
public:
  explicit Configuration(MaterialDescription material) : material_(std::move(material)) {}

  /// \throws InputError (MaterialError) when nothing has this variable.
  void set(const Setting& setting);

  /// Where everything stands after the transformations.
  struct Ready {
    MaterialDescription description;
    Material material;
    std::optional<Direction> o, i, m;
  };
  Ready ready() const;

  /// theta_o, phi_o, ... phi_m, where it is set.
  std::optional<double> angle(const std::string& variable) const;

  /// Slope of the mesosurface before the transformations.
  Vec2 mean_slope() const;

private:
  void set_model(const std::string& variable, const std::string& type);
  std::optional<Direction> direction(std::size_t which) const;
  void transform(MaterialDescription& material, std::optional<Direction>& o, std::optional<Direction>& i,
                 std::optional<Direction>& m) const;

  MaterialDescription material_;
  std::array<std::optional<double>, 6> angle_; ///< theta and phi of o, i, m
  std::optional<double> a_;
  std::optional<double> slope_;
  Vec2 stretch_{1, 1};
  Vec2 shear_{0, 0};
};

/// The configuration of a term at given values of the swept variables.
class SweptConfiguration {
public:
  SweptConfiguration(const Term& term, std::vector<std::string> swept);
  Configuration::Ready at(const std::vector<double>& values) const;
  const Configuration& fixed() const { return fixed_; }

private:
  Configuration fixed_;
  std::vector<std::string> swept_;
  std::vector<bool> is_fixed_; ///< swept variables that the term's own settings fix
};

/// Whether a quantity is a function of a variable: those of omega_m are nothing to the BRDF, whose facets are
/// those of the half vector, and an integral knows omega_o alone.
bool depends_on(const std::string& quantity, const std::string& variable);

/// A term at given values of the swept variables.
class TermFunction {
public:
  /// \throws InputError when the quantity is unknown or cannot be had: a direction is missing, a model or parameter is
  /// not there. `swept`: the variables that will be given to operator().
  TermFunction(const Term& term, std::vector<std::string> swept, double tolerance);

  double operator()(const std::vector<double>& values) const;

  /// Throws what operator() would, without computing an integral.
  void check(const std::vector<double>& values) const;

  bool is_integral() const { return integral_.has_value(); }
  const Configuration& fixed() const { return configuration_.fixed(); }

private:
  void require_directions(const Configuration::Ready& ready) const;

  SweptConfiguration configuration_;
  std::optional<Quantity> quantity_;
  std::optional<Integral> integral_;
  double tolerance_;
};

} // namespace brdfplot::plot
