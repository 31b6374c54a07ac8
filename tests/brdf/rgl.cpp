// Tensor files of the RGL database, made of closed forms: the files themselves are too large, and not ours to give.
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "analysis/properties.hpp"
#include "rgl_file.hpp"

#include <algorithm>
#include <limits>
#include <random>

using namespace test;

namespace {

using std::numbers::pi;

Direction any_direction(std::mt19937_64& random, double lowest = 0) {
  std::uniform_real_distribution<double> unit(0, 1);
  return from_angles(std::acos(lowest + (1 - lowest) * unit(random)), 2 * pi * unit(random));
}

Rgb rho(const Material& material, const Direction& o, const Direction& i) {
  Rgb out{};
  evaluate(material, Quantity::brdf, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, out.data());
  return out;
}

TermDescription coloured(double alpha_x, double alpha_y) {
  TermDescription term = general("ggx", alpha_x, alpha_y, 0);
  term.fresnel = {"schlick", {}};
  term.fresnel.values.set("f0", Rgb{0.9, 0.5, 0.1});
  return term;
}

Material as_file(const MeasuredFolder& folder, const Material& material, const RglSizes& sizes) {
  return build(measured("rgl", folder.write("made.bsdf", tensor_bytes(rgl_of(material, sizes, folder)))));
}

/// The largest and the root mean square relative difference of two materials, above 12 degrees.
struct Difference {
  double worst = 0, mean = 0;
};

Difference difference(const Material& a, const Material& b) {
  std::mt19937_64 random(17);
  Difference out;
  constexpr int count = 4000;
  for (int k = 0; k < count; ++k) {
    const Direction o = any_direction(random, 0.2), i = any_direction(random, 0.2);
    const Rgb x = rho(a, o, i), y = rho(b, o, i);
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = std::fabs(x[c] / y[c] - 1);
      out.worst = std::fmax(out.worst, error);
      out.mean += error * error / (3 * count);
    }
  }
  out.mean = std::sqrt(out.mean);
  return out;
}

std::vector<float> turn(double from, double to, std::size_t count) {
  std::vector<float> out;
  for (std::size_t k = 0; k < count; ++k)
    out.push_back(static_cast<float>(from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1)));
  return out;
}

/// The smallest whole file: constant but for theta_i.
std::vector<TensorArray> smallest() {
  return {{"phi_i", {1}, {0}},
          {"theta_i", {2}, {0, 1}},
          {"ndf", {2, 2}, std::vector<float>(4, 1)},
          {"sigma", {2, 2}, std::vector<float>(4, 1)},
          {"vndf", {1, 2, 2, 2}, std::vector<float>(8, 1)},
          {"rgb", {1, 2, 3, 2, 2}, std::vector<float>(24, 1)},
          {"jacobian", {1}, {}, 1, "\1"}};
}

} // namespace

TEST_CASE("the warp of a tensor file is the distribution function of its density") {
  // Its Jacobian, by differences, is the density, bilinear and normalised; here between two slices.
  const MeasuredFolder folder;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<float> value(0.1F, 1);
  auto arrays = smallest();
  arrays[4] = {"vndf", {1, 2, 4, 5}, {}};
  for (int k = 0; k < 40; ++k) arrays[4].values.push_back(value(random));
  const RglTable table = read_rgl(folder.write("warp.bsdf", tensor_bytes(arrays)));
  const Direction i = from_angles(0.25, 0);
  const auto density = [&](const Vec2& u) {
    double sum = 0;
    for (std::size_t slice = 0; slice < 2; ++slice) {
      const std::vector<float> grid(arrays[4].values.begin() + static_cast<std::ptrdiff_t>(20 * slice),
                                    arrays[4].values.begin() + static_cast<std::ptrdiff_t>(20 * slice + 20));
      const Bilinear f(5, 4, grid);
      double total = 0; // of the corners' means, exact for what is bilinear
      for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 4; ++x)
          total += f.at({(static_cast<double>(x) + 0.5) / 4, (static_cast<double>(y) + 0.5) / 3}) / 12;
      sum += (slice == 0 ? 0.75 : 0.25) * f.at(u) / total;
    }
    return sum;
  };
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  for (int k = 0; k < 200; ++k) {
    const Vec2 u = {unit(random), unit(random)};
    constexpr double h = 1e-5;
    const auto in_one_cell = [](double x, double n) { return std::floor((x - h) * n) == std::floor((x + h) * n); };
    if (!in_one_cell(u[0], 4) || !in_one_cell(u[1], 3)) continue;
    const Vec2 right = table.placed(i, {u[0] + h, u[1]}), left = table.placed(i, {u[0] - h, u[1]});
    const Vec2 up = table.placed(i, {u[0], u[1] + h}), down = table.placed(i, {u[0], u[1] - h});
    CHECK(right[1] == left[1]);
    const double jacobian = (right[0] - left[0]) * (up[1] - down[1]) / (4 * h * h);
    CHECK(jacobian == doctest::Approx(density(u)).epsilon(1e-6));
  }
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 0.3, 1.0}) {
      CHECK(table.placed(i, {x, y})[0] == doctest::Approx(x));
      if (y != 0.3) CHECK(table.placed(i, {0.4, y})[1] == doctest::Approx(y));
    }
}

