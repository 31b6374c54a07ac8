#include "stream/stream.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

using namespace brdfplot;

namespace {

Material ggx() {
  TermDescription description;
  description.name = "GGX";
  description.distribution.type = "ggx";
  description.distribution.values.set("alpha", 0.4);
  return build(description);
}

/// What evaluate_stream makes of a text, through files.
std::string stream(const std::string& text, const std::vector<std::string>& names, int threads) {
  std::string folder = (std::filesystem::temp_directory_path() / "brdfplot-stream-XXXXXX").string();
  REQUIRE(mkdtemp(folder.data()) != nullptr);
  write_text_file(folder + "/in.csv", text);
  {
    InputFile in(folder + "/in.csv");
    OutputFile out(folder + "/out.csv");
    evaluate_stream(ggx(), {select_quantities(names, "here"), 1e-9, threads}, in, out);
    out.commit();
  }
  std::string result = read_text_file(folder + "/out.csv");
  std::filesystem::remove_all(folder);
  return result;
}

} // namespace

TEST_CASE("a stream has the values of the library, to the last bit") {
  const Material material = ggx();
  std::string text = "theta_o,theta_i,phi_i\n";
  std::string expected = "theta_o,theta_i,phi_i,brdf,lambda\n";
  for (int k = 0; k < 3000; ++k) {
    const double theta_o = 0.0005 * k;
    const double theta_i = 1.5 - 0.0005 * k;
    const double phi_i = 0.001 * k;
    const std::string row = format_number(theta_o) + "," + format_number(theta_i) + "," + format_number(phi_i);
    const Direction o = from_angles(theta_o, 0);
    const Direction i = from_angles(theta_i, phi_i);
    text += row + "\n";
    expected += row + "," + format_number(evaluate(material, Quantity::brdf, o, i, std::nullopt)) + "," +
                format_number(evaluate(material, Quantity::lambda, o, std::nullopt, std::nullopt)) + "\n";
  }
  CHECK(stream(text, {"brdf", "lambda"}, 1) == expected);
  CHECK(stream(text, {"brdf", "lambda"}, 5) == expected);
}

TEST_CASE("integrals of a stream") {
  const double albedo = compute(Integral::albedo, ggx(), from_angles(0.7, 0)).value;
  CHECK(stream("theta_o\n0.7\n0.7\n", {"albedo"}, 2) ==
        "theta_o,albedo\n0.7," + format_number(albedo) + "\n0.7," + format_number(albedo) + "\n");
}

TEST_CASE("quantities by name") {
  CHECK(select_quantities({"brdf", "albedo"}, "-q").size() == 2);
  CHECK_THROWS_AS(select_quantities({"brdf", "brdf"}, "-q"), InputError);
  CHECK_THROWS_AS(select_quantities({"brd"}, "-q"), InputError);
  for (const auto& info : quantities()) CHECK(select_quantities({info.name}, "-q").size() == 1);
  for (const auto& info : integrals()) CHECK(select_quantities({info.name}, "-q").size() == 1);
}
