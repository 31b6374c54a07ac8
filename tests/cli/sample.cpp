#include "cli/program.hpp"

#include <cmath>

using namespace test;

namespace {

const std::string sample = "brdfplot sample configs/materials/rough_gold.json ";

} // namespace

TEST_CASE("every viewer has n rows: its own, a direction, its density and its weight") {
  const Folder folder;
  folder.write("in.csv", "name,theta_o,phi_o\n\"a, b\",0.3,1\n\nc,80deg,0\r\nd,2,0\n");
  const std::string out = check_output(folder, sample + "-i in.csv -n 3");
  CHECK(out.starts_with("name,theta_o,phi_o,x_i,y_i,z_i,pdf,weight_r,weight_g,weight_b\n\"a, b\",0.3,1,"));
  CHECK(std::ranges::count(out, '\n') == 10);
  CHECK(out.find("\nc,80deg,0,") != std::string::npos);
  const auto below = cells(out).back(); // from below the surface nothing is drawn
  REQUIRE(below.size() == 10);
  for (std::size_t k = 6; k < 10; ++k) CHECK(below[k] == "0");
}

TEST_CASE("what is drawn can be read again, and pdf is the one that it was drawn by") {
  const Folder folder;
  folder.write("in.csv", "theta_o\n0.3\n80deg\n");
  for (const std::string strategy : {"cosine", "half_vector", "visible_normals"}) {
    const std::string drawn = check_output(folder, sample + "-i in.csv -n 20 --strategy " + strategy);
    folder.write("drawn.csv", "theta_o,x_i,y_i,z_i,drawn" + drawn.substr(drawn.find(",weight_r")));
    const auto rows =
        cells(check_output(folder, "brdfplot eval configs/materials/rough_gold.json -q pdf,brdf_cos -i drawn.csv "
                                   "--strategy " +
                                       strategy));
    REQUIRE(rows.size() == 41);
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const double before = std::stod(rows[k][4]), weight = std::stod(rows[k][5]), pdf = std::stod(rows[k][8]);
      CHECK(std::fabs(pdf / before - 1) < 1e-9);
      CHECK(std::fabs(weight * pdf - std::stod(rows[k][9])) <= 1e-9 * std::stod(rows[k][9]));
    }
  }
}

TEST_CASE("neither threads nor the way in change a byte of what is drawn; a seed does") {
  const Folder folder;
  std::string viewers = "theta_o,phi_o\n";
  for (int k = 0; k < 3000; ++k) viewers += std::to_string(k * 0.0005) + "," + std::to_string(k * 0.002) + "\n";
  folder.write("in.csv", viewers);
  for (const std::string points : {"random", "sobol"}) {
    const std::string command = sample + "-i in.csv -n 7 --points " + points;
    const std::string one = check_output(folder, command + " --threads 1");
    CHECK(std::ranges::count(one, '\n') == 21001);
    CHECK(check_output(folder, command + " --threads 3") == one);
    CHECK(check_output(folder, "cat in.csv | " + sample + "-n 7 --points " + points) == one);
    CHECK(check_output(folder, command + " --seed 2") != one);
  }
}

TEST_CASE("memory grows neither with samples nor with rows") {
  if (sanitized) return;
  const Folder folder;
  folder.write("one.csv", "theta_o\n0.3\n");
  const Outcome few =
      run(folder, "exec brdfplot sample configs/materials/ggx.json -i one.csv -n 1000 --threads 2 -o out.csv");
  const Outcome many =
      run(folder, "exec brdfplot sample configs/materials/ggx.json -i one.csv -n 1000000 --threads 2 -o out.csv");
  CHECK(few.code == 0);
  CHECK(many.code == 0);
  CHECK(many.kilobytes < few.kilobytes + 40000);
}

TEST_CASE("errors of sample name the place, the value and what is accepted") {
  const Folder folder;
  folder.write("in.csv", "theta_o\n0.3\nx\n");
  check_error(folder, sample + "-i in.csv --strategy halfvector", 2, {"--strategy: ", "did you mean \"half_vector\"?"});
  check_error(folder, "brdfplot sample configs/materials/plastic.json -i in.csv --strategy visible_normals", 2,
              {"plastic.json: the term ", "\": cosine"});
  check_error(folder, sample + "-i in.csv -n 0", 2, {"-n: found \"0\", accepted: a whole number in [1, "});
  check_error(folder, sample + "-i in.csv --seed -1", 2, {"--seed: found \"-1\""});
  check_error(folder, sample + "-i in.csv --points halton", 2, {"--points: ", "accepted: random, sobol"});
  check_error(folder, "brdfplot sample", 2, {"MATERIAL.json"});
  folder.write("drawn.csv", "theta_o,theta_i\n0.3,0.2\n");
  check_error(folder, sample + "-i drawn.csv", 2, {"drawn.csv:1: found columns of omega_i"});
  folder.write("pdf.csv", "theta_o,pdf\n0.3,0.2\n");
  check_error(folder, sample + "-i pdf.csv", 2, {"pdf.csv:1: column \"pdf\" is there already"});
  folder.write("other.csv", "theta_m\n0.3\n");
  check_error(folder, sample + "-i other.csv", 2, {"other.csv:1: found no omega_o"});
  // Rows before a wrong one are written, as by eval.
  const Outcome wrong = run(folder, sample + "-i in.csv -n 2");
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("in.csv:3: ") != std::string::npos);
  CHECK(std::ranges::count(wrong.out, '\n') == 3);
}

