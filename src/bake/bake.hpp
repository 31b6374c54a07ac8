/// \file
/// Baking: a table whose error is measured between its nodes.
#pragma once

#include "bake/quantity.hpp"
#include "bake/table.hpp"
#include "base/threads/team.hpp"

#include <optional>

namespace brdfplot::bake {

struct BakeOptions {
  /// What the bound may be: nodes are doubled, in the axis that is off most, until it is met. None: axes as they are.
  std::optional<double> error{};
  double tolerance = 1e-6; ///< of each value
  int threads = 1;
  Team* team = nullptr; ///< that has begun; none: this process computes all
};

/// The most points at which a quantity is taken, a quarter of an hour of the slower ones.
inline constexpr std::size_t most_points = 1'000'000;

/// A table of the material over the axes. Where `nodes` or `power` of an axis is 0 it is chosen: 32 nodes, or as many
/// as the error asks for; a power of 1, or with an error that of 1, 2 and 3 (of u 4, 6 and 8 too) whose interpolation
/// is off least on 9 nodes. \throws InputError for axes that the quantity has not, more than most_points, and an error
/// below the tolerance
BakedTable bake(const MaterialDescription& material, const std::string& quantity, std::vector<Axis> axes,
                const BakeOptions& options);

/// What every rank but 0 does while that bakes.
void help_to_bake(const MaterialDescription& material, const std::string& quantity, const std::vector<Axis>& axes,
                  const BakeOptions& options);

} // namespace brdfplot::bake
