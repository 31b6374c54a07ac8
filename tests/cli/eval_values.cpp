#include "cli/program.hpp"

#include <cmath>
#include <numbers>

using namespace test;

namespace {

const std::string ggx = R"({"distribution": {"type": "ggx", "alpha": 1}})";

/// The values of `quantities` in the one row of `csv`, behind its `skipped` columns.
std::vector<double> values(const std::string& material, const std::string& csv, const std::string& quantities,
                           std::size_t skipped) {
  const Folder folder;
  folder.write("m.json", material);
  folder.write("in.csv", csv);
  const std::string out = check_output(folder, "brdfplot eval m.json -q " + quantities + " -i in.csv");
  std::vector<double> numbers;
  const auto rows = cells(out);
  REQUIRE(rows.size() == 2);
  for (std::size_t k = skipped; k < rows[1].size(); ++k) numbers.push_back(std::stod(rows[1][k]));
  return numbers;
}

} // namespace

TEST_CASE("GGX of roughness 1 at 60 degrees") {
  const auto row = values(ggx, "theta_o,theta_m\n60deg,0\n", "lambda,g1,d,p22,d_visible", 2);
  CHECK(row[0] == doctest::Approx(0.5).epsilon(1e-14)); // (-1 + sqrt(1 + tan^2 60)) / 2
  CHECK(row[1] == doctest::Approx(2.0 / 3).epsilon(1e-14));
  CHECK(row[2] == doctest::Approx(std::numbers::inv_pi).epsilon(1e-14));
  CHECK(row[3] == doctest::Approx(std::numbers::inv_pi).epsilon(1e-14));
  CHECK(row[4] == doctest::Approx(2.0 / 3 * std::numbers::inv_pi).epsilon(1e-14)); // G1 <o,m> D / c
}

TEST_CASE("single precision: the shortest form that reads back to a float") {
  const Folder folder;
  const std::string command = "brdfplot eval configs/materials/ggx.json -q lambda,g1 --precision ";
  const std::string points = " -i configs/points/theta_o.csv";
  CHECK(check_output(folder, command + "double" + points) ==
        check_output(folder, "brdfplot eval configs/materials/ggx.json -q lambda,g1" + points));
  const auto exact = cells(check_output(folder, command + "double" + points));
  const auto single = cells(check_output(folder, command + "single" + points));
  REQUIRE(single.size() == exact.size());
  CHECK(single[0] == exact[0]);
  for (std::size_t row = 1; row < exact.size(); ++row)
    for (std::size_t column = 1; column < 3; ++column) {
      CHECK(std::stof(single[row][column]) == doctest::Approx(std::stod(exact[row][column])).epsilon(1e-6));
      CHECK(single[row][column].size() < 13);
    }
  check_error(folder, command + "half" + points, 2, {"--precision: ", "\"half\"", "accepted: double, single"});
  check_error(folder, "brdfplot eval configs/materials/ggx.json -q g1,albedo --precision single" + points, 2,
              {"--precision: ", "\"albedo\"", "accepted: double"});
}

TEST_CASE("BRDF of GGX of roughness 1 along the normal") {
  const auto row = values(ggx, "theta_o,theta_i\n0,0\n", "brdf,brdf_cos,g2", 2);
  CHECK(row[0] == doctest::Approx(std::numbers::inv_pi / 4).epsilon(1e-14)); // D / 4
  CHECK(row[1] == doctest::Approx(std::numbers::inv_pi / 4).epsilon(1e-14));
  CHECK(row[2] == 1);
}

TEST_CASE("integrals of GGX of roughness 1") {
  const std::string separable = R"({"distribution": {"type": "ggx", "alpha": 1}, "shadowing": {"type": "none"}})";
  const auto at_normal = values(ggx, "theta_o\n0\n", "albedo,furnace,weak_furnace,projected_area,visible_norm", 1);
  CHECK(std::fabs(at_normal[0] - (1 - std::log(2))) < 1e-9);
  CHECK(std::fabs(at_normal[1] - at_normal[0]) < 2e-9);
  for (std::size_t k = 2; k < 5; ++k) CHECK(std::fabs(at_normal[k] - 1) < 1e-9);
  const auto at_60 = values(separable, "theta_o\n60deg\n", "weak_furnace,projected_area,visible_norm", 1);
  CHECK(std::fabs(at_60[0] - 1) < 1e-9);
  CHECK(std::fabs(at_60[1] - 0.5) < 1e-9);
  CHECK(std::fabs(at_60[2] - 1) < 1e-9);
}

