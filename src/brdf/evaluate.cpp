#include "brdf/evaluate.hpp"

#include "brdf/blocks/kernel_choice.hpp"
#include "brdf/blocks/surface_block.hpp"
#include "brdf/fresnel_term.hpp"

#include <algorithm>
#include <array>
#include <memory>

namespace brdfplot {

namespace {

int channels_of_terms(const std::vector<const WeightedTerm*>& terms) {
  return std::ranges::any_of(terms, [](const auto* t) { return t->channels() > 1; }) ? 3 : 1;
}

/// Whether rho of a term is computed at half vectors, by other than a kernel that has them itself.
bool looks_at_half_vectors(const WeightedTerm& term) {
  if (const auto* mirror = std::get_if<Mirror>(&term.term))
    return !std::holds_alternative<NoFresnel>(mirror->fresnel) ||
           (!whole_kernel(mirror->surface) && !sheen_kernel(mirror->surface));
  return term.surface() != nullptr || term.facets() != nullptr;
}

/// One term with the work space of its quantities, in one block of rows.
struct TermBlock {
  const WeightedTerm* term = nullptr;
  bool at_half_vectors = false;
  SurfaceBlock work;
};

/// Writes rho of one term under its coats, and returns how many channels it has.
std::size_t write_term(TermBlock& block, const PairBlock& pairs, std::array<Buffer, 3>& values) {
  const ChannelRows own{{values[0].data(), values[1].data(), values[2].data()}};
  const std::vector<Coat>& coats = block.term->coats;
  std::size_t count = std::visit(
      [&](const auto& term) {
        term.evaluate(pairs, block.work, own);
        return static_cast<std::size_t>(term.channels());
      },
      block.term->term);
  if (coats.empty()) return count;
  if (count == 1 && std::ranges::any_of(coats, [](const Coat& coat) { return coat.channels() > 1; })) {
    values[1] = values[2] = values[0];
    count = 3;
  }
  const auto factor = let_through(coats, pairs.o, pairs.i, pairs.n, static_cast<int>(count));
  for (std::size_t c = 0; c < count; ++c)
    for (std::size_t k = 0; k < pairs.n; ++k)
      if (values[c][k] != 0) values[c][k] *= factor[c * pairs.n + k];
  return count;
}

bool is_unweighted(const WeightedTerm& term) { return !term.weight.is_rgb && term.weight.value == Rgb{1, 1, 1}; }

/// Writes the BRDF of a material that is one flat term, at once: there is nothing to prepare. Returns whether it is
/// one.
bool write_flat(const Material& material, std::span<const Wanted> wanted, const Batch& batch) {
  if (wanted.size() != 1 || material.terms.size() != 1 || !wanted[0].term.empty() || !batch.o || !batch.i) return false;
  const Quantity quantity = wanted[0].quantity;
  const WeightedTerm& only = material.terms[0];
  if (quantity != Quantity::brdf && quantity != Quantity::brdf_cos) return false;
  if (!only.coats.empty() || !is_unweighted(only)) return false;
  return std::visit(
      [&]<class T>(const T& term) {
        if constexpr (requires { T::is_flat; })
          evaluate_term(term, quantity == Quantity::brdf_cos, batch, wanted[0].out);
        return requires { T::is_flat; };
      },
      only.term);
}

/// Writes the BRDF of the terms, the first of which is written and the others added.
void write_sum(const std::vector<TermBlock*>& terms, int channels, const PairBlock& pairs, const ChannelRows& out) {
  const WeightedTerm& first = *terms[0]->term;
  if (terms.size() == 1 && first.coats.empty() && is_unweighted(first))
    return std::visit([&](const auto& term) { term.evaluate(pairs, terms[0]->work, out); }, first.term);
  std::array<Buffer, 3> values;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const WeightedTerm& weighted = *terms[t]->term;
    const std::size_t count = write_term(*terms[t], pairs, values);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
      const double* from = values[count > 1 ? c : 0].data();
      const double w = weighted.weight.value[c];
      for (std::size_t k = 0; k < pairs.n; ++k) out.rho[c][k] = t == 0 ? w * from[k] : out.rho[c][k] + w * from[k];
    }
  }
}

/// The quantities of one batch, block by block.
class Evaluation {
public:
  Evaluation(const Material& material, std::span<const Wanted> wanted, const Batch& batch)
      : batch_(batch), block_count_(material.terms.size()), blocks_(new TermBlock[block_count_]) {
    const bool of_facets =
        std::ranges::any_of(wanted, [](const Wanted& one) { return info_of(one.quantity).owner != Owner::material; });
    for (std::size_t k = 0; k < block_count_; ++k) {
      blocks_[k].term = &material.terms[k];
      blocks_[k].at_half_vectors = of_facets || looks_at_half_vectors(material.terms[k]);
    }
    for (const Wanted& one : wanted) {
      require(material, info_of(one.quantity), bool(batch.o), bool(batch.i), bool(batch.m), one.term);
      Task task{one.quantity, one.out, channels_of(material, one.quantity, one.term), {}};
      const Owner owner = info_of(one.quantity).owner;
      const auto terms = owner == Owner::material ? terms_of(material, one.term)
                         : owner == Owner::fresnel
                             ? std::vector<const WeightedTerm*>{&term_with_fresnel(material, one.term)}
                             : std::vector<const WeightedTerm*>{&material.term_with_surface(one.term)};
      for (const WeightedTerm* term : terms)
        task.terms.push_back(&blocks_[static_cast<std::size_t>(term - material.terms.data())]);
      tasks_.push_back(std::move(task));
    }
  }

