/// \file
/// What every measure of a scene does.
#pragma once

#include "base/random.hpp"
#include "microfacet/microsurface.hpp"
#include "simulation/measures/tally.hpp"
#include "simulation/scene.hpp"
#include "simulation/simulate.hpp"
#include "simulation/tiles.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace brdfplot::simulation {

/// A measure is made of tasks, one for every direction or pair of directions; a task fills a row of sums for every
/// tile. Sums are weighted by the tile's weight.
class Measure {
public:
  virtual ~Measure() = default;
  virtual std::size_t tasks() const = 0;
  virtual std::size_t width() const = 0;
  /// Traces about `count` points or paths on a tile and adds to `sums`. Called from many threads.
  virtual void sample(std::size_t task, const Tile& tile, double count, Random& random, std::span<double> sums,
                      TraceCounts& counts) const = 0;
  /// Whether the table has something that a whole surface fixes, so that only rays make it uncertain.
  virtual bool fixed_by_surface() const { return false; }
  /// One tally a task. `complete`: the whole surface is in them.
  virtual Table tabulate(const std::vector<Tally>& tallies, bool complete) const = 0;
};

/// A type of measure. `smith` is the microsurface of the surface's distribution with Smith's masking; none where there
/// is no distribution.
struct MeasureType {
  MeasureSpec spec;
  std::unique_ptr<Measure> (*make)(const MeasureDescription& description, const std::optional<Microsurface>& smith);
};

/// The type whose measure is the class M, made of the description alone or of it and `smith`.
template <class M>
MeasureType measure_type(MeasureSpec spec) {
  return {
      std::move(spec),
      [](const MeasureDescription& description, const std::optional<Microsurface>& smith) -> std::unique_ptr<Measure> {
        if constexpr (std::is_constructible_v<M, const MeasureDescription&, const std::optional<Microsurface>&>)
          return std::make_unique<M>(description, smith);
        else
          return std::make_unique<M>(description);
      }};
}

/// A direction to look from.
struct View {
  double theta = 0;
  double phi = 0;
  Direction omega{};
};

/// All pairs of theta_o and phi_o, theta_o outermost.
std::vector<View> views(const MeasureDescription& description);

/// Appends a value and its error to a row.
inline void append(std::vector<double>& row, const Measured& measured) {
  row.push_back(measured.value);
  row.push_back(measured.standard_error);
}

/// The points of a bunch that face the direction (in the axes of the mesh), and which of them see it.
struct Facing {
  std::vector<SurfacePoint> points;
  std::vector<unsigned char> visible;

  void take(std::span<const SurfacePoint> from, const Direction& direction);
  /// Those that face a second direction too.
  void take(std::span<const SurfacePoint> from, const Direction& one, const Direction& other);
  void trace(const Tracer& tracer, const Direction& direction, TraceCounts& counts);
};

} // namespace brdfplot::simulation
