#include "check_sampling.hpp"

#include "analysis/sampling_check.hpp"
#include "analysis/written_density.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/parallel.hpp"
#include "command.hpp"
#include "config/load.hpp"
#include "report_tables.hpp"
#include "terminal.hpp"
#include "whole_number.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

namespace brdfplot::cli {

namespace {

/// Fewer say nothing of a hundred cells.
constexpr std::uint64_t fewest = 1000, most = 100000000;
constexpr double degree = std::numbers::pi / 180;

struct Row {
  const Material* material;
  const Sampler* sampler;
  double theta_o, phi_o;
  SamplingFindings found;
};

/// From the normal to grazing; where the azimuth matters, at two.
std::vector<Row> viewers_of(const Material& material, const Sampler& sampler) {
  const bool isotropic = std::ranges::all_of(material.terms, [](const auto& term) { return term.is_isotropic(); });
  std::vector<Row> rows;
  for (const double theta : {0.0, 30.0, 60.0, 85.0, 89.9})
    for (const double phi : {20.0, 110.0}) {
      if (phi > 20 && (isotropic || theta == 0)) continue;
      if (material.mesosurface().project(from_angles(theta * degree, phi * degree)).c > 0)
        rows.push_back({&material, &sampler, theta, phi, {}});
    }
  return rows;
}

std::string as_csv(const std::vector<Row>& rows) {
  std::string out = "material,theta_o,phi_o,integral,integral_error,chi_squared,cells,p_value,mean_weight,"
                    "standard_error,albedo,errors_apart,largest_weight,untold,uncovered,mean_square,expected_square,"
                    "squares_apart\n";
  for (const Row& row : rows) {
    const SamplingFindings& f = row.found;
    out += row.material->name;
    for (const double value :
         {row.theta_o * degree, row.phi_o * degree, f.integral.value, f.integral.error, f.chi_squared,
          static_cast<double>(f.cells), f.p_value, f.mean_weight, f.standard_error, f.albedo, f.errors_apart,
          f.largest_weight, static_cast<double>(f.untold), static_cast<double>(f.uncovered), f.mean_square,
          f.expected_square.value, f.squares_apart})
      out += "," + format_number(value);
    out += "\n";
  }
  return out;
}

/// The columns of the table are as wide as this.
constexpr std::size_t cell_width = 11;

std::string as_table(const std::vector<Row>& rows, const SamplingTest& test) {
  std::string out;
  const Material* last = nullptr;
  const auto cell = [](const std::string& text) {
    return text + std::string(cell_width - std::min(cell_width - 1, text.size()), ' ');
  };
  for (const Row& row : rows) {
    if (row.material != last) {
      out += (last == nullptr ? "" : "\n") + row.material->name + "\n    ";
      for (const char* head :
           {"theta_o", "phi_o", "integral-1", "p_value", "weight", "albedo", "errors", "squares", "largest"})
        out += cell(head);
      out.erase(out.find_last_not_of(' ') + 1);
      out += "\n";
      last = row.material;
    }
    const SamplingFindings& f = row.found;
    out += f.holds(test) ? "  ✓ " : "  ✗ ";
    for (const std::string& text :
         {format_number(row.theta_o) + "deg", format_number(row.phi_o) + "deg", short_number(f.integral.value - 1),
          short_number(f.p_value), short_number(f.mean_weight), short_number(f.albedo), short_number(f.errors_apart),
          short_number(f.squares_apart), short_number(f.largest_weight)})
      out += cell(text);
    out.erase(out.find_last_not_of(' ') + 1);
    out += "\n";
  }
  return out + "\nintegral: of the density over the sphere; p_value: of a chi-square test of " +
         std::to_string(test.samples) + " samples, at least " + short_number(test.significance) +
         " where it holds;\nweight: mean of brdf_cos / pdf, of the channel furthest from its albedo, in standard "
         "errors;\nsquares: the same of the mean square of the first channel against its quadrature; largest: weight "
         "of "
         "samples, and of\ndirections where the BRDF is large.\n";
}

/// Says what does not hold.
int judge(const std::vector<Row>& rows, const SamplingTest& test, const Settings& settings) {
  int code = 0;
  for (const Row& row : rows)
    for (const std::string& fault : row.found.faults(test)) {
      code = 1;
      print_error(settings, row.material->name + ": theta_o = " + format_number(row.theta_o) +
                                "deg, phi_o = " + format_number(row.phi_o) + "deg: " + fault);
    }
  return code;
}

} // namespace

int check_samplers(const std::vector<std::string>& files, const SamplingCheckFlags& flags, bool csv,
                   const std::string& output, const Settings& settings) {
  if (files.empty()) throw InputError("check", "found no material with --sampling; accepted: MATERIAL.json");
  SamplingTest test;
  if (!flags.samples.empty()) test.samples = read_whole(flags.samples, fewest, most, "-n");
  if (!flags.seed.empty()) test.seed = read_whole(flags.seed, 0, ~std::uint64_t{0}, "--seed");
  std::deque<Material> materials; // what is referred to stays where it is
  std::deque<Sampler> samplers;
  std::vector<Row> rows;
  for (const std::string& file : files) {
    materials.push_back(build(config::material_of_argument(file)));
    materials.back().name = config::name_of_argument(file);
    samplers.emplace_back(materials.back(), flags.strategy.empty() ? "default" : flags.strategy);
    for (const Row& row : viewers_of(materials.back(), samplers.back())) rows.push_back(row);
  }
  test.significance = sidak(test.significance, rows.size());
  if (!flags.density.empty()) WrittenDensity(samplers.front(), flags.density, "--pdf"); // a formula that is wrong
  parallel_for(rows.size(), settings.threads, [&](std::size_t k) {
    Row& row = rows[k];
    SamplingTest own = test; // with samples of its own
    own.seed += k;
    const PairDensity density =
        flags.density.empty() ? density_of(*row.sampler) : WrittenDensity(*row.sampler, flags.density, "--pdf");
    row.found = check_sampling(*row.material, *row.sampler, from_angles(row.theta_o * degree, row.phi_o * degree), own,
                               density);
  });
  write_output(output, csv ? as_csv(rows) : as_table(rows, test));
  return judge(rows, test, settings);
}

} // namespace brdfplot::cli