TEST_CASE("pdf of eval: in double precision, of all terms, with a strategy that is there") {
  const Folder folder;
  folder.write("in.csv", "theta_o,theta_i\n0.3,0.2\n");
  const std::string eval = "brdfplot eval configs/materials/plastic.json -i in.csv -q ";
  check_error(folder, eval + "pdf --precision single", 2,
              {"--precision: found \"single\" with \"pdf\"; accepted: double"});
  check_error(folder, eval + "coat.pdf", 2, {"-q: found \"coat.pdf\", accepted: pdf"});
  check_error(folder, eval + "brdf --strategy cosine", 2,
              {"--strategy: found \"cosine\" without the quantity \"pdf\""});
  check_error(folder, eval + "pdf --strategy half_vector", 2, {"has no strategy \"half_vector\""});
  const auto cosine = cells(check_output(folder, eval + "pdf --strategy cosine"));
  CHECK(std::fabs(std::stod(cosine[1][2]) - std::cos(0.2) / std::acos(-1.0)) < 1e-15);
  folder.write("one.csv", "theta_o\n0.3\n");
  check_error(folder, "brdfplot eval configs/materials/plastic.json -i one.csv -q pdf", 2, {"one.csv:1: "});
  CHECK(check_output(folder, "brdfplot list quantities").find("\n  pdf ") != std::string::npos);
}

TEST_CASE("check --sampling: what is drawn follows its density, in a table and as CSV") {
  const Folder folder;
  const std::string check =
      "brdfplot check --sampling -n 2000 configs/materials/plastic.json configs/materials/ggx.json ";
  const std::string table = check_output(folder, check);
  CHECK(table.find("configs/materials/ggx.json\n") != std::string::npos);
  CHECK(table.find("  ✓ 89.9deg") != std::string::npos);
  CHECK(table.find("✗") == std::string::npos);
  const std::string text = check_output(folder, check + "--csv --threads 3");
  const auto csv = cells(text);
  CHECK(csv.size() == 11);
  for (std::size_t k = 1; k < csv.size(); ++k) CHECK(std::fabs(std::stod(csv[k][3]) - 1) < 1e-6);
  CHECK(check_output(folder, check + "--csv --threads 1") == text);
  check_error(folder, "brdfplot check --sampling", 2, {"MATERIAL.json"});
  check_error(folder, "brdfplot check --strategy cosine configs/materials/ggx.json", 2, {"without --sampling"});
  check_error(folder, check + "--json", 2, {"--json"});
  // Peaks that the cosine misses: the mean weight is not the albedo.
  folder.write("sharp.json", R"({"distribution": {"type": "ggx", "alpha": 1e-5}})");
  const Outcome missed = run(folder, "brdfplot check --sampling --strategy cosine -n 1000 sharp.json");
  CHECK(missed.code == 1);
  CHECK(missed.out.find("✗") != std::string::npos);
  CHECK(missed.err.find("brdfplot: error: sharp.json: theta_o = 0deg, phi_o = 20deg: the mean weight is ") !=
        std::string::npos);
}

TEST_CASE("check --sampling --pdf: a density that is written is held to what is drawn") {
  const Folder folder;
  folder.write("beckmann.json", R"({"distribution": {"type": "beckmann", "alpha": 0.4}})");
  folder.write("ggx.json", R"({"distribution": {"type": "ggx", "alpha_x": 0.2, "alpha_y": 0.8}})");
  const std::string check = "brdfplot check --sampling -n 5000 --strategy visible_normals ";
  check_output(folder, check + "beckmann.json --pdf pdf");
  // Normalised as Heitz and d'Eon do, by C = 1 + erf(cot) + alpha tan exp(-cot^2) / sqrt(pi); cot in units of alpha.
  const std::string density = "exp(-tan(theta_h)^2/0.16)/(pi*0.16*cos(theta_h)^4)";
  const auto normalised = [&](const std::string& exponent) {
    return density + "/(2*((1+erf(z_o/(0.4*sin(theta_o))))*z_o + 0.4*sin(theta_o)*exp(-" + exponent +
           ")/sqrt(pi)))*(z_h>0)";
  };
  check_output(folder, check + "beckmann.json --pdf '" + normalised("(z_o/(0.4*sin(theta_o)))^2") + "'");
  const Outcome wrong = run(folder, check + "beckmann.json --pdf '" + normalised("z_o^2") + "'");
  CHECK(wrong.code == 1);
  CHECK(wrong.err.find("the density integrates to ") != std::string::npos);
  const std::string ggx = "1/(pi*0.16*((x_h/0.2)^2+(y_h/0.8)^2+z_h^2)^2)*(z_h>0)/(2*(z_o+sqrt(z_o^2+";
  check_output(folder, check + "ggx.json --pdf '" + ggx + "(0.2*x_o)^2+(0.8*y_o)^2)))'");
  const Outcome product = run(folder, check + "ggx.json --pdf '" + ggx + "0.16*(x_o^2+y_o^2))))'");
  CHECK(product.code == 1);
  check_error(folder, check + "ggx.json --pdf 'pdff'", 2, {"--pdf: formula \"pdff\": ", "did you mean \"pdf\"?"});
  check_error(folder, "brdfplot check ggx.json --pdf pdf", 2, {"without --sampling"});
}
