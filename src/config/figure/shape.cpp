#include "config/figure/count.hpp"
#include "config/figure/numbers.hpp"
#include "config/figure/profile.hpp"
#include "config/figure/sphere.hpp"
#include "config/shapes.hpp"
#include "figure/series/channel.hpp"
#include "figure/series/simulated.hpp"

namespace brdfplot::config {

namespace {

/// A number, another angle that it follows ("phi_o+180deg"), or a type.
ShapePtr setting() { return either({angle(), text()}); }

ShapePtr settings() {
  return map(
      setting(),
      "variables and their values: directions theta_o phi_o theta_i phi_i theta_m phi_m, half and "
      "difference angles theta_h phi_h theta_d phi_d instead of those of o and i, a, slope, "
      "stretch_x stretch_y shear_x shear_y, any number among the material's parameters, the type of "
      "its distribution, masking, shadowing or fresnel, the channel, or the strategy of sampling; theta and phi of "
      "o, i and m may follow each other: \"phi_o+180deg\", \"-theta_o\"");
}

ShapePtr axis() {
  return object({{"variable", text(), false, "what is swept"},
                 {"label", text(), false, "drawn; _ and ^ start sub- and superscripts"},
                 {"from", angle(), false, "lower end"},
                 {"to", angle(), false, "upper end"},
                 {"samples", whole_number(2, 100000), false, "evenly spaced points instead of adaptive ones"},
                 {"scale", choice({"linear", "log"}), false, "default linear"},
                 {"unit", choice({"none", "degrees", "radians"}), false,
                  "how ticks are written; values are radians all the same; default none"}});
}

ShapePtr for_each() {
  const ShapePtr one =
      object({{"variable", text(), true, "set to each of the values in turn"},
              {"values", array(setting(), 1, most_series), true, "values, or types of a model"},
              {"labels", array(text(), 1, most_series), false, "what {variable} becomes in labels and titles"}});
  return either({one, array(one, 1, 8)});
}

ShapePtr kind_of_panels() {
  std::vector<std::string> names;
  for (const plot::PanelKind& kind : plot::panel_kinds) names.emplace_back(kind.name);
  return choice(names);
}

ShapePtr channel() { return choice(plot::channel_names()); }

ShapePtr channel_or_each() {
  std::vector<std::string> names = plot::channel_names();
  names.emplace_back("rgb");
  return choice(std::move(names));
}

/// Where whole series stand.
Field channel_field(const std::string& of) {
  return {"channel", channel_or_each(), false,
          of + "; rgb: what is coloured is drawn thrice, each channel in its colour"};
}

ShapePtr material_or_name() { return either({material_shape(false), text()}); }

ShapePtr expression();

/// "NAME: what is told of it; ..." of every source.
template <class Told>
std::string of_each_source(const Told& told) {
  std::string out;
  for (const auto* source : plot::simulation_sources())
    out += (out.empty() ? "" : "; ") + source->name() + ": " + told(*source);
  return out;
}

std::string source_docs() {
  return of_each_source([](const plot::SimulationSource& source) { return source.doc(); });
}

std::string source_quantities() {
  return of_each_source([](const plot::SimulationSource& source) {
    std::string names;
    for (const std::string& name : source.quantities()) names += (names.empty() ? "" : ", ") + name;
    return names;
  });
}

ShapePtr simulate() {
  std::vector<std::string> sources;
  for (const auto* source : plot::simulation_sources()) sources.push_back(source->name());
  return named("simulate", [sources] {
    return object(
        {{"source", choice(sources), true, source_docs()},
         {"bounces", choice({"1", "2", "3", "4", "2+", "all"}), false, "of which bounces; default all"},
         {"facets", choice({"conductor", "dielectric", "diffuse"}), false,
          "smith_walk: what a facet does with light; dielectric: what is not reflected is refracted; diffuse, "
          "the default where the material has such facets; else conductor"},
         {"paths", whole_number(1, 1000000000), false, "how many at each point; default 100000"},
         {"seed", whole_number(0, 2147483647), false, "of the random numbers; default 1"},
         {"realisations", whole_number(2, 10000), false,
          "surface: independent surfaces that share the paths; default 8"},
         {"cells", whole_number(64, 8192), false, "surface: along each side; default 512"},
         {"half_width", angle(), false,
          "surface, brdf_cos: directions so far from the plane of incidence count as in it; default 5°"},
         {"samples", whole_number(2, 10000), false, "points along x; default 61"}});
  });
}

std::vector<Field> expression_fields() {
  return {{"quantity", text(), false, "what is evaluated: see brdfplot list quantities"},
          {"simulate", simulate(), false, "the quantity is simulated, with its standard error; " + source_quantities()},
          {"ratio", array(expression(), 2, 2), false, "first over second"},
          {"difference", array(expression(), 2, 2), false, "first minus second"},
          {"absolute", expression(), false, "absolute value"},
          {"material", material_or_name(), false, "a material, or the name of one in \"materials\""},
          {"channel", channel(), false,
           "of what is coloured; luminance: 0.2126 r + 0.7152 g + 0.0722 b (Rec. 709) of linear values"},
          {"at", settings(), false, "what is fixed"}};
}

const std::vector<std::vector<std::string>> operations = {{"quantity"}, {"ratio"}, {"difference"}, {"absolute"}};

ShapePtr expression() {
  return named("expression", [] { return object_with_alternatives(expression_fields(), operations); });
}

ShapePtr series() {
  auto fields = expression_fields();
  std::erase_if(fields, [](const Field& field) { return field.key == "channel"; });
  fields.push_back(channel_field("of what is coloured"));
  fields.push_back(
      {"label", text(), false,
       "in the legend; {variable} stands for the value of for_each; default: what differs between series"});
  fields.push_back({"for_each", for_each(), false, "one series for each value"});
  return named("series", [fields] { return object_with_alternatives(fields, operations); });
}

ShapePtr panel() {
  return named("panel", [] {
    return object_with_alternatives(
        {{"title", text(), false, "above the panel"},
         {"kind", kind_of_panels(), false, "where it is not the figure's"},
         {"drawn", boolean(), false,
          "false: lines or polar panels that are in the CSV, for the caption's numbers, and not in the drawing"},
         {"x", axis(), false, "replaces keys of the figure's x"},
         {"y", axis(), false, "replaces keys of the figure's y"},
         {"value", axis(), false, "replaces keys of the figure's value"},
         {"material", material_or_name(), false, "of the series that name none"},
         channel_field("of the series that name none"),
         {"at", settings(), false, "what is fixed for all series; what is swept is not"},
         {"series", array(series(), 1, most_series), false, "what is drawn"},
         {"profile", profile_shape(), false, "profile: what is drawn; replaces keys of the figure's profile"},
         {"sphere", sphere_shape(), false, "spheres: a sphere of the material; replaces keys of the figure's sphere"},
         {"autocorrelation", autocorrelation_shape(), false,
          "lines: the correlation of a surface's heights with those at a distance, over that in facets; x has "
          "\"variable\": \"distance\""},
         {"compare_to", expression(), false,
          "polar: a lobe simulated by \"surface\", with which that of the first series is compared in numbers"},
         {"arrows", array(choice({"omega_o", "omega_i", "mirror"}), 1, 3), false,
          "polar: directions to draw; mirror is the mirror direction of omega_o"},
         {"contours",
          array(object({{"label", text(), true, "in the legend"}, {"level", number(), true, "value"}}), 1, 100), false,
          "heat map: lines of a level"},
         {"for_each", for_each(), false, "one panel for each value"}},
        {{"series"}, {"profile"}, {"sphere"}, {"autocorrelation"}});
  });
}

} // namespace

ShapePtr figure_shape() {
  return object(
      {{"id", file_stem(), true, "name of its files"},
       {"kind", kind_of_panels(), true, "how panels are drawn that name no kind"},
       {"title", text(), true, "above the figure"},
       {"caption", text(), true, "what it shows, with equation and parameters; {name} stands for one of its numbers"},
       {"numbers", numbers_shape(), false, "numbers of the caption"},
       {"columns", whole_number(1, 8), false, "panels stand in rows of so many; default 1"},
       {"share", choice({"none", "rows", "all"}), false, "which panels share the range of values; default none"},
       {"tolerance", number({.min = 1e-13, .max = 1e-2}), false, "absolute, of integrals; default 1e-7"},
       {"cells", whole_number(2, 1024), false, "heat map: cells along each axis; default 96"},
       {"materials", map(material_shape(false), "materials by name"), false, "materials that series name"},
       {"material", material_or_name(), false, "of the series that name none"},
       channel_field("of the series that name none"),
       {"at", settings(), false, "what is fixed for all series"},
       {"x", axis(), false, "horizontal axis, or angle"},
       {"y", axis(), false, "vertical axis, or radius; heat map: the second swept variable"},
       {"value", axis(), false, "heat map: the colour bar"},
       {"profile", profile_shape(), false, "what all profiles have in common"},
       {"sphere", sphere_shape(), false, "what all spheres have in common"},
       {"panels", array(panel(), 1, most_panels), true, "one or more"}},
      true);
}

} // namespace brdfplot::config
