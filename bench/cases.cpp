#include "cases.hpp"

#include "accuracy/measure.hpp"
#include "brdf/evaluate.hpp"
#include "peers.hpp"

namespace brdfplot::bench {

namespace {

using accuracy::Quad;
using reference::Model;

/// Every so many inputs one is compared with the reference.
constexpr std::size_t stride = 499;

/// Of several channels the first stays: the next batch overwrites the others.
template <class T>
std::vector<T>& output() {
  static std::vector<T> values(count + 2 * batch);
  return values;
}

/// An exact result, and the E of exp(-E) in it: a change of the input by its rounding changes the result by 4 E units
/// of 2^-53, and errors are divided by 1 + E / 2, as in tests/accuracy.
struct Exact {
  Quad value;
  double exponent = 0;
};
using ExactOf = std::function<Exact(std::size_t)>;

/// Exact results that are too small to be told from zero by the peers are left out: their errors would be infinite.
template <class T>
double largest_error(const ExactOf& exact) {
  double largest = 0;
  for (std::size_t k = 0; k < count; k += stride) {
    const auto [value, exponent] = exact(k);
    if (value > Quad(std::numeric_limits<T>::min()))
      largest = std::max(largest, accuracy::ulp_error(output<T>()[k], value) / (1 + exponent / 2));
  }
  return largest;
}

template <class T>
Exact exact_lambda(Model model, std::size_t k) {
  return {reference::lambda(model, Quad(Quad(inputs<T>().c[k]) / Quad(inputs<T>().s[k])))};
}

template <class T>
reference::Vector<Quad> vector(const Directions<T>& directions, std::size_t k) {
  return {Quad(directions.x[k]), Quad(directions.y[k]), Quad(directions.z[k])};
}

template <class T>
reference::Stretch<Quad> stretch(std::size_t k) {
  const Quad alpha = inputs<T>().alpha[k / batch];
  return {alpha, alpha, Quad(0), Quad(0), Quad(0)};
}

/// E at a vector of any length; GGX has none.
template <class T>
double exponent(Model model, const reference::Vector<Quad>& m, std::size_t k) {
  if (model == Model::ggx) return 0;
  return static_cast<double>(reference::slope_norm2(stretch<T>(k), Quad(-m.x / m.z), Quad(-m.y / m.z)));
}

template <class T>
Exact exact_brdf(Model model, std::size_t k) {
  const auto o = vector(inputs<T>().o, k), i = vector(inputs<T>().i, k);
  return {reference::brdf(model, reference::G2Form::height_correlated, stretch<T>(k), o, i),
          exponent<T>(model, {o.x + i.x, o.y + i.y, o.z + i.z}, k)};
}

template <class T>
Exact exact_d(Model model, std::size_t k) {
  const auto m = vector(inputs<T>().o, k);
  return {reference::d(model, stretch<T>(k), m), exponent<T>(model, m, k)};
}

Exact exact_conductor(std::size_t k, double eta, double absorption) {
  const auto o = vector(inputs<double>().o, k), i = vector(inputs<double>().i, k);
  const reference::Vector<Quad> h{o.x + i.x, o.y + i.y, o.z + i.z};
  const Quad facing = reference::dot(o, h) / sqrt(reference::dot(h, h));
  return {exact_brdf<double>(Model::ggx, k).value * reference::conductor(facing, Quad(eta), Quad(absorption))};
}

/// Evaluates the BRDF of rough conductors, one a batch.
std::function<void()> evaluate_conductors(const Value& eta, const Value& absorption) {
  std::vector<Material> materials;
  for (const double alpha : inputs<double>().alpha) {
    TermDescription description;
    description.distribution.type = "ggx";
    description.distribution.values.set("alpha", alpha);
    description.fresnel.type = "conductor";
    description.fresnel.values.set("eta", eta);
    description.fresnel.values.set("k", absorption);
    materials.push_back(build(description));
  }
  return [materials] {
    const auto& in = inputs<double>();
    for (std::size_t k = 0; k < count; k += batch) {
      const auto o = in.o.from(k), i = in.i.from(k);
      evaluate(materials[k / batch], Quantity::brdf, {batch, {o.x, o.y, o.z}, {i.x, i.y, i.z}, {}},
               output<double>().data() + k);
    }
  };
}

/// A list of cases under construction. All of one group share inputs and exact results.
template <class T>
class Group {
public:
  Group(std::vector<Case>& all, std::string what, ExactOf exact)
      : all_(all), name_(std::move(what) + " " + accuracy::type_name<T>()), exact_(std::move(exact)) {}