  void run() {
    for (std::size_t first = 0; first < batch_.n; first += PairBlock::capacity) {
      const std::size_t n = std::min(PairBlock::capacity, batch_.n - first);
      for (std::size_t k = 0; k < block_count_; ++k) {
        SurfaceBlock& work = blocks_[k].work;
        if (blocks_[k].at_half_vectors) {
          set_directions(work, n, batch_.o.from(first), batch_.i.from(first), batch_.m.from(first));
          continue;
        }
        work.n = n;
        work.done = {};
        work.o = batch_.o.from(first);
        work.i = batch_.i.from(first);
      }
      for (const Task& task : tasks_) write(task, first);
    }
  }

private:
  struct Task {
    Quantity quantity;
    double* out;
    int channels;
    std::vector<TermBlock*> terms;
  };

  void write(const Task& task, std::size_t first) const {
    TermBlock& block = *task.terms[0];
    const bool has_m = batch_.m || (batch_.o && batch_.i);
    const ChannelRows rows = rows_from(task.out, first, batch_.n, task.channels);
    switch (info_of(task.quantity).owner) {
    case Owner::microsurface: return evaluate(*block.term->surface(), task.quantity, has_m, block.work, rows.rho[0]);
    case Owner::fresnel:
      compute_reflectances(*block.term->fresnel(), block.work);
      for (std::size_t c = 0; c < static_cast<std::size_t>(task.channels); ++c)
        std::copy_n(block.work.reflectances[c].data(), block.work.n, rows.rho[c]);
      return;
    case Owner::material:
      const PairBlock pairs{block.work.n, block.work.o, block.work.i, task.quantity == Quantity::brdf_cos};
      return write_sum(task.terms, task.channels, pairs, rows);
    }
  }

  const Batch& batch_;
  std::size_t block_count_;
  std::unique_ptr<TermBlock[]> blocks_; ///< one a term; not a vector, which would fill them with zeros
  std::vector<Task> tasks_;
};

} // namespace

int channels_of(const Material& material, Quantity quantity, const std::string& term) {
  switch (info_of(quantity).owner) {
  case Owner::microsurface: return 1;
  case Owner::fresnel:
    return std::visit([](const auto& f) { return f.coloured(); }, *term_with_fresnel(material, term).fresnel()) ? 3 : 1;
  case Owner::material: break;
  }
  return channels_of_terms(terms_of(material, term));
}

void require(const Material& material, const QuantityInfo& info, bool has_o, bool has_i, bool has_m,
             const std::string& term) {
  const std::string name = "\"" + info.name + "\" ";
  if (info.owner == Owner::microsurface)
    return require(material.surface(term), material.name, info.quantity, has_o, has_i, has_m);
  if (info.owner == Owner::fresnel) (void)term_with_fresnel(material, term);
  if (!has_o) throw InputError(material.name, name + "needs omega_o: theta_o [phi_o] or x_o y_o z_o");
  if (info.needs.i && !has_i) throw InputError(material.name, name + "needs omega_i: theta_i [phi_i] or x_i y_i z_i");
  if (info.needs.m && !has_m && !has_i)
    throw InputError(
        material.name,
        name + "needs omega_m: theta_m [phi_m] or x_m y_m z_m, or omega_o with omega_i for their half vector");
}

void evaluate(const Material& material, std::span<const Wanted> wanted, const Batch& batch) {
  if (write_flat(material, wanted, batch)) return;
  if (!batch.m) return Evaluation(material, wanted, batch).run();
  // What does not look at a given normal has half vectors of its own.
  std::vector<Wanted> with_normal, without;
  for (const Wanted& one : wanted) (batch.m && !used_by(one.quantity, batch).m ? without : with_normal).push_back(one);
  if (!with_normal.empty()) Evaluation(material, with_normal, batch).run();
  if (without.empty()) return;
  const Batch of_half_vectors{batch.n, batch.o, batch.i, {}};
  Evaluation(material, without, of_half_vectors).run();
}

void evaluate(const Material& material, Quantity quantity, const Batch& batch, double* out, const std::string& term) {
  const Wanted wanted[] = {{quantity, out, term}};
  evaluate(material, wanted, batch);
}

double evaluate(const Material& material, Quantity quantity, const Direction& o, const std::optional<Direction>& i,
                const std::optional<Direction>& m) {
  const auto columns = [](const std::optional<Direction>& d) { return d ? Columns{&d->x, &d->y, &d->z} : Columns{}; };
  std::array<double, 3> out{};
  evaluate(material, quantity, {1, {&o.x, &o.y, &o.z}, columns(i), columns(m)}, out.data());
  return out[0];
}

} // namespace brdfplot
