#include "simulation/simulate.hpp"

#include "base/errors.hpp"
#include "base/memory.hpp"
#include "base/threads/interruptible.hpp"
#include "simulation/measures.hpp"
#include "simulation/measures/slope_statistics.hpp"
#include "simulation/streams.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <span>
#include <stdexcept>

namespace brdfplot::simulation {

namespace {

/// Tiles along each side of a mesh: enough for the threads and for what is kept after Ctrl-C.
constexpr int tiles_a_side = 8;

/// A realisation with what traces it. Neither is moved: tiles point into them.
struct Traced {
  Realisation realisation;
  std::vector<std::unique_ptr<Tracer>> tracers;
  std::vector<Tile> tiles;
};

void cut_into_tiles(const HeightField& field, const Tracer& tracer, int a_side, std::vector<Tile>& tiles) {
  const double mean_area = static_cast<double>(field.nx()) * field.ny() / (a_side * a_side);
  for (int j = 0; j < a_side; ++j)
    for (int i = 0; i < a_side; ++i) {
      Tile tile{&field,
                &tracer,
                field.nx() * i / a_side,
                field.nx() * (i + 1) / a_side,
                field.ny() * j / a_side,
                field.ny() * (j + 1) / a_side,
                1};
      tile.weight = static_cast<double>(tile.x1 - tile.x0) * (tile.y1 - tile.y0) / mean_area;
      tiles.push_back(tile);
    }
}

/// About what a mesh takes at the most, with its waves before and Embree's tree after; of others it is little, or only
/// known when they are read.
double bytes_of(const Surface& surface) {
  constexpr double bytes_a_height = 140; // measured: 9.4 GB for 8192^2
  return std::visit(
      [](const auto& s) -> double {
        if constexpr (requires { s.mesh.samples; }) return bytes_a_height * s.mesh.samples * s.mesh.samples;
        return 0;
      },
      surface);
}

std::unique_ptr<Traced> make(const Surface& surface, std::uint64_t seed, std::uint64_t realisation) {
  auto out = std::make_unique<Traced>();
  require_memory(bytes_of(surface), "this surface with what traces it");
  out->realisation =
      interruptible([=] { return std::visit([&](const auto& s) { return s.realise(seed, realisation); }, surface); });
  const auto& fields = out->realisation.fields;
  out->tracers.resize(fields.size());
  tbb::parallel_for(std::size_t{0}, fields.size(),
                    [&](std::size_t k) { out->tracers[k] = std::make_unique<Tracer>(fields[k]); });
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const int shorter = std::min(fields[k].nx(), fields[k].ny());
    cut_into_tiles(fields[k], *out->tracers[k], fields.size() > 1 ? 1 : std::min(tiles_a_side, shorter), out->tiles);
  }
  return out;
}

/// What `work` returns, on so many threads of oneTBB.
template <class Work>
auto in_arena(int threads, const Work& work) {
  // More than oneTBB has, it would complain on stderr; its number is known once Embree has asked for threads.
  start_embree();
  const auto most = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  tbb::task_arena arena(std::clamp(threads, 1, most));
  return arena.execute(work);
}

/// What a measure has gathered.
struct Gathered {
  std::unique_ptr<Measure> measure;
  std::vector<Tally> tallies; ///< one a task
  double rays = 0;
};

/// One direction on one tile.
struct TileTask {
  std::size_t measure, task, tile;
};

/// The pieces that ranks share of a realisation: the statistics of its surface, then so many shares of its tiles.
constexpr std::size_t shares = std::size_t{tiles_a_side} * tiles_a_side;
constexpr std::size_t pieces_a_realisation = 1 + shares;

/// How many numbers of a share are its counts.
constexpr std::size_t count_numbers = 5;

void append(Numbers& to, const TraceCounts& counts) {
  to.insert(to.end(), {static_cast<double>(counts.coherent), static_cast<double>(counts.incoherent),
                       static_cast<double>(counts.lost), counts.coherent_seconds, counts.incoherent_seconds});
}

TraceCounts counts_of(std::span<const double, count_numbers> from) {
  return {static_cast<std::uint64_t>(from[0]), static_cast<std::uint64_t>(from[1]), static_cast<std::uint64_t>(from[2]),
          from[3], from[4]};
}

/// The tiles of a share: [first, end).
std::pair<std::size_t, std::size_t> tiles_of(std::size_t share, std::size_t tiles) {
  return {tiles * share / shares, tiles * (share + 1) / shares};
}

class Run {
public:
  Run(const SceneDescription& scene, const SimulationOptions& options)
      : scene_(scene), options_(options), surface_(build_surface(scene.surface)) {
    const auto target = std::visit([](const auto& s) { return s.target(); }, surface_);
    std::optional<Microsurface> smith;
    if (target) smith = build_microsurface({.distribution = *target, .masking = {.type = "smith"}, .shadowing = {}});
    for (MeasureDescription description : scene.measures) {
      const auto type = std::ranges::find_if(
          measure_types(), [&](const MeasureType& known) { return known.spec.type == description.type; });
      if (description.bins == 0) description.bins = type->spec.bins;
      Gathered one{type->make(description, smith), {}, description.rays};
      const bool given = std::visit(
          []<class S>(const S&) {
            return requires { S::is_given; };
          },
          surface_);
      one.tallies.assign(one.measure->tasks(), Tally(one.measure->width(), given ? Drawn::rays : Drawn::surfaces,
                                                     one.measure->fixed_by_surface()));
      gathered_.push_back(std::move(one));
    }
    result_.surface = {"surface", "surface", surface_columns(), {}};
  }

