/// What holds for the kernels on every instruction set besides accuracy: choice, bytes, and the ends of the domain.
#include "accuracy/directions.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <cstring>

namespace {

using namespace brdfplot;
using namespace brdfplot::accuracy;
using kernels::Distribution;
using kernels::Isa;
using kernels::Shadowing;

constexpr std::array shadowings = {Shadowing::none, Shadowing::separable, Shadowing::minimum,
                                   Shadowing::height_correlated};

/// Every kernel of one type on the same arrays: the outputs, one after the other.
template <class T>
std::vector<T> all_kernels(const kernels::Stretch& k, const Arrays<T>& o, const Arrays<T>& i, std::size_t first,
                           std::size_t n) {
  const auto at = [first](kernels::Vectors<T> v) { return kernels::Vectors<T>{v.x + first, v.y + first, v.z + first}; };
  std::vector<T> c(n), s(n), value(n), all;
  const auto keep = [&] { all.insert(all.end(), value.begin(), value.end()); };
  kernels::project(k, at(o.view()), c.data(), s.data(), n);
  for (const auto function :
       {static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::masked_area_beckmann),
        static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::masked_area_ggx),
        static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::lambda_beckmann),
        static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::lambda_ggx),
        static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::masked_area_beckmann_walter),
        static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::lambda_beckmann_walter)}) {
    function(c.data(), s.data(), value.data(), n);
    keep();
  }
  kernels::lambda_beckmann(c.data(), value.data(), n);
  keep();
  kernels::lambda_ggx(c.data(), value.data(), n);
  keep();
  kernels::d_beckmann(k, at(o.view()), value.data(), n);
  keep();
  kernels::d_ggx(k, at(o.view()), value.data(), n);
  keep();
  for (const auto distribution : {Distribution::beckmann, Distribution::ggx})
    for (const auto shadowing : shadowings) {
      kernels::brdf(k, distribution, shadowing, at(o.view()), at(i.view()), value.data(), n);
      keep();
    }
  return all;
}

template <class T>
void check_bytes(const kernels::Stretch& k) {
  Arrays<T> o, i;
  for (const auto& in : draw_cases<T>("isotropic", 700))
    for (const auto& pair : in.pairs) {
      o.push_back(pair.o);
      i.push_back(pair.i);
    }
  const std::size_t n = 689;
  const auto whole = all_kernels(k, o, i, 0, n);
  const std::size_t kinds = whole.size() / n;
  for (const std::size_t size : {1U, 7U, 64U, 129U, 333U}) {
    for (std::size_t first = 0; first < n; first += size) {
      const std::size_t count = std::min(size, n - first);
      const auto part = all_kernels(k, o, i, first, count);
      for (std::size_t kind = 0; kind < kinds; ++kind)
        REQUIRE(std::memcmp(part.data() + kind * count, whole.data() + kind * n + first, count * sizeof(T)) == 0);
    }
  }
}

} // namespace

TEST_CASE("kernels: an element's bytes depend on that element alone") {
  for_each_isa([](const std::string& isa) {
    CAPTURE(isa);
    for (const kernels::Stretch& k : {kernels::Stretch{0.3, 0.2}, kernels::Stretch{0.3, 0.2, 0.5, 0.1, -0.2}}) {
      check_bytes<double>(k);
      check_bytes<float>(k);
    }
  });
}

TEST_CASE_TEMPLATE("kernels: at and below the horizon, and without a half vector, 0", T, double, float) {
  // The last pair is opposite and grazing: neither is lit, and there is no half vector.
  const std::vector<std::array<T, 3>> up = {{0, 0, 1}, {T(0.6), 0, T(0.8)}, {1, 0, 0}},
                                      down = {{1, 0, 0}, {T(0.6), 0, T(-0.8)}, {-1, 0, 0}};
  for_each_isa([&](const std::string& isa) {
    CAPTURE(isa);
    for (const kernels::Stretch& k : {kernels::Stretch{0.3, 0.2}, kernels::Stretch{0.3, 0.2, 0.5, 0, -0.2}})
      for (const auto distribution : {Distribution::beckmann, Distribution::ggx})
        for (const auto shadowing : shadowings)
          for (std::size_t j = 0; j < up.size(); ++j) {
            Arrays<T> o, i;
            o.push_back(up[j]);
            i.push_back(down[j]);
            T value = -1;
            kernels::brdf(k, distribution, shadowing, o.view(), i.view(), &value, 1);
            CHECK(value == 0);
            kernels::brdf(k, distribution, shadowing, i.view(), o.view(), &value, 1);
            CHECK(value == 0);
          }
  });
}

TEST_CASE_TEMPLATE("kernels: limits", T, double, float) {
  const T infinity = std::numeric_limits<T>::infinity();
  for_each_isa([&](const std::string& isa) {
    CAPTURE(isa);
    const std::array<T, 4> c = {1, 0, 0, -1}, s = {0, 0, T(0.5), T(0.5)};
    std::array<T, 4> out{};
    kernels::masked_area_beckmann(c.data(), s.data(), out.data(), 4);
    CHECK(out[0] == 0);
    CHECK(out[1] == 0);
    CHECK(out[2] == doctest::Approx(0.5 / (2 * std::sqrt(3.14159265358979))));
    kernels::masked_area_ggx(c.data(), s.data(), out.data(), 4);
    CHECK(out[0] == 0);
    CHECK(out[1] == 0);
    CHECK(out[2] == T(0.25));
    for (const auto lambda :
         {static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::lambda_beckmann),
          static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::lambda_ggx),
          static_cast<void (*)(const T*, const T*, T*, std::size_t)>(kernels::lambda_beckmann_walter)}) {
      lambda(c.data(), s.data(), out.data(), 4);
      CHECK(out[0] == 0);
      CHECK(out[1] == infinity);
      CHECK(out[2] == infinity);
      CHECK(out[3] == infinity);
    }
  });
}

TEST_CASE("kernels: the choice of an instruction set") {
  const auto available = kernels::available_isas();
  REQUIRE(!available.empty());
  CHECK(available.front() == Isa::baseline);
  const Isa before = kernels::active_isa();
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
    const bool has = std::find(available.begin(), available.end(), isa) != available.end();
    CHECK(kernels::use_isa(isa) == has);
    if (has) CHECK(kernels::active_isa() == isa);
  }
  kernels::use_isa(before);

  const char* const set = std::getenv("BRDFPLOT_ISA");
  const std::string saved = set == nullptr ? "" : set;
  setenv("BRDFPLOT_ISA", "baseline", 1);
  CHECK(!kernels::isa_request_error());
  setenv("BRDFPLOT_ISA", "sse9", 1);
  const auto error = kernels::isa_request_error();
  REQUIRE(error);
  CHECK(error->find("\"sse9\"") != std::string::npos);
  CHECK(error->find("baseline") != std::string::npos);
  if (set == nullptr)
    unsetenv("BRDFPLOT_ISA");
  else
    setenv("BRDFPLOT_ISA", saved.c_str(), 1);
}