  void add(std::string name, std::function<void()> run, double target = 0,
           std::optional<kernels::Isa> isa = std::nullopt) {
    all_.push_back({name_, std::move(name), isa, run,
                    [run, exact = exact_] {
                      run();
                      return largest_error<T>(exact);
                    },
                    target});
  }

  /// The kernel on every instruction set, the fastest first.
  void add_kernel(const std::function<void()>& run) {
    const auto isas = kernels::available_isas();
    for (auto isa = isas.rbegin(); isa != isas.rend(); ++isa)
      add("brdfplot " + std::string(kernels::name(*isa)), run, 0, *isa);
  }

private:
  std::vector<Case>& all_;
  std::string name_;
  ExactOf exact_;
};

template <class T>
std::function<void()> over_cs(OverCs<T>* function) {
  return [function] { function(inputs<T>().c.data(), inputs<T>().s.data(), output<T>().data(), count); };
}

template <class T>
std::function<void()> over_batches(const std::function<Brdf<T>>& function) {
  return [function] {
    const auto& in = inputs<T>();
    for (std::size_t k = 0; k < count; k += batch)
      function(in.alpha[k / batch], in.o.from(k), in.i.from(k), output<T>().data() + k, batch);
  };
}

template <class T>
std::function<Brdf<T>> brdf_kernel(kernels::Distribution distribution) {
  return [distribution](double alpha, kernels::Vectors<T> o, kernels::Vectors<T> i, T* out, std::size_t n) {
    kernels::brdf({alpha, alpha}, distribution, kernels::Shadowing::height_correlated, o, i, out, n);
  };
}

template <class T>
std::function<void()> over_a(void (*function)(const T*, T*, std::size_t)) {
  return [function] { function(inputs<T>().a.data(), output<T>().data(), count); };
}

template <class T>
void add_masking(std::vector<Case>& all) {
  constexpr bool is_double = sizeof(T) == sizeof(double);
  Group<T> of_a(all, "Lambda(a) Beckmann",
                [](std::size_t k) { return Exact{reference::lambda_beckmann(Quad(inputs<T>().a[k]))}; });
  of_a.add_kernel(over_a<T>(kernels::lambda_beckmann));
  of_a.add("printed, std::erf", over_a<T>(printed_beckmann_of_a<T>), is_double ? 12 : 0);
  Group<T> beckmann(all, "Lambda Beckmann", [](std::size_t k) { return exact_lambda<T>(Model::beckmann, k); });
  beckmann.add_kernel(over_cs<T>(kernels::lambda_beckmann));
  beckmann.add("printed, std::erf", over_cs<T>(printed_beckmann<T>), is_double ? 12 : 0);
  beckmann.add("printed, Boost.Math erf", over_cs<T>(printed_beckmann_boost<T>));
  if constexpr (is_double) {
    if (const auto peer = printed_beckmann_sleef()) beckmann.add("printed, SLEEF AVX-512", over_cs<T>(peer), 4);
    if (const auto peer = printed_beckmann_libmvec()) beckmann.add("printed, libmvec AVX-512", over_cs<T>(peer));
  } else {
    if (const auto peer = printed_beckmann_sleef_float()) beckmann.add("printed, SLEEF AVX-512", over_cs<T>(peer));
  }
  beckmann.add("Walter's fit, scalar", over_cs<T>(walter_scalar<T>));
  beckmann.add("Walter's fit, kernel", over_cs<T>(kernels::lambda_beckmann_walter));
  Group<T> ggx(all, "Lambda GGX", [](std::size_t k) { return exact_lambda<T>(Model::ggx, k); });
  ggx.add_kernel(over_cs<T>(kernels::lambda_ggx));
  ggx.add("printed, scalar", over_cs<T>(printed_ggx<T>), is_double ? 3 : 0);
  if constexpr (is_double)
    if (const auto peer = printed_ggx_vectorised()) ggx.add("printed, vectorised", over_cs<T>(peer));
  const auto area = [&](const char* name, Model model, OverCs<T>* kernel) {
    Group<T>(all, name, [model](std::size_t k) {
      return Exact{exact_lambda<T>(model, k).value * Quad(inputs<T>().c[k])};
    }).add_kernel(over_cs<T>(kernel));
  };
  area("c Lambda Beckmann", Model::beckmann, kernels::masked_area_beckmann);
  area("c Lambda GGX", Model::ggx, kernels::masked_area_ggx);
}

template <class T>
void add_densities(std::vector<Case>& all) {
  for (const Model model : {Model::beckmann, Model::ggx}) {
    const bool beckmann = model == Model::beckmann;
    Group<T> group(all, beckmann ? "D Beckmann" : "D GGX", [model](std::size_t k) { return exact_d<T>(model, k); });
    group.add_kernel(
        over_batches<T>([beckmann](double alpha, kernels::Vectors<T> m, kernels::Vectors<T>, T* out, std::size_t n) {
          if (beckmann)
            kernels::d_beckmann({alpha, alpha}, m, out, n);
          else
            kernels::d_ggx({alpha, alpha}, m, out, n);
        }));
    group.add("as pbrt-v4", over_batches<T>(beckmann ? pbrt_d_beckmann<T> : pbrt_d_ggx<T>));
  }
  Group<T>(all, "c and s", [](std::size_t k) {
    return Exact{Quad(inputs<T>().o.z[k])};
  }).add_kernel(over_batches<T>([](double alpha, kernels::Vectors<T> o, kernels::Vectors<T>, T* out, std::size_t n) {
    static std::vector<T> s(batch);
    kernels::project({alpha, alpha}, o, out, s.data(), n);
  }));
}

template <class T>
void add_brdfs(std::vector<Case>& all) {
  constexpr bool is_double = sizeof(T) == sizeof(double);
  Group<T> ggx(all, "BRDF GGX", [](std::size_t k) { return exact_brdf<T>(Model::ggx, k); });
  ggx.add_kernel(over_batches<T>(brdf_kernel<T>(kernels::Distribution::ggx)));
  ggx.add("as pbrt-v4", over_batches<T>(pbrt_ggx<T>), is_double ? 10 : 0);
  ggx.add("lean isotropic", over_batches<T>(lean_ggx<T>));
  Group<T> beckmann(all, "BRDF Beckmann", [](std::size_t k) { return exact_brdf<T>(Model::beckmann, k); });
  beckmann.add_kernel(over_batches<T>(brdf_kernel<T>(kernels::Distribution::beckmann)));
  beckmann.add("as pbrt, std::erf", over_batches<T>(pbrt_beckmann<T>), is_double ? 12 : 0);
  beckmann.add("lean isotropic, std::erf", over_batches<T>(lean_beckmann<T>));
  if constexpr (is_double) {
    Group<T> conductor(all, "BRDF GGX conductor",
                       [](std::size_t k) { return exact_conductor(k, conductor_eta, conductor_k); });
    conductor.add("brdfplot evaluate", evaluate_conductors(conductor_eta, conductor_k));
    conductor.add("as pbrt-v4", over_batches<T>(pbrt_conductor));
    Group<T> gold(all, "BRDF GGX gold RGB", [](std::size_t k) { return exact_conductor(k, gold_eta[0], gold_k[0]); });
    gold.add("brdfplot evaluate", evaluate_conductors(gold_eta, gold_k));
    gold.add("as pbrt-v4", over_batches<T>(pbrt_gold), 6);
  }
}

template <class T>
void add_all(std::vector<Case>& all) {
  add_masking<T>(all);
  add_densities<T>(all);
  add_brdfs<T>(all);
}

} // namespace

const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    add_all<double>(list);
    add_all<float>(list);
    return list;
  }();
  return all;
}

} // namespace brdfplot::bench