  /// On all ranks.
  SimulationResult result(Team& team) {
    std::vector<Numbers> pieces;
    for (int realisation = 0; realisation < scene_.realisations; ++realisation)
      for (std::size_t k = 0; k < pieces_a_realisation; ++k)
        pieces.push_back({static_cast<double>(realisation), static_cast<double>(k)});
    total_ = pieces.size();
    team.map(pieces, pieces_a_realisation, compute(), [&](std::size_t k, const Numbers& numbers) {
      take(k % pieces_a_realisation, numbers);
      ++done_;
      if (options_.progress) options_.progress({scene_.name, done_, total_});
    });
    return finished();
  }

  void help(Team& team) { team.serve(compute()); }

  SimulationResult result() {
    try {
      for (int k = 0; k < scene_.realisations && !interrupted(); ++k) trace(static_cast<std::uint64_t>(k));
    } catch (const Interrupted&) { // NOLINT(bugprone-empty-catch): within a surface; those before it are kept
    }
    if (!options_.keep_partial) throw_if_interrupted();
    return finished();
  }

private:
  SimulationResult finished() {
    const bool complete = done_ == total_ && done_ > 0;
    result_.traced = complete ? 1 : total_ > 0 ? static_cast<double>(done_) / static_cast<double>(total_) : 0;
    for (std::size_t k = 0; k < gathered_.size(); ++k) {
      Table table = gathered_[k].measure->tabulate(gathered_[k].tallies, complete);
      table.id = scene_.measures[k].id;
      result_.tables.push_back(std::move(table));
    }
    if (gathered_.empty()) result_.traced = interrupted() ? 0 : 1;
    return std::move(result_);
  }

  static std::vector<std::string> surface_columns() {
    return {"realisation",
            "alpha_x",
            "alpha_x_asked",
            "alpha_y",
            "alpha_y_asked",
            "correlation",
            "correlation_asked",
            "mean_x",
            "mean_x_asked",
            "mean_y",
            "mean_y_asked",
            "rms_height",
            "correlation_length",
            "slope_distance",
            "slope_distance_expected",
            "chi2",
            "degrees_of_freedom",
            "independent_slopes"};
  }

