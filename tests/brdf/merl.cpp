// MERL files: their coordinates against the rotations of MERL's own reader, written and read back, and what a broken
// one is.
#include "analysis/integrals.hpp"
#include "brdf/measured/merl_writer.hpp"
#include "measured.hpp"

#include <cmath>
#include <limits>
#include <random>

using namespace test;

namespace {

using std::numbers::pi;

/// Directions above the horizon, even over the hemisphere.
Direction any_direction(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double z = unit(random);
  return from_angles(std::acos(z), 2 * pi * unit(random));
}

Direction rotated_about_z(const Direction& d, double angle) {
  return {std::cos(angle) * d.x - std::sin(angle) * d.y, std::sin(angle) * d.x + std::cos(angle) * d.y, d.z};
}

Direction rotated_about_y(const Direction& d, double angle) {
  return {std::cos(angle) * d.x + std::sin(angle) * d.z, d.y, -std::sin(angle) * d.x + std::cos(angle) * d.z};
}

/// As Matusik's reader has them: the light rotated by -phi_h about the normal, then by -theta_h about the binormal.
HalfDifference by_rotation(const Direction& o, const Direction& i) {
  const Direction h = half_vector(o, i);
  const double theta_h = std::acos(h.z), phi_h = std::atan2(h.y, h.x);
  const Direction d = rotated_about_y(rotated_about_z(i, -phi_h), -theta_h);
  return {theta_h, phi_h, std::acos(d.z), std::atan2(d.y, d.x)};
}

std::string merl_file(const std::array<std::int32_t, 3>& sides, const std::vector<double>& values) {
  std::string bytes;
  for (const std::int32_t side : sides) append_raw(bytes, side);
  for (const double value : values) append_raw(bytes, value);
  return bytes;
}

double rho(const Material& material, const Direction& o, const Direction& i) {
  return evaluate(material, Quantity::brdf, o, i, std::nullopt);
}

Material read_back(const MeasuredFolder& folder, const Material& material, const MerlGrid& grid) {
  return build(measured("merl", folder.write("written.binary", merl_bytes(material, 2, grid))));
}

Material lambert(double albedo) {
  TermDescription term;
  term.type = "lambert";
  term.values.set("albedo", albedo);
  return build(term);
}

} // namespace

TEST_CASE("half and difference angles are those of MERL's rotations, and lead back to the pair") {
  std::mt19937_64 random(3);
  for (int k = 0; k < 2000; ++k) {
    const Direction o = any_direction(random), i = any_direction(random);
    const HalfDifference at = half_difference(o, i), expected = by_rotation(o, i), back = half_difference(i, o);
    INFO(k);
    CHECK(at.theta_h == doctest::Approx(expected.theta_h).epsilon(1e-7));
    CHECK(at.phi_h == doctest::Approx(expected.phi_h).epsilon(1e-7));
    CHECK(at.theta_d == doctest::Approx(expected.theta_d).epsilon(1e-7));
    CHECK(at.phi_d == doctest::Approx(expected.phi_d).epsilon(1e-6));
    CHECK(std::fabs(std::remainder(back.phi_d - at.phi_d - pi, 2 * pi)) < 1e-10);
    const ViewerAndLight pair = pair_of(at);
    CHECK(std::fabs(pair.o.x - o.x) + std::fabs(pair.o.y - o.y) + std::fabs(pair.o.z - o.z) < 1e-14);
    CHECK(std::fabs(pair.i.x - i.x) + std::fabs(pair.i.y - i.y) + std::fabs(pair.i.z - i.z) < 1e-14);
  }
}