TEST_CASE("angles and Cartesian vectors are the same directions") {
  const auto angles = values(ggx, "theta_o,phi_o,theta_i,phi_i\n60deg,0.7,0.3,2\n", "brdf,g2", 4);
  std::ostringstream row;
  row.precision(17);
  row << "x_o,y_o,z_o,theta_i,phi_i\n";
  const double theta = std::numbers::pi / 3;
  row << 5e200 * std::cos(0.7) * std::sin(theta) << ',' << 5e200 * std::sin(0.7) * std::sin(theta) << ','
      << 5e200 * std::cos(theta) << ",0.3,2\n";
  const auto cartesian = values(ggx, row.str(), "brdf,g2", 5);
  for (std::size_t k = 0; k < 2; ++k) CHECK(cartesian[k] == doctest::Approx(angles[k]).epsilon(1e-13));
}

TEST_CASE("a coloured material has three columns where the quantity is coloured") {
  const Folder folder;
  const std::string out = check_output(
      folder, "brdfplot eval configs/materials/rough_gold.json -q brdf,g2,fresnel,albedo -i configs/points/pairs.csv");
  const auto rows = cells(out);
  const std::vector<std::string> header = {"theta_o",   "phi_o",    "theta_i",  "phi_i",     "brdf_r",
                                           "brdf_g",    "brdf_b",   "g2",       "fresnel_r", "fresnel_g",
                                           "fresnel_b", "albedo_r", "albedo_g", "albedo_b"};
  CHECK(rows.at(0) == header);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    REQUIRE(rows[k].size() == header.size());
    const auto at = [&](std::size_t column) { return std::stod(rows[k][column]); };
    CHECK(at(4) / at(8) == doctest::Approx(at(5) / at(9)).epsilon(1e-12)); // rho / F has no colour
    CHECK(at(11) > at(13));                                                // gold: red above blue
  }
}

TEST_CASE("pairs use the half vector, whatever omega_m is") {
  const std::string rougher = R"({"distribution": {"type": "ggx", "alpha": 0.5}})";
  const auto without = values(rougher, "theta_o,theta_i\n0.5,0.2\n", "brdf,g2,d", 2);
  const auto with = values(rougher, "theta_o,theta_i,theta_m\n0.5,0.2,0\n", "brdf,g2,d", 3);
  CHECK(with[0] == without[0]);
  CHECK(with[1] == without[1]);
  CHECK(with[2] == doctest::Approx(4 * std::numbers::inv_pi));
  CHECK(with[2] > without[2]);
}

TEST_CASE("at and below the horizon there is nothing, not NaN") {
  for (const char* o : {"0,0,-1", "1,0,0", "1,0,-1e-300", "0,1,-0.5"}) {
    const auto row = values(ggx, "x_o,y_o,z_o,theta_i\n" + std::string(o) + ",0.5\n",
                            "g1,g2,brdf,brdf_cos,albedo,weak_furnace,visible_norm,projected_area", 4);
    for (const double value : row) CHECK(value == 0);
  }
  const auto opposite = values(ggx, "theta_o,x_i,y_i,z_i\n0,0,0,-1\n", "g1,g2,brdf,brdf_cos", 4);
  for (const double value : opposite) CHECK(value == 0);
}

TEST_CASE("below the horizon facets that are no mirrors reflect nothing, and the rows after it are told") {
  for (const char* facet : {"diffuse", "oren_nayar", "oren_nayar_direct", "oren_nayar_qualitative"}) {
    const Folder folder;
    const std::string nayar =
        R"("distribution": {"type": "oren_nayar", "sigma": 0.4}, "masking": {"type": "v_cavity"})";
    folder.write("m.json", "{" + nayar + R"(, "facet": ")" + std::string(facet) + "\"}");
    folder.write("in.csv", "theta_o,theta_i\n100deg,0.3\n0.3,100deg\n2,2\n180deg,0.1\n90deg,-1.5\n0.3,0.2\n");
    const auto rows = cells(check_output(folder, "brdfplot eval m.json -q brdf,brdf_cos -i in.csv"));
    REQUIRE(rows.size() == 7);
    for (const std::size_t row : {1U, 2U, 3U, 4U})
      for (const std::size_t column : {2U, 3U}) CHECK(rows[row][column] == "0");
    CHECK(std::stod(rows[6][2]) > 0.2);
  }
}

