#include "figure/series/simulated.hpp"

#include "models/registry.hpp"

#include <algorithm>

namespace brdfplot::plot {

namespace {

const SimulationSource& source_named(const std::string& name) {
  std::vector<std::string> names;
  for (const auto* source : simulation_sources()) {
    if (source->name() == name) return *source;
    names.push_back(source->name());
  }
  throw InputError("", unknown_name("source", name, names));
}

} // namespace

SimulatedTerm::SimulatedTerm(const Term& term, std::vector<std::string> swept)
    : term_(term), configuration_(term, std::move(swept)), source_(&source_named(term.simulate.value().source)) {
  const auto names = source_->quantities();
  if (std::ranges::find(names, term.quantity) == names.end())
    throw InputError("", unknown_name("quantity of " + source_->name(), term.quantity, names));
}

void SimulatedTerm::check(const std::vector<double>& values) const { source_->check(term_, configuration_.at(values)); }

std::vector<SimulatedTerm::Job> SimulatedTerm::jobs(const std::vector<double>& x) const {
  std::vector<Job> jobs;
  std::vector<std::string> groups;
  for (std::size_t k = 0; k < x.size(); ++k) {
    auto point = configuration_.at({x[k]});
    source_->check(term_, point);
    const std::string group = source_->group(term_, point);
    const auto found = static_cast<std::size_t>(std::ranges::find(groups, group) - groups.begin());
    if (found == groups.size()) {
      groups.push_back(group);
      jobs.emplace_back();
    }
    jobs[found].indices.push_back(k);
    jobs[found].points.push_back(std::move(point));
  }
  for (Job& job : jobs) job.key = source_->key(term_, job.points);
  return jobs;
}

simulation::Estimates SimulatedTerm::estimates(const std::vector<double>& x, simulation::Store& store,
                                               int threads) const {
  simulation::Estimates out{x.size(), {}};
  for (const Job& job : jobs(x)) {
    const auto result = store.get(job.key, [&] { return run(job, threads); });
    const simulation::Estimates& from = result->at(source_->output(term_));
    out.values.resize(std::max(out.values.size(), from.count() * x.size()), 0);
    if (from.count() != out.count()) throw InputError("", "the points have different numbers of estimates");
    for (std::size_t e = 0; e < from.count(); ++e)
      for (std::size_t k = 0; k < job.indices.size(); ++k)
        out.values[e * x.size() + job.indices[k]] = from.values[e * from.points + (from.points == 1 ? 0 : k)];
  }
  return out;
}

std::vector<simulation::Measured> SimulatedTerm::measure(const std::vector<double>& x, simulation::Store& store,
                                                         int threads) const {
  const simulation::Estimates all = estimates(x, store, threads);
  std::vector<simulation::Measured> out;
  for (std::size_t k = 0; k < x.size(); ++k) out.push_back(all.at(k));
  return out;
}

} // namespace brdfplot::plot