TEST_CASE("half and difference angles at the normal and in the plane of incidence do not follow rounding") {
  for (const double phi : {0.0, 0.3, 1.9, -2.5}) {
    const Direction o = from_angles(0.7, phi), mirrored = {-o.x, -o.y, o.z};
    CHECK(half_difference(o, mirrored).phi_d == 0);
    CHECK(half_difference(o, o).theta_d == 0);
    for (const double theta_i : {-1.2, -0.3, 0.2, 1.4}) {
      const double phi_d = half_difference(o, from_angles(theta_i, phi)).phi_d;
      const bool in_plane = phi_d == 0 || phi_d == pi;
      CHECK(in_plane);
    }
  }
}

TEST_CASE("a cell's sample lies in it and above the horizon") {
  // As many as counted apart, from the cosines at the corners.
  const MerlGrid grid;
  std::size_t reaching = 0, above = 0;
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    const MerlCell cell(grid, k);
    above += cell.is_above();
    if (!cell.reaches_above()) continue;
    ++reaching;
    if (k % 7 != 0) continue;
    const HalfDifference at = cell.sample();
    REQUIRE(grid.cell_of(at) == k);
    const ViewerAndLight pair = pair_of(at);
    REQUIRE(pair.o.z > 0);
    REQUIRE(pair.i.z > 0);
    REQUIRE(grid.cell_of(half_difference(pair.o, pair.i)) == k);
  }
  CHECK(reaching == 1114044);
  CHECK(above == 1076596); // and 4 that touch the horizon with a corner
}

TEST_CASE("what is written as MERL is read back: at the samples to rounding, elsewhere within the sampling") {
  const MeasuredFolder folder;
  const MerlGrid grid{20, 18, 24};
  const Material ggx = material("ggx", 0.4), back = read_back(folder, ggx, grid);
  CHECK(back.channels() == 3);
  std::mt19937_64 random(5);
  for (int k = 0; k < 5000; ++k) {
    const Direction o = any_direction(random), i = any_direction(random);
    const MerlCell cell(grid, grid.cell_of(half_difference(o, i)));
    const ViewerAndLight pair = pair_of(cell.sample());
    INFO(k);
    CHECK(rho(back, o, i) == doctest::Approx(rho(ggx, pair.o, pair.i)).epsilon(1e-13));
    CHECK(rho(back, i, o) == rho(back, o, i));
    CHECK(evaluate(back, Quantity::brdf_cos, o, i, std::nullopt) == rho(back, o, i) * i.z);
  }
  CHECK(rho(back, from_angles(0.5, 0), {1, 0, 0}) == 0);
  CHECK(rho(back, from_angles(1.7, 0), from_angles(0.5, 0)) == 0);
}

TEST_CASE("a whole MERL file agrees with its material within its cells") {
  // A degree of theta_d and phi_d, and 1/90 of the square root of theta_h: measured over 1e5 pairs.
  const MeasuredFolder folder;
  const Material ggx = material("ggx", 0.4), back = read_back(folder, ggx, {});
  CHECK(std::filesystem::file_size(std::filesystem::path(folder.path()) / "written.binary") == 34992012);
  std::mt19937_64 random(7);
  double sum = 0, worst = 0;
  int count = 0;
  for (int k = 0; k < 100000; ++k) {
    const Direction o = any_direction(random), i = any_direction(random);
    if (o.z < 0.2 || i.z < 0.2) continue; // where a degree is much
    const double error = rho(back, o, i) / rho(ggx, o, i) - 1;
    worst = std::fmax(worst, std::fabs(error));
    sum += error * error;
    ++count;
  }
  CHECK(worst < 0.08);
  CHECK(std::sqrt(sum / count) < 0.02);
}

TEST_CASE("one channel is written as three, and colours as they are") {
  const MeasuredFolder folder;
  TermDescription term;
  term.type = "lambert";
  term.values.set("albedo", Rgb{0.1, 0.5, 0.9});
  const Material back = read_back(folder, build(term), {4, 4, 4});
  const Direction o = from_angles(0.3, 0), i = from_angles(0.6, 2);
  std::array<double, 3> out{};
  evaluate(back, Quantity::brdf, {1, {&o.x, &o.y, &o.z}, {&i.x, &i.y, &i.z}, {}}, out.data());
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(out[c] == doctest::Approx(std::get<Rgb>(term.values.map().at("albedo"))[c] / pi).epsilon(1e-14));
}

