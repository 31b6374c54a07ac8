/// \file
/// Terms of a figure that are simulated. A new source of simulations is one file and its name at the end of this one,
/// declared and listed.
#pragma once

#include "figure/series/defining_text.hpp"
#include "figure/series/term.hpp"
#include "simulation/store.hpp"

#include <string>
#include <vector>

namespace brdfplot::plot {

/// The configurations of some points of a series.
using Points = std::vector<Configuration::Ready>;

/// Something that simulates quantities.
class SimulationSource {
public:
  virtual ~SimulationSource() = default;
  virtual std::string name() const = 0;
  virtual std::string doc() const = 0;
  virtual std::vector<std::string> quantities() const = 0;
  /// \throws InputError when the term cannot be simulated at this point.
  virtual void check(const Term& term, const Configuration::Ready& at) const = 0;
  /// Points of a series with equal texts are simulated together.
  virtual std::string group(const Term& term, const Configuration::Ready& at) const = 0;
  /// A text that defines the result of run(): different terms may share one.
  virtual std::string key(const Term& term, const Points& points) const = 0;
  /// Each output has one point for each of `points`, or one for all.
  virtual simulation::Result run(const Term& term, const Points& points, int threads) const = 0;
  /// How long run() takes, roughly, in paths on a surface.
  virtual double work(const Term& term, const Points& points) const = 0;
  /// Which output the term shows.
  virtual std::string output(const Term& term) const = 0;
  /// Whether the points are the middles of bins, rather than places from end to end.
  virtual bool is_binned(const Term& term) const = 0;
};

/// A simulated term over the values of a swept variable.
class SimulatedTerm {
public:
  /// \throws InputError when source, quantity or a setting is unknown.
  SimulatedTerm(const Term& term, std::vector<std::string> swept);

  /// Throws what measure() would, without simulating.
  void check(const std::vector<double>& values) const;

  /// The simulations that measure() wants.
  struct Job {
    std::string key;
    std::vector<std::size_t> indices; ///< of the x that it serves
    Points points;
  };
  std::vector<Job> jobs(const std::vector<double>& x) const;
  simulation::Result run(const Job& job, int threads) const { return source_->run(term_, job.points, threads); }

  /// How long run() takes, roughly, in paths on a surface.
  double work(const Job& job) const { return source_->work(term_, job.points); }

  /// The independent estimates of measure(). \throws InputError where the points have different numbers of them.
  simulation::Estimates estimates(const std::vector<double>& x, simulation::Store& store, int threads) const;

  const Simulate& simulate() const { return *term_.simulate; }
  int samples() const { return term_.simulate->samples; }
  bool is_binned() const { return source_->is_binned(term_); }

  std::vector<simulation::Measured> measure(const std::vector<double>& x, simulation::Store& store, int threads) const;

private:
  Term term_;
  SweptConfiguration configuration_;
  const SimulationSource* source_ = nullptr;
};

/// The random walk on Smith's surface: brdf_cos, albedo, transmittance and mean_fresnel by bounce
/// (simulation/walk.hpp).
const SimulationSource& smith_walk_source();

/// Rays on random surfaces: brdf_cos in the plane of incidence, albedo, g1, g2, and direction_factor, the lambda of Eq.
/// 101 of Heitz 2014 that the measured G1 and G2 imply (simulation/simulate.hpp).
const SimulationSource& surface_source();

/// No simulation: brdf_cos itself, averaged over the bins of surface_source().
const SimulationSource& bins_source();

inline const std::vector<const SimulationSource*>& simulation_sources() {
  static const std::vector<const SimulationSource*> all = {&smith_walk_source(), &surface_source(), &bins_source()};
  return all;
}

} // namespace brdfplot::plot