TEST_CASE("a constant M is a mirror with the masking of one direction") {
  // rho cos theta_i = D / (4 sigma(o)) = D G1(o) / (4 cos theta_o): tabulated are D and sigma alone.
  const MeasuredFolder folder;
  TermDescription term = describe("ggx", 0.5);
  term.shadowing = ModelChoice{"none", {}};
  auto arrays = rgl_of(build(term), {256, 4, 4, {0}}, folder);
  std::ranges::fill(arrays[6].values, 1.0F);
  const Material table = build(measured("rgl", folder.write("mirror.bsdf", tensor_bytes(arrays)))),
                 mirror = build(term);
  std::mt19937_64 random(4);
  for (int k = 0; k < 2000; ++k) {
    const Direction o = any_direction(random, 0.1), i = any_direction(random, 0.1);
    const double expected = rho(mirror, o, i)[0];
    for (const double value : rho(table, o, i)) CHECK(value == doctest::Approx(expected).epsilon(2e-3));
  }
}

TEST_CASE("an isotropic material as a tensor file is that material within the sampling") {
  const MeasuredFolder folder;
  const Material ggx = build(coloured(0.4, 0.4)), table = as_file(folder, ggx, {});
  CHECK(table.channels() == 3);
  CHECK(table.terms[0].is_isotropic());
  const Difference coarse = difference(table, ggx);
  CHECK(coarse.worst < 0.2);
  CHECK(coarse.mean < 0.02);
  if (!sampled()) {
    const Difference fine = difference(as_file(folder, ggx, {128, 64, 32, {0}}), ggx);
    CHECK(fine.mean < 0.4 * coarse.mean); // of the second order in each length
  }
  CHECK(rho(table, from_angles(0.5, 0), {1, 0, 0}) == Rgb{});
  CHECK(rho(table, from_angles(1.7, 0), from_angles(0.5, 0)) == Rgb{});
}

TEST_CASE("an anisotropic material as a tensor file: the circle, its half and its quarter") {
  const MeasuredFolder folder;
  const Material ggx = build(coloured(0.4, 0.6));
  const std::vector<std::vector<float>> ranges = {turn(-pi, -0.5 * pi, 9), turn(0, 0.5 * pi, 9), turn(-pi, 0, 17),
                                                  turn(-pi, pi, 33)};
  for (const auto& phi_i : sample_of(ranges, 2)) {
    INFO("phi_i from " << phi_i.front() << " to " << phi_i.back());
    const Material table = as_file(folder, ggx, {64, 24, 10, phi_i});
    CHECK(!table.terms[0].is_isotropic());
    const Difference found = difference(table, ggx);
    CHECK(found.worst < 0.4);
    CHECK(found.mean < 0.04);
  }
}

TEST_CASE("integrals of a tensor file against a plain sum over the hemisphere, and its material") {
  const MeasuredFolder folder;
  const Material ggx = build(coloured(0.15, 0.15)), table = as_file(folder, ggx, {});
  for (const double theta_o : sample_of<double>({0.4, 0.0, 1.4}, 3)) {
    const Direction o = from_angles(theta_o, 0.6);
    constexpr int rows = 600, columns = 600;
    std::vector<double> x(columns), y(columns), z(columns), out(3 * columns);
    const std::vector<double> o_x(columns, o.x), o_y(columns, o.y), o_z(columns, o.z);
    double sum = 0;
    for (int row = 0; row < rows; ++row) {
      const double theta = (row + 0.5) / rows * 0.5 * pi;
      for (std::size_t k = 0; k < columns; ++k) {
        const Direction i = from_angles(theta, (static_cast<double>(k) + 0.5) / columns * 2 * pi);
        x[k] = i.x, y[k] = i.y, z[k] = i.z;
      }
      evaluate(table, Quantity::brdf_cos,
               {columns, {o_x.data(), o_y.data(), o_z.data()}, {x.data(), y.data(), z.data()}, {}}, out.data());
      for (std::size_t k = 0; k < columns; ++k) sum += out[columns + k] * std::sin(theta);
    }
    sum *= 0.5 * pi / rows * 2 * pi / columns;
    const Estimate albedo = compute(Integral::albedo, table, o, 3e-4, 1);
    INFO("theta_o = " << theta_o << ", error estimate " << albedo.error << ", evaluations " << albedo.evaluations);
    CHECK(albedo.error < 3e-4);
    CHECK(std::fabs(albedo.value - sum) < 1e-4);
    CHECK(std::fabs(albedo.value - compute(Integral::albedo, ggx, o, 1e-6, 1).value) < 0.01);
  }
}