TEST_CASE("what a MERL file cannot say is not written") {
  const auto error = [](const Material& material) { return bad_input([&] { merl_bytes(material, 1, {3, 3, 3}); }); };
  CHECK(error(build(general("ggx", 0.2, 0.5, 0))).find("is not isotropic") != std::string::npos);
  CHECK(error(build(general("ggx", 0.5, 0.5, 0, {0.1, 0}))) != "");
  TermDescription cloth;
  cloth.type = "uncharted2";
  for (const char* key : {"rim", "rim_power", "inner", "inner_power", "diffuse"}) cloth.values.set(key, 0.5);
  CHECK(error(build(cloth)).find("a reciprocal BRDF") != std::string::npos);
  CHECK(error(material("ggx", 0.5)) == "");
}

TEST_CASE("integrals of a MERL table: constant cells are a Lambertian") {
  const MeasuredFolder folder;
  const Material back = read_back(folder, lambert(0.7), {9, 10, 12});
  for (const double theta : {0.0, 1e-9, 20 * degree, 45 * degree, 75 * degree, 89 * degree, 89.99 * degree})
    for (const double phi : {0.0, 2.2}) {
      INFO("theta_o = " << theta << ", phi_o = " << phi);
      const Estimate albedo = compute(Integral::albedo, back, from_angles(theta, phi), 1e-9);
      CHECK(std::fabs(albedo.value - 0.7) < 1e-9);
      CHECK(albedo.error < 1e-9);
      CHECK(std::fabs(compute(Integral::mean_theta_i, back, from_angles(theta, phi), 1e-7).value) < 1e-7);
    }
}

TEST_CASE("integrals of a MERL table: random cells against a plain sum over the hemisphere") {
  // Midpoints in theta_i and phi_i: jumps leave an error of 1.3e-4, a quarter of that with 16 times as many. At the
  // normal theta_h = theta_d = theta_i / 2 and phi_d = 0: an integral over intervals.
  const MeasuredFolder folder;
  const MerlGrid grid{6, 5, 8};
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> value(0, 1500);
  std::vector<double> values(3 * grid.cells());
  for (double& one : values) one = value(random);
  const Material table = build(measured("merl", folder.write("random.binary", merl_file({6, 5, 8}, values))));
  double at_normal = 0;
  constexpr int pieces = 100000;
  for (int k = 0; k < pieces; ++k) {
    const double from = k * 0.5 * pi / pieces, to = from + 0.5 * pi / pieces, half = 0.25 * (from + to);
    const std::size_t cell = grid.cell_of({half, 0, half, 0});
    at_normal += values[grid.cells() + cell] * 1.15 / 1500 * pi *
                 (std::cos(from) * std::cos(from) - std::cos(to) * std::cos(to));
  }
  CHECK(std::fabs(compute(Integral::albedo, table, {0, 0, 1}, 1e-9, 1).value - at_normal) < 1e-5);
  for (const double theta_o : {0.4, 1.1, 1.5}) {
    const Direction o = from_angles(theta_o, 0.6);
    constexpr int rows = 3000, columns = 2400;
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
    const Estimate albedo = compute(Integral::albedo, table, o, 1e-6, 1);
    INFO("theta_o = " << theta_o << ", error estimate " << albedo.error << ", circles " << albedo.evaluations);
    CHECK(std::fabs(albedo.value - sum) < 2e-4);
    CHECK(albedo.error < 1e-6);
  }
}

