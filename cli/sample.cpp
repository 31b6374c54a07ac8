/// \file
/// brdfplot sample: directions of the light as a renderer draws them.

#include "command.hpp"
#include "config/load.hpp"
#include "stream/sample_stream.hpp"
#include "whole_number.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace brdfplot::cli {

namespace {

struct SampleFlags {
  std::string material;
  std::string input = "-";
  std::string output = "-";
  std::string strategy = "default";
  std::string count = "1";
  std::string seed = "1";
  std::string points = "random";
};

int run(const SampleFlags& flags, const Settings& settings) {
  require_argument(!flags.material.empty(), "sample", "MATERIAL.json");
  const SampleOptions options{read_whole(flags.count, 1, std::uint64_t{1} << 48, "-n"),
                              read_whole(flags.seed, 0, ~std::uint64_t{0}, "--seed"),
                              point_kind(flags.points, "--points"), settings.threads};
  Material material = build(config::material_of_argument(flags.material));
  material.name = config::name_of_argument(flags.material); // errors name the material by its file
  const Sampler sampler(material, flags.strategy);
  InputFile in(flags.input);
  OutputFile out(flags.output);
  sample_stream(material, sampler, options, in, out);
  out.commit();
  return 0;
}

} // namespace

Command add_sample(CLI::App& app, const Settings& settings) {
  const auto flags = std::make_shared<SampleFlags>();
  CLI::App* command = app.add_subcommand("sample", "Directions of the light, drawn as a renderer draws them");
  set_usage(*command, {"MATERIAL.json"});
  add_material(*command, flags->material, "The material");
  command->add_option("-i,--input", flags->input, "Viewers: columns theta_o phi_o, or x_o y_o z_o; default: stdin")
      ->type_name("FILE|-");
  command
      ->add_option(
          "-o,--output", flags->output,
          "For every viewer N rows: every input column, then x_i,y_i,z_i, pdf (1/sr, over the whole sphere) and "
          "weight = brdf_cos / pdf, of each channel; 0 below the horizon; default: stdout")
      ->type_name("FILE|-");
  command
      ->add_option(
          "--strategy", flags->strategy,
          "cosine; half_vector: normals by D cos theta; visible_normals: by <o,m> D / sigma; heitz_2018: the same of "
          "GGX by another map; kelemen: half_vector, and complement by what it takes; eon: of the term eon; default: "
          "visible_normals for mirrors with a Lambda, half_vector for others, cosine for what is diffuse, and of "
          "several terms one by chance")
      ->type_name("NAME");
  command->add_option("-n,--samples", flags->count, "Samples of every viewer; default: 1")->type_name("N");
  command->add_option("--seed", flags->seed, "Chooses the points; default: 1")->type_name("S");
  command
      ->add_option("--points", flags->points,
                   "random; sobol: evenly spread, of every row with a random shift of its digits; default: random")
      ->type_name("random|sobol");
  command->footer(footer("brdfplot sample configs/materials/ggx.json -i configs/points/theta_o.csv -n 2"));
  return {command, [flags, &settings] { return run(*flags, settings); }};
}

} // namespace brdfplot::cli
