#include "config/figure/profile.hpp"

#include "config/model_json.hpp"
#include "figure/profile/autocorrelation.hpp"
#include "figure/profile/panel.hpp"

namespace brdfplot::config {

namespace {

Field surface_field(bool required, const std::string& doc) {
  return {"surface", named("profile_surface", [] { return model(specs_of<plot::ProfileSurface>()); }), required, doc};
}
Field seed_field() { return {"seed", whole_number(0, 2147483647), false, "of the random numbers; default 1"}; }
Field along_field() { return {"along", choice({"x", "y"}), false, "direction of the cut; default x"}; }

/// The keys that every use of a surface has.
template <class Description>
void read_surface(const Json& object, Description& out) {
  out.surface = to_choice<plot::ProfileSurface>(object["surface"]);
  out.seed = static_cast<std::uint64_t>(object.value("seed", 1.0));
  out.along_y = object.value("along", "x") == "y";
}

} // namespace

ShapePtr autocorrelation_shape() {
  return named("autocorrelation", [] {
    return object({surface_field(true, "whose heights: gaussian, ggx or uncorrelated"), seed_field(), along_field()});
  });
}

plot::AutocorrelationDescription read_autocorrelation(const JsonFile& file, const Json& panel,
                                                      const std::string& pointer) {
  plot::AutocorrelationDescription out;
  read_surface(panel["autocorrelation"], out);
  if (const auto problem = plot::problem_of(out))
    file.fail(pointer + "/autocorrelation/" + problem->key, problem->what);
  return out;
}

ShapePtr profile_shape() {
  return named("profile", [] {
    return object(
        {surface_field(false, "what is cut by the plane of incidence"),
         seed_field(),
         along_field(),
         {"cut", whole_number(0, 65535), false, "which of the parallel cuts, or pair of V-cavities; default 0"},
         {"from", whole_number(0, 1000000), false, "first facet drawn; default 0"},
         {"cells", whole_number(1, 2000), false, "facets drawn; default 64"},
         {"stretch", number({.min = 0, .open_min = true}), false,
          "factor along the cut, of surface and directions alike; default 1"},
         {"shear", number(), false, "slope added to surface and directions alike, after the stretch; default 0"},
         {"omega_o", angle(), false, "towards the viewer, from the normal; positive to the right"},
         {"omega_i", angle(), false, "towards the light"},
         {"normals", whole_number(0, 200), false, "how many normals are drawn; default none"},
         {"rays", whole_number(0, 200), false, "from how many points rays go to the viewer; default none"},
         {"paths", whole_number(0, 200), false,
          "light from omega_o to so many points, reflected by mirrors, in the plane of the cut; default none"},
         {"bounces", whole_number(1, 16), false, "of a path at most; default 4"},
         {"projection", boolean(), false, "whether what is visible is projected on a line across omega_o"},
         {"mesosurface", boolean(), false, "whether the mesosurface is drawn"},
         {"arrows", array(choice(plot::profile_arrows()), 1), false, "directions drawn at one visible point"},
         {"point", number({.min = 0, .max = 1}), false, "where that is, from the left to the right; default 0.5"},
         {"numbers", array(choice(plot::profile_numbers()), 1), false, "measured on the whole surface"}});
  });
}

plot::ProfileDescription read_profile(const JsonFile& file, const Json& panel, const std::string& pointer) {
  Json merged = file.root().value("profile", Json::object());
  for (const auto& [key, value] : panel["profile"].items()) merged[key] = value;
  const auto place = [&](const std::string& key) {
    const std::string here = pointer + "/profile";
    const bool above = !panel["profile"].contains(key) && file.root().contains("profile");
    return above && file.root()["profile"].contains(key) ? "/profile" : here;
  };
  if (!merged.contains("surface")) file.fail(pointer + "/profile", "\"surface\" is missing here and above");
  plot::ProfileDescription out;
  read_surface(merged, out);
  const auto whole = [&](const char* key, int& value) { value = static_cast<int>(merged.value(key, double(value))); };
  whole("cut", out.cut);
  whole("from", out.from);
  whole("cells", out.cells);
  whole("normals", out.normals);
  whole("rays", out.rays);
  whole("paths", out.paths);
  whole("bounces", out.bounces);
  out.stretch = merged.value("stretch", out.stretch);
  out.shear = merged.value("shear", out.shear);
  if (merged.contains("omega_o")) out.omega_o = to_number(merged["omega_o"]);
  if (merged.contains("omega_i")) out.omega_i = to_number(merged["omega_i"]);
  out.projection = merged.value("projection", out.projection);
  out.mesosurface = merged.value("mesosurface", out.mesosurface);
  out.arrows = merged.value("arrows", out.arrows);
  out.point = merged.value("point", out.point);
  out.numbers = merged.value("numbers", out.numbers);
  if (const auto problem = plot::problem_of(out)) {
    const std::string first = problem->key.substr(0, problem->key.find('/'));
    file.fail(place(first) + (problem->key.empty() || problem->key.back() == '/' ? "" : "/" + problem->key),
              problem->what);
  }
  return out;
}

} // namespace brdfplot::config