TEST_CASE("90deg is above the horizon by its rounding, and --help says so") {
  CHECK(values(ggx, "theta_o\n90deg\n", "g1", 1)[0] > 0);
  const Folder folder;
  CHECK(check_output(folder, "brdfplot eval --help").find("90deg") != std::string::npos);
}

TEST_CASE("the last guard: what is no number ends the stream with its row") {
  const Folder folder;
  // c + c Lambda is 0 at the second row, and G1 a division by it.
  folder.write("m.json", R"({"distribution": {"type": "ggx", "alpha": 0.5},
    "masking": {"type": "custom", "lambda": "theta > 1 ? -1 : 0"}})");
  folder.write("in.csv", "theta_o,theta_i\n0.5,0.1\n1.2,0.1\n");
  for (const char* precision : {"double", "single"}) {
    const Outcome outcome =
        run(folder, "brdfplot eval m.json -q lambda,g1 -i in.csv --precision " + std::string(precision));
    CHECK(outcome.code == 4);
    CHECK(outcome.err == "brdfplot: error: in.csv:3: \"g1\": found inf, accepted: a finite number\n");
    CHECK(outcome.out == "theta_o,theta_i,lambda,g1\n0.5,0.1,0,1\n");
  }
  for (const char* integral : {"albedo", "weak_furnace", "visible_norm", "projected_area", "furnace", "mean_theta_i"}) {
    const Outcome outcome = run(folder, "brdfplot eval m.json -i in.csv -q " + std::string(integral));
    INFO(integral << " " << outcome.out << outcome.err);
    CHECK(outcome.code == 4);
    CHECK(outcome.out.find("nan") == std::string::npos);
    CHECK(outcome.out.find("inf") == std::string::npos);
  }
}

TEST_CASE("single precision: a value beyond float's range ends the stream with its row") {
  const Folder folder;
  folder.write("m.json", R"({"distribution": {"type": "ggx", "alpha": 0.5}, "shadowing": {"type": "none"}})");
  folder.write("in.csv", "x_o,y_o,z_o,x_i,y_i,z_i\n0,0,1,1,0,1\n0,0,1,1,0,1e-42\n");
  const std::string command = "brdfplot eval m.json -q brdf -i in.csv --precision ";
  CHECK(check_output(folder, command + "double").find("5.092958178940651e+40") != std::string::npos);
  const Outcome outcome = run(folder, command + "single");
  CHECK(outcome.code == 4);
  CHECK(outcome.err.find("in.csv:3: \"brdf\": found ") != std::string::npos);
  CHECK(outcome.out == "x_o,y_o,z_o,x_i,y_i,z_i,brdf\n0,0,1,1,0,1,0.21728936\n");
}

TEST_CASE("an accuracy out of reach names the row and the estimate reached") {
  const Folder folder;
  folder.write("in.csv", "theta_o\n0.1\n1.5\n");
  const Outcome outcome =
      run(folder, "brdfplot eval configs/materials/ggx.json -q g1,albedo -i in.csv -o out.csv --tolerance 1e-300");
  CHECK(outcome.code == 4);
  CHECK(outcome.err.starts_with("brdfplot: error: in.csv:2: albedo: reached an error estimate of "));
  CHECK(folder.list() == std::vector<std::string>{"in.csv"});
}

TEST_CASE("the mean and the peak of coloured light have a column for each channel") {
  const Folder folder;
  folder.write("m.json", R"({"distribution": {"type": "ggx", "alpha": 0.6},
                            "fresnel": {"type": "schlick", "f0": [1, 0.5, 0]}})");
  folder.write("in.csv", "theta_o\n1.1\n");
  const std::string out =
      check_output(folder, "brdfplot eval m.json -q mean_theta_i,peak_theta_i -i in.csv --tolerance 1e-6");
  CHECK(out.starts_with("theta_o,mean_theta_i_r,mean_theta_i_g,mean_theta_i_b,peak_theta_i_r,"));
}
