#include "cli/program.hpp"

using namespace test;

namespace {

const std::string paint = "configs/materials/clear_coated_paint.json";

/// What the file says of one term, as a material by itself.
const char* coat = R"({"terms": [{"name": "coat", "type": "mirror", "distribution": {"type": "ggx", "alpha": 0.03},
  "fresnel": {"type": "dielectric", "eta": 1.5}}]})";

} // namespace

TEST_CASE("terms: eval gives quantities of the sum, and of a term by its name") {
  const Folder folder;
  folder.write("in.csv", "theta_o,theta_i\n60deg,-50deg\n");
  folder.write("coat.json", coat);
  const auto sum =
      cells(check_output(folder, "brdfplot eval " + paint + " -q coat.brdf,coat.g1,brdf,albedo -i in.csv"));
  CHECK(sum[0] == std::vector<std::string>{"theta_o", "theta_i", "coat.brdf", "coat.g1", "brdf_r", "brdf_g", "brdf_b",
                                           "albedo_r", "albedo_g", "albedo_b"});
  const auto alone = cells(check_output(folder, "brdfplot eval coat.json -q brdf,g1 -i in.csv"));
  CHECK(sum[1][2] == alone[1][2]);
  CHECK(sum[1][3] == alone[1][3]);
  check_error(folder, "brdfplot eval " + paint + " -q g1 -i in.csv", 2,
              {paint + ": several terms have a microsurface", "coat, flakes"});
  check_error(folder, "brdfplot eval " + paint + " -q coatt.brdf -i in.csv", 2, {"\"coatt\"; did you mean \"coat\"?"});
  check_error(folder, "brdfplot eval " + paint + " -q coat.brdff -i in.csv", 2, {"coat.brdff"});
}

TEST_CASE("terms: check tells of each microsurface by itself") {
  const Folder folder;
  const std::string text = check_output(folder, "brdfplot check " + paint);
  CHECK(text.find("  - physically based") != std::string::npos);
  CHECK(text.find("\nclear-coated paint, coat: ggx (alpha 0.03), masking smith\n") != std::string::npos);
  CHECK(text.find("\nclear-coated paint, flakes: beckmann (alpha 0.35), masking smith\n") != std::string::npos);
  CHECK(text.find("  ✗ energy <= 1         0.2") != std::string::npos);
}

TEST_CASE("terms: a figure draws the sum and its terms, and sets a parameter of one") {
  const Folder folder;
  folder.write("f.json", R"({"id": "f", "kind": "lines", "title": "T", "caption": "C",
    "material": {"$ref": "configs/materials/clear_coated_paint.json"}, "channel": "r", "at": {"theta_o": "50deg"},
    "x": {"variable": "theta_i", "from": "-80deg", "to": "80deg"}, "panels": [{"series": [
      {"quantity": "brdf_cos", "label": "all"}, {"quantity": "coat.brdf_cos", "label": "coat"},
      {"quantity": "coat.d", "at": {"coat.alpha": 0.2}, "label": "rough"}]}]})");
  check_output(folder, "brdfplot plot f.json -o . --quiet");
  CHECK(folder.read("f.csv").find(",rough,") != std::string::npos);
  folder.write("g.json", R"({"id": "g", "kind": "lines", "title": "T", "caption": "C",
    "material": {"$ref": "configs/materials/clear_coated_paint.json"}, "channel": "r", "at": {"theta_o": "50deg"},
    "x": {"variable": "alpha", "from": 0.1, "to": 0.2}, "panels": [{"series": [{"quantity": "albedo"}]}]})");
  check_error(folder, "brdfplot plot g.json -o .", 2, {"g.json: /x: unknown variable \"alpha\"", "coat.alpha"});
}

TEST_CASE("terms: a term of another one takes it by name or written within, and its parameters are swept") {
  const Folder folder;
  folder.write("in.csv", "theta_o,theta_i\n60deg,-50deg\n20deg,80deg\n");
  const std::string specular = R"({"name": "specular", "type": "kelemen",
      "distribution": {"type": "ggx", "alpha": 0.4}})";
  const auto material = [&](const std::string& of) {
    return "{\"terms\": [" + specular + ", {\"type\": \"complement\", \"of\": " + of + ", \"color\": [1, 0.5, 0]}]}";
  };
  folder.write("name.json", material("\"specular\""));
  folder.write("within.json", material(specular));
  const std::string asked = " -q brdf,complement.albedo -i in.csv";
  CHECK(check_output(folder, "brdfplot eval name.json" + asked) ==
        check_output(folder, "brdfplot eval within.json" + asked));
  folder.write("typo.json", material("\"specullar\""));
  check_error(folder, "brdfplot eval typo.json" + asked, 2,
              {"typo.json: /terms/1/of: unknown term \"specullar\"; did you mean \"specular\"?"});
  folder.write("masked.json", R"({"terms": [{"type": "kelemen", "distribution": {"type": "ggx", "alpha": 0.4},
      "masking": {"type": "smith"}}]})");
  check_error(folder, "brdfplot eval masked.json -q brdf -i in.csv", 2, {"masked.json: /terms/0/masking"});
  check_error(folder, "brdfplot eval name.json -q g1 -i in.csv", 2, {"none of its terms has a microsurface"});
  folder.write("f.json", R"({"id": "f", "kind": "lines", "title": "T", "caption": "C", "channel": "r",
    "material": {"$ref": "within.json"}, "at": {"theta_o": "50deg"},
    "x": {"variable": "complement.of.alpha", "from": 0.2, "to": 0.9, "samples": 3},
    "panels": [{"series": [{"quantity": "complement.albedo"}]}]})");
  check_output(folder, "brdfplot plot f.json -o . --quiet");
  const auto rows = cells(folder.read("f.csv"));
  REQUIRE(rows.size() >= 3);
  CHECK(std::stod(rows.back()[3]) > std::stod(rows[1][3])); // rougher facets leave more
}

