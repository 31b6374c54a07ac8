#include "choice/advise/shader/flat.hpp"

#include "base/errors.hpp"
#include "choice/advise/shader/mirror.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace brdfplot::choice::forms {

namespace {

using N = Counted;

constexpr double nl = 0.6, nv = 0.7, lv = 0.9, hl = 0.95;

/// A formula and what of it is of each channel.
struct Form {
  bool half = false; ///< asks for the half vector
  std::function<void()> view{}, light{}, channel{};
};

void one_product() { (void)(N(0.5) * N(0.5)); }

void fujii() { (void)(N(0.3) + N(0.2) * fujii_ratio(N(lv), N(nl), N(nv))); }

void eon_light() {
  fujii();
  (void)(eon_loss(N(nl)) * N(0.3));
}

/// Equations 29 and 30 of Oren and Nayar (1994): angles of both directions and their azimuth difference.
void oren_nayar_full() {
  const Counted3 o = viewer(), i = light();
  const N theta_i = acos(i.z), cos_phi = (o.x * i.x + o.y * i.y) / sqrt((N(1) - o.z * o.z) * (N(1) - i.z * i.z));
  const N alpha = max(theta_i, N(0.7)), beta = min(theta_i, N(0.7));
  const N c2 = sin(alpha) - pow(N(0.6) * beta, N(3));
  const N c3 = N(0.4) * (alpha * beta) * (alpha * beta);
  const N first = N(0.5) + cos_phi * c2 * tan(beta) + (N(1) - abs(cos_phi)) * c3 * tan(N(0.5) * (alpha + beta));
  (void)(first + (N(1) - cos_phi * beta * beta) * N(0.1));
}

void schlick_weight_of_light() { (void)fifth_power(N(nl)); }
void schlick_weight_of_view() { (void)fifth_power(N(nv)); }

void hammon_light() {
  schlick_weight_of_light();
  const N k = N(0.5) + N(0.5) * N(lv);
  const N rough = k * (N(0.9) - N(0.4) * k) * (N(0.5) + N(hl)) / N(hl);
  (void)(N(0.5) * N(0.6) + N(0.4) * rough);
}

void disney_light() {
  const N f90 = N(0.5) + N(1.2) * N(hl) * N(hl);
  const N by_light = N(1) + (f90 - N(1)) * fifth_power(N(nl));
  (void)(by_light * (N(1) + (f90 - N(1)) * N(0.2)));
}

void velvet_light() {
  const N d = d_velvet(N(0.8), N(0.2), N(0.3), N(4));
  (void)(d / (N(nl) + N(nv) - N(nl) * N(nv)));
  (void)fifth_power(N(hl));
}

void velvet_channel() {
  const N f = schlick(N(0.1), N(0.04), N(0.96));
  (void)((N(1) - f) * N(0.3) + f * N(0.2));
}

void table_of_light() { read_table(1); }

/// Half and difference angles of a measured table.
void measured_light() {
  (void)acos(N(hl));
  (void)acos(N(0.9));
  (void)atan2(N(0.3), N(0.4));
}

const std::map<std::string, Form>& all_forms() {
  static const std::map<std::string, Form> all = {
      {"lambert", {false, {}, {}, one_product}},
      {"fujii_oren_nayar", {true, {}, fujii, one_product}},
      {"eon", {true, [] { (void)eon_loss(N(nv)); }, eon_light, [] { (void)(N(0.5) * N(0.5) + N(0.5) * N(0.5)); }}},
      {"hammon_diffuse", {true, schlick_weight_of_view, hammon_light, one_product}},
      {"disney_diffuse", {true, schlick_weight_of_view, disney_light, one_product}},
      {"shirley",
       {false, schlick_weight_of_view,
        [] {
          schlick_weight_of_light();
          one_product();
        },
        one_product}},
      {"fresnel_lambert", {true, {}, schlick_weight_of_light, [] { (void)(N(0.5) * (N(1) - N(0.5) * N(0.5))); }}},
      {"disney_sheen", {true, {}, [] { (void)fifth_power(N(hl)); }, one_product}},
      {"velvet_cloth", {true, {}, velvet_light, velvet_channel}},
      {"uncharted2", {false, [] { (void)(pow(N(nv), N(3)) * N(0.5) + pow(N(0.3), N(2)) * N(0.5)); }, {}, one_product}},
      {"wrap", {false, {}, [] { (void)max(N(nl) * N(0.5) + N(0.5), N(0)); }, one_product}},
      {"multiple_bounce", {false, table_of_light, table_of_light, one_product}},
      {"complement", {false, table_of_light, table_of_light, one_product}},
      {"turquin", {true, table_of_light, one_product, one_product}},
      {"merl", {true, {}, measured_light, table_of_light}},
      {"rgl", {true, {}, measured_light, [] { read_table(8); }}}};
  return all;
}

Form form_of(const TermDescription& term) {
  if (term.type == "oren_nayar") {
    const bool qualitative = term.values.has("form") && term.values.text("form") == "qualitative";
    if (qualitative) return {false, {}, [] { (void)oren_nayar_qualitative(viewer(), light()); }, one_product};
    return {false, [] { (void)acos(N(nv)); }, oren_nayar_full, one_product};
  }
  const auto found = all_forms().find(term.type);
  if (found == all_forms().end())
    throw InputError(term.place, "\"" + term.type + "\" has no form that a shader computes; accepted: any other term");
  return found->second;
}

int channels_of(const TermDescription& term) {
  const auto& map = term.values.map();
  if (term.type == "multiple_bounce" || term.type == "turquin") return 3; // as coloured as the metal's Fresnel term
  const bool rgb = std::holds_alternative<Rgb>(term.weight) || std::ranges::any_of(map, [](const auto& entry) {
                     return std::holds_alternative<Rgb>(entry.second);
                   });
  return rgb ? 3 : 1;
}

} // namespace

bool needs_half_vector(const TermDescription& term) { return form_of(term).half; }

void flat_view(const TermDescription& term) {
  if (const Form form = form_of(term); form.view) form.view();
}

void flat_light(const TermDescription& term) {
  const Form form = form_of(term);
  if (form.light) form.light();
  for (int k = 0; k < channels_of(term); ++k) form.channel();
}

} // namespace brdfplot::choice::forms