TEST_CASE("a tensor file is reciprocal within its sampling, which is measured") {
  const MeasuredFolder folder;
  const std::string path =
      folder.write("made.bsdf", tensor_bytes(rgl_of(build(coloured(0.4, 0.4)), {32, 16, 8, {0}}, folder)));
  const Residual residual = measure(Property::reciprocity, {MaterialDescription(measured("rgl", path))}, {});
  CHECK(residual.verdict == Verdict::fails);
  CHECK(residual.max_residual > 1e-4);
}

TEST_CASE("a broken tensor file is one line that says what is wrong") {
  const MeasuredFolder folder;
  const auto error = [&](const std::vector<TensorArray>& arrays) {
    return bad_input([&] { read_rgl(folder.write("broken.bsdf", tensor_bytes(arrays))); });
  };
  const auto error_of_bytes = [&](const std::string& bytes) {
    return bad_input([&] { read_rgl(folder.write("broken.bsdf", bytes)); });
  };
  const auto with = [](std::size_t index, const auto& change) {
    auto arrays = smallest();
    change(arrays[index]);
    return arrays;
  };
  CHECK(error(smallest()) == "");
  std::vector<std::size_t> ends;
  const std::string whole = tensor_bytes(smallest(), &ends);
  std::ranges::sort(ends);
  for (const std::size_t end : ends)
    for (const std::size_t length : {end - 1, end})
      if (length < whole.size()) CHECK(error_of_bytes(whole.substr(0, length)) != "");
  CHECK(error_of_bytes("") != "");
  CHECK(error_of_bytes("{\"name\": \"text\"}").find("tensor file") != std::string::npos);
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const auto has = [&](const std::string& found, const char* part) {
    INFO(found);
    CHECK(found.find(part) != std::string::npos);
  };
  has(error(with(5, [](TensorArray& a) { a.shape = {1, 2, 3, most, most}; })), "in a file of");
  has(error(with(5, [](TensorArray& a) { a.shape = {1ULL << 32, 1ULL << 32, 3, 2, 2}; })), "in a file of");
  has(error(with(5, [](TensorArray& a) { a.shape = {1, 2, 3, 2, 3}; })), "in a file of");
  has(error(with(4, [](TensorArray& a) { a.shape = {2, 1, 2, 2}; })), "for 2 phi_i and 1 theta_i");
  has(error(with(5, [](TensorArray& a) { a.shape = {1, 2, 2, 3, 2}; })), "2 channels");
  has(error(with(2, [](TensorArray& a) { a.shape = {4, 1}; })), "2 or more");
  has(error(with(2, [](TensorArray& a) { a.shape = {0, 2}; })), "2 or more");
  has(error(with(2, [](TensorArray& a) { a.shape = {4}; })), "1 dimensions");
  has(error(with(2, [](TensorArray& a) { a.type = 6; })), "type 6");
  has(error(with(2, [](TensorArray& a) { a.type = 12; })), "type 12");
  has(error(with(2, [](TensorArray& a) { a.name = "nfd"; })), "no array \"ndf\"");
  has(error(with(2, [](TensorArray& a) { a.name = "rgb"; })), "twice");
  has(error(with(2, [](TensorArray& a) { a.values[1] = -1; })), "found -1 in the array \"ndf\"");
  has(error(with(3, [](TensorArray& a) { a.values[1] = 0; })), "found 0 in the array \"sigma\"");
  has(error(with(4, [](TensorArray& a) { a.values.assign(8, 0); })), "0 everywhere");
  has(error(with(5, [](TensorArray& a) { a.values[7] = std::nanf(""); })), "place 7 of the array \"rgb\"");
  has(error(with(1, [](TensorArray& a) { a.values = {1, 1}; })), "do not ascend");
  has(error(with(1, [](TensorArray& a) { a.values = {0, 2}; })), "within [0, pi/2]");
  has(error(with(6, [](TensorArray& a) { a.raw = std::string(1, '\0'); })), "jacobian 0");
  CHECK(error(with(5, [](TensorArray& a) { a.values[7] = -1; })) == ""); // outside a gamut
  std::string bytes = whole;
  bytes[12] = 2;
  has(error_of_bytes(bytes), "version 2.0");
  bytes = whole;
  bytes[17] = '\x7f';
  has(error_of_bytes(bytes), "arrays; accepted: up to 256");
}