TEST_CASE("terms: stretching reaches a term of another by its name, not within it") {
  const Folder folder;
  const std::string mirror = R"({"name": "m", "type": "mirror", "distribution": {"type": "ggx", "alpha": 0.4}})";
  const auto plot = [&](const std::string& of) {
    folder.write("f.json", R"({"id": "f", "kind": "lines", "title": "T", "caption": "C",
      "material": {"terms": [)" +
                               mirror + R"(, {"type": "complement", "of": )" + of + R"(}]},
      "at": {"theta_o": "50deg", "theta_i": "10deg"}, "x": {"variable": "stretch_x", "from": 0.8, "to": 1, "samples": 2},
      "panels": [{"series": [{"quantity": "m.brdf"}]}]})");
    return "brdfplot plot f.json -o . --quiet";
  };
  check_output(folder, plot("\"m\""));
  check_error(folder, plot(mirror), 2, {"do not reach the term within \"complement\""});
}

TEST_CASE("terms: cloth is made of terms without a microsurface") {
  const Folder folder;
  folder.write("in.csv", "theta_o,theta_i\n60deg,-50deg\n");
  const auto sum = cells(
      check_output(folder, "brdfplot eval configs/materials/cloth.json -q brdf,velvet.brdf,sheen.brdf -i in.csv"));
  REQUIRE(sum[1].size() == 11);
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(std::stod(sum[1][2 + c]) == doctest::Approx(std::stod(sum[1][5 + c]) + std::stod(sum[1][8 + c])));
  check_error(folder, "brdfplot eval configs/materials/cloth.json -q velvet.d -i in.csv", 2,
              {"none of its terms has a microsurface"});
  CHECK(check_output(folder, "brdfplot list terms").find("velvet_cloth") != std::string::npos);
}

TEST_CASE("terms: a coated term is its coat and its base, by name, and errors name their place") {
  const Folder folder;
  folder.write("in.csv", "theta_o,theta_i\n60deg,-50deg\n");
  const std::string coat_of = R"({"type": "mirror", "distribution": {"type": "ggx", "alpha": 0.03},
    "fresnel": {"type": "dielectric", "eta": 1.5}})";
  const auto material = [&](const std::string& rest) {
    return R"({"terms": [{"name": "paint", "type": "coated", "coat": )" + coat_of + R"(, "base": [{"name": "flakes",
      "type": "mirror", "distribution": {"type": "beckmann", "alpha": 0.35}}, {"type": "lambert"}])" +
           rest + "}]}";
  };
  folder.write("m.json", material(""));
  const auto all =
      cells(check_output(folder, "brdfplot eval m.json -q brdf,paint.brdf,coat.brdf,flakes.brdf,lambert.brdf,"
                                 "coat.g1,paint.albedo -i in.csv"));
  CHECK(all[1][2] == all[1][3]);
  CHECK(std::stod(all[1][2]) == doctest::Approx(std::stod(all[1][4]) + std::stod(all[1][5]) + std::stod(all[1][6])));
  CHECK(std::stod(all[1][6]) < 0.3); // less than 1 / pi
  folder.write("tint.json", material(R"(, "tint": [0.5, 0.5, 2])"));
  check_error(folder, "brdfplot eval tint.json -q brdf -i in.csv", 2, {"tint.json: /terms/0/tint/2: found 2"});
  folder.write("attenuation.json", material(R"(, "attenuation": "full")"));
  check_error(folder, "brdfplot eval attenuation.json -q brdf -i in.csv", 2,
              {"/terms/0/attenuation", "\"full\"", "half_vector"});
  folder.write("deep.json", R"({"terms": [{"type": "coated", "coat": )" + coat_of +
                                R"(, "base": [{"type": "mirror", "distribution": {"type": "ggx", "alpha_x": 0.1,
      "alpha_y": 0.1, "correlation": 2}}]}]})");
  check_error(folder, "brdfplot eval deep.json -q brdf -i in.csv", 2, {"/terms/0/base/0/distribution/correlation"});
  folder.write("f.json", R"({"id": "f", "kind": "lines", "title": "T", "caption": "C",
    "material": {"$ref": "m.json"}, "at": {"theta_o": "50deg"}, "x": {"variable": "paint.weight", "from": 0, "to": 1,
    "samples": 3}, "panels": [{"series": [{"quantity": "albedo"}, {"quantity": "paint.albedo"}]}]})");
  check_output(folder, "brdfplot plot f.json -o . --quiet");
}