  std::vector<double> statistics(std::uint64_t realisation, const Traced& traced) const {
    const SlopeStatistics s = measure_slopes(surface_, traced.tiles);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const SlopeMap asked =
        std::visit([](const auto& one) { return one.asked(); }, surface_).value_or(SlopeMap{nan, nan, nan, nan, nan});
    return {static_cast<double>(realisation),
            s.slopes.alpha_x,
            asked.alpha_x,
            s.slopes.alpha_y,
            asked.alpha_y,
            s.slopes.correlation,
            asked.correlation,
            s.slopes.mean_x,
            asked.mean_x,
            s.slopes.mean_y,
            asked.mean_y,
            traced.realisation.rms_height,
            traced.realisation.correlation_length,
            s.distance,
            s.expected_distance,
            s.chi2,
            static_cast<double>(SlopeStatistics::degrees_of_freedom),
            s.independent};
  }

  void trace(std::uint64_t realisation) {
    const auto traced = make(surface_, scene_.seed, realisation);
    result_.surface.rows.push_back(statistics(realisation, *traced));
    // Tile by tile: interrupted, all directions have seen the same part of the surface.
    std::vector<TileTask> pieces;
    for (std::size_t tile = 0; tile < traced->tiles.size(); ++tile)
      for (std::size_t m = 0; m < gathered_.size(); ++m)
        for (std::size_t task = 0; task < gathered_[m].tallies.size(); ++task) pieces.push_back({m, task, tile});
    for (Gathered& one : gathered_)
      for (Tally& tally : one.tallies) tally.begin_realisation(traced->tiles.size());
    total_ = pieces.size() * static_cast<std::size_t>(scene_.realisations);
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t k) {
      if (interrupted()) return;
      trace(pieces[k], *traced, realisation);
    });
    for (Gathered& one : gathered_)
      for (Tally& tally : one.tallies) tally.end_realisation();
  }

  /// The sums of both halves of a tile; half of them after Ctrl-C.
  TraceCounts sample(const TileTask& piece, const Traced& traced, std::uint64_t realisation,
                     const std::array<std::span<double>, 2>& sums) const {
    const Gathered& one = gathered_[piece.measure];
    const Tile& tile = traced.tiles[piece.tile];
    const double count = one.rays / (2.0 * scene_.realisations * static_cast<double>(traced.tiles.size()));
    TraceCounts counts;
    for (const std::size_t half : {0U, 1U}) {
      // 2^8 measures of 2^16 directions on 2^17 tiles of two halves.
      const std::uint64_t part = (((std::uint64_t{piece.measure} << 16 | piece.task) << 17 | piece.tile) << 1) | half;
      Random random(scene_.seed, stream(Purpose::rays, realisation, part));
      one.measure->sample(piece.task, tile, count, random, sums[half], counts);
    }
    return counts;
  }

  void trace(const TileTask& piece, const Traced& traced, std::uint64_t realisation) {
    Tally& tally = gathered_[piece.measure].tallies[piece.task];
    const TraceCounts counts =
        sample(piece, traced, realisation, {tally.half(piece.tile, 0), tally.half(piece.tile, 1)});
    if (interrupted()) return; // half a tile
    tally.mark_done(piece.tile);
    const std::lock_guard lock(mutex_);
    ++done_;
    result_.counts += counts;
    if (options_.progress) options_.progress({scene_.name, done_, total_});
  }

  /// Pieces of one realisation, whose surface stays until one of another is asked for.
  Compute compute() {
    return [this](std::span<const Numbers> pieces, const Done& done) {
      in_arena(options_.threads, [&] {
        const auto realisation = static_cast<std::uint64_t>(pieces.front()[0]);
        if (!held_ || held_number_ != realisation) {
          held_.reset(); // before there is another: they are large
          held_ = make(surface_, scene_.seed, realisation);
          held_number_ = realisation;
        }
        std::size_t first = 0;
        // By itself: it is parallel, and may throw, which oneTBB does not survive in a loop within a loop.
        if (pieces[0][1] == 0) done(first++, statistics_piece(realisation));
        tbb::parallel_for(first, pieces.size(), [&](std::size_t k) {
          if (interrupted()) return;
          Numbers numbers = share_piece(realisation, static_cast<std::size_t>(pieces[k][1]) - 1);
          if (!interrupted()) done(k, std::move(numbers));
        });
        throw_if_interrupted();
      });
    };
  }

  /// The number of tiles and the row of statistics.
  Numbers statistics_piece(std::uint64_t realisation) const {
    Numbers numbers = statistics(realisation, *held_);
    numbers.insert(numbers.begin(), static_cast<double>(held_->tiles.size()));
    return numbers;
  }

  /// Of each tile of a share the sums of every task, one half after the other; then the counts of the share.
  Numbers share_piece(std::uint64_t realisation, std::size_t share) const {
    const auto [first, end] = tiles_of(share, held_->tiles.size());
    Numbers numbers((end - first) * numbers_a_tile(), 0.0);
    TraceCounts counts;
    std::span<double> left(numbers);
    for_tasks(first, end, [&](const TileTask& task, std::size_t width) {
      counts += sample(task, *held_, realisation, {left.first(width), left.subspan(width, width)});
      left = left.subspan(2 * width);
    });
    append(numbers, counts);
    return numbers;
  }

  /// What the pieces are, in their order.
  void take(std::size_t piece, std::span<const double> numbers) {
    if (piece == 0) {
      tiles_ = static_cast<std::size_t>(numbers[0]);
      result_.surface.rows.emplace_back(numbers.begin() + 1, numbers.end());
      for (Gathered& one : gathered_)
        for (Tally& tally : one.tallies) tally.begin_realisation(tiles_);
      return;
    }
    const auto [first, end] = tiles_of(piece - 1, tiles_);
    for_tasks(first, end, [&](const TileTask& task, std::size_t width) {
      Tally& tally = gathered_[task.measure].tallies[task.task];
      for (const std::size_t half : {0U, 1U})
        std::ranges::copy(numbers.subspan(half * width, width), tally.half(task.tile, half).begin());
      tally.mark_done(task.tile);
      numbers = numbers.subspan(2 * width);
    });
    result_.counts += counts_of(numbers.first<count_numbers>());
    if (piece != shares) return;
    for (Gathered& one : gathered_)
      for (Tally& tally : one.tallies) tally.end_realisation();
  }

  template <class Body>
  void for_tasks(std::size_t first_tile, std::size_t end_tile, const Body& body) const {
    for (std::size_t tile = first_tile; tile < end_tile; ++tile)
      for (std::size_t m = 0; m < gathered_.size(); ++m)
        for (std::size_t task = 0; task < gathered_[m].tallies.size(); ++task)
          body(TileTask{m, task, tile}, gathered_[m].measure->width());
  }

  std::size_t numbers_a_tile() const {
    std::size_t sum = 0;
    for_tasks(0, 1, [&](const TileTask&, std::size_t width) { sum += 2 * width; });
    return sum;
  }

  const SceneDescription& scene_;
  const SimulationOptions& options_;
  Surface surface_;
  std::vector<Gathered> gathered_;
  SimulationResult result_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
  std::mutex mutex_;
  std::unique_ptr<Traced> held_; ///< of the realisation `held_number_`
  std::uint64_t held_number_ = 0;
  std::size_t tiles_ = 0; ///< of a realisation that is taken
};

} // namespace

std::size_t Table::column(const std::string& name) const {
  const auto found = std::ranges::find(columns, name);
  if (found == columns.end()) throw std::out_of_range(name);
  return static_cast<std::size_t>(found - columns.begin());
}

SimulationResult simulate(const SceneDescription& scene, const SimulationOptions& options) {
  check(scene);
  // The team's messages are the main thread's; its pieces are computed on another one.
  if (options.team != nullptr) return Run(scene, options).result(*options.team);
  return in_arena(options.threads, [&] { return Run(scene, options).result(); });
}

void help_to_simulate(const SceneDescription& scene, const SimulationOptions& options) {
  check(scene);
  Run(scene, options).help(*options.team);
}

} // namespace brdfplot::simulation