TEST_CASE("a broken MERL file is one line that says what is wrong") {
  const MeasuredFolder folder;
  const auto error = [&](const std::string& bytes) {
    return bad_input([&] { read_merl(folder.write("broken.binary", bytes)); });
  };
  const std::vector<double> good(3 * 8, 1.0);
  const std::string whole = merl_file({2, 2, 2}, good);
  CHECK(error(whole) == "");
  // Cut at every byte of the header, and at the edges of the values.
  for (std::size_t length = 0; length < whole.size(); length += length < 16 ? 1 : 4)
    CHECK(error(whole.substr(0, length)) != "");
  CHECK(error(whole.substr(0, 11)).find("ends within the header") != std::string::npos);
  CHECK(error(whole.substr(0, 40)).find("in a file of 40 bytes") != std::string::npos);
  CHECK(error(whole + "x") != "");
  CHECK(error(whole + std::string(24, '\0')) != "");
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  for (const auto& sides : std::vector<std::array<std::int32_t, 3>>{{-2, 2, 2},
                                                                    {-2, -2, 2},
                                                                    {0, 2, 2},
                                                                    {2, 2, 0},
                                                                    {most, most, most},
                                                                    {1 << 30, 1 << 30, 16}, // 2^64: 0 in 64 bits
                                                                    {1 << 16, 1 << 16, 1 << 16},
                                                                    {90, 90, 180},
                                                                    {2, 2, 3}})
    CHECK(error(merl_file(sides, good)).find("found " + std::to_string(sides[0]) + " x") != std::string::npos);
  CHECK(error("{\"name\": \"not a table at all, but text\"}") != "");
  for (const double bad : {std::nan(""), infinity, -infinity, -1.0}) {
    std::vector<double> values = good;
    values[9] = bad; // green, theta_h 0, theta_d 0, phi_d 1
    INFO(bad);
    CHECK(error(merl_file({2, 2, 2}, values)).find("for green in the cell (theta_h 0, theta_d 0, phi_d 1)") !=
          std::string::npos);
  }
  CHECK_THROWS_WITH_AS(read_merl(folder.path()), (folder.path() + ": cannot read: it is no regular file").c_str(),
                       FileError);
  CHECK_THROWS_AS(read_merl(folder.path() + "/none"), FileError);
}

TEST_CASE("a negative number is no value: in a cell that reaches below the horizon there is no light") {
  const MeasuredFolder folder;
  std::vector<double> values(3 * 8, 1500.0);
  for (std::size_t c = 0; c < 3; ++c) values[c * 8 + 7] = -1; // theta_h and theta_d of the upper half
  const Material table = build(measured("merl", folder.write("marked.binary", merl_file({2, 2, 2}, values))));
  const ViewerAndLight marked = pair_of({0.5, 0, 0.85, 2.0}), other = pair_of({0.5, 0, 0.7, 2.0});
  CHECK(std::min(marked.o.z, marked.i.z) > 0);
  CHECK(rho(table, marked.o, marked.i) == 0);
  CHECK(rho(table, other.o, other.i) == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("a file that has changed is read again") {
  const MeasuredFolder folder;
  const std::string path = folder.write("one.binary", merl_file({1, 1, 1}, {1500, 0, 0}));
  const Direction o = from_angles(0.3, 0);
  CHECK(rho(build(measured("merl", path)), o, o) == doctest::Approx(1).epsilon(1e-14));
  folder.write("one.binary", merl_file({1, 1, 2}, {3000, 3000, 0, 0, 0, 0}));
  CHECK(rho(build(measured("merl", path)), o, o) == doctest::Approx(2).epsilon(1e-14));
}

TEST_CASE("a table with steps has no peak") {
  const MeasuredFolder folder;
  const Material table = build(measured("merl", folder.write("one.binary", merl_file({1, 1, 1}, {1500, 0, 0}))));
  for (const IntegralInfo& info : integrals())
    if (info.name.find("peak") != std::string::npos)
      CHECK(bad_input([&] { require(table, info); }).find("has steps") != std::string::npos);
}
