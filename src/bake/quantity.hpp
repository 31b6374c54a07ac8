/// \file
/// What tables are baked of, at one point of their axes.
#pragma once

#include "bake/axis.hpp"
#include "brdf/material.hpp"

#include <string>
#include <vector>

namespace brdfplot::bake {

/// The names of what can be baked, with what each is.
struct BakedInfo {
  std::string name;
  std::string doc;
};
const std::vector<BakedInfo>& baked_quantities();

/// A quantity of a material as a function of the values of the axes.
class Baked {
public:
  /// What a table holds at most: the largest error of the integrals is `tolerance`. \throws InputError where the
  /// material does not have the quantity, or an axis is none of it: what is accepted.
  Baked(MaterialDescription material, std::string quantity, const std::vector<Axis>& axes, double tolerance);

  /// The names of the values, as many as there are at a point.
  const std::vector<std::string>& channels() const { return channels_; }
  /// The values at a point, by the axes. \throws AccuracyError where an integral does not reach the tolerance,
  /// InputError where the material cannot be built.
  std::vector<double> at(const std::vector<double>& values) const;

private:
  MaterialDescription configured(const std::vector<double>& values) const;
  Direction viewer(const std::vector<double>& values) const;

  MaterialDescription material_;
  std::string quantity_;
  std::vector<std::string> variables_;
  std::vector<std::string> channels_;
  double tolerance_;
};

} // namespace brdfplot::bake
