#include "brdf/coat.hpp"

#include "brdf/material.hpp"
#include "brdf/terms/coated.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

/// The cosines of n directions with the unit normal of the mesosurface; 0 where one lies below.
template <class Cosine>
std::vector<double> cosines(const Columns& directions, std::size_t n, const Cosine& cosine) {
  std::vector<double> c(n);
  for (std::size_t k = 0; k < n; ++k) c[k] = std::clamp(cosine(directions[k]), 0.0, 1.0);
  return c;
}

bool refracts(const Fresnel& fresnel) {
  return std::visit(
      [](const auto& f) {
        return requires { f.relative_index(0); };
      },
      fresnel);
}

double relative_index(const Fresnel& fresnel, std::size_t channel) {
  return std::visit(
      [&](const auto& f) {
        if constexpr (requires { f.relative_index(channel); })
          return f.relative_index(channel);
        else
          return 1.0;
      },
      fresnel);
}

bool has_critical_angle(const Fresnel& fresnel) {
  return refracts(fresnel) &&
         (relative_index(fresnel, 0) < 1 || relative_index(fresnel, 1) < 1 || relative_index(fresnel, 2) < 1);
}

bool is_coloured(const Fresnel& fresnel) {
  return std::visit([](const auto& f) { return f.coloured(); }, fresnel);
}

} // namespace

std::vector<ParameterSpec> Coat::parameters() {
  return {{.key = "attenuation",
           .kind = ParameterKind::choice,
           .fallback = std::string("both"),
           .doc = "what the coat takes from the light to and from the base: 1 - F both ways, of the viewer alone "
                  "(half), at the half vector, what its albedo leaves, or nothing",
           .choices = {"both", "half", "half_vector", "albedo", "none"}},
          Colour::parameter("tint", "what the coat lets through down and up along the normal, of each channel")};
}

Coat::Coat(const TermDescription& coat, const Values& values)
    : attenuation_(values.text("attenuation")), tint_(Colour::from(values, "tint")) {
  const WeightedTerm over = build_term(coat);
  weight_ = over.weight;
  const std::string found = "found \"" + attenuation_ + "\" with the coat \"" + over.name + "\", ";
  if (const Microsurface* surface = over.surface()) mesosurface_ = surface->slopes();
  if (over.fresnel() != nullptr) fresnel_ = *over.fresnel();
  const bool of_fresnel = attenuation_ != "albedo" && attenuation_ != "none";
  if (of_fresnel && over.fresnel() == nullptr)
    throw MaterialError("/attenuation", found + "which has no Fresnel term; accepted: albedo, none");
  if (of_fresnel && has_critical_angle(fresnel_))
    throw MaterialError("/attenuation", found + "whose eta is below 1; accepted: a coat of eta >= 1");
  if (of_fresnel && std::ranges::any_of(weight_.value, [](double w) { return w > 1; }))
    throw MaterialError("/attenuation", found + "whose weight is above 1; accepted: a weight in [0, 1]");
  if (tint_.value != Rgb{1, 1, 1} && !refracts(fresnel_))
    throw MaterialError("/tint", "found a colour with the coat \"" + over.name +
                                     "\", which has no index of refraction; accepted: a coat whose Fresnel term is "
                                     "dielectric, which says how long the way through it is");
  if (attenuation_ != "albedo") return;
  albedo_.emplace(coat);
  if (!albedo_->is_isotropic())
    throw MaterialError("/attenuation", found + "which is anisotropic; accepted: an isotropic coat");
}

int Coat::channels() const {
  const bool of_fresnel = attenuation_ != "albedo" && attenuation_ != "none";
  const bool coloured = tint_.is_rgb || (of_fresnel && (weight_.is_rgb || is_coloured(fresnel_))) ||
                        (albedo_ && albedo_->channels() > 1) || (tint_.value != Rgb{1, 1, 1} && is_coloured(fresnel_));
  return coloured ? 3 : 1;
}

std::vector<Switch> Coat::kinks(const Direction& omega_o) const {
  if (!albedo_) return {};
  return {{[omega_o](const std::vector<Direction>& h, std::vector<double>& out) {
    for (std::size_t k = 0; k < h.size(); ++k) out[k] = 2 * dot(omega_o, h[k]) * h[k].z - 2 * omega_o.z;
  }}};
}

double Coat::cosine(const Direction& omega) const {
  const double length = std::hypot(1, std::hypot(mesosurface_.mean_x, mesosurface_.mean_y));
  return mesosurface_.project(omega).c / length;
}

void Coat::attenuate(const Columns& o, const Columns& i, std::size_t n, int channels,
                     std::vector<double>& factor) const {
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
    double* const out = factor.data() + c * n;
    if (albedo_)
      attenuate_by_albedo(o, i, n, c, out);
    else if (attenuation_ != "none")
      attenuate_by_fresnel(o, i, n, c, out);
    if (tint_.value[c] != 1) absorb(o, i, n, c, out);
  }
}

void Coat::attenuate_by_fresnel(const Columns& o, const Columns& i, std::size_t n, std::size_t channel,
                                double* factor) const {
  std::vector<double> left(n);
  const double w = weight_.value[channel];
  const auto take = [&](const std::vector<double>& c) {
    std::visit([&](const auto& term) { term.losses(c.data(), channel, left.data(), n); }, fresnel_);
    for (std::size_t k = 0; k < n; ++k) factor[k] *= (1 - w) + w * left[k];
  };
  const auto of_normal = [&](const Direction& d) { return cosine(d); };
  if (attenuation_ == "half_vector") {
    std::vector<double> c(n);
    for (std::size_t k = 0; k < n; ++k) {
      const Direction sum = o[k] + i[k]; // of length 2 (o.h)
      c[k] = std::min(1.0, 0.5 * std::sqrt(dot(sum, sum)));
    }
    return take(c);
  }
  take(cosines(o, n, of_normal));
  if (attenuation_ == "both") take(cosines(i, n, of_normal));
}

void Coat::attenuate_by_albedo(const Columns& o, const Columns& i, std::size_t n, std::size_t channel,
                               double* factor) const {
  const AlbedoTable& table = albedo_->table();
  const std::size_t c = table.channels() > 1 ? channel : 0;
  for (std::size_t k = 0; k < n; ++k)
    if (o[k].z > 0 && i[k].z > 0) factor[k] *= std::min(table.loss(c, o[k]), table.loss(c, i[k]));
}

void Coat::absorb(const Columns& o, const Columns& i, std::size_t n, std::size_t channel, double* factor) const {
  const double eta = relative_index(fresnel_, channel), log_tint = std::log(tint_.value[channel]);
  const auto path = [&](const Direction& d) {
    const double c = std::clamp(cosine(d), 0.0, 1.0);
    // eta^2 - (1 - c^2) without the cancellation of eta near 1
    return eta / std::sqrt((eta - 1) * (eta + 1) + c * c);
  };
  for (std::size_t k = 0; k < n; ++k) factor[k] *= std::exp(0.5 * (path(o[k]) + path(i[k])) * log_tint);
}

void lay_coats(const MaterialDescription& description, Material& material) {
  for (std::size_t k = 0; k < material.terms.size(); ++k)
    for (const LayerDescription& layer : description.terms[k].layers) {
      if (layer.coat.empty()) continue;
      const auto over = std::ranges::find(material.terms, layer.coat, &WeightedTerm::name);
      // With its own weight alone: that of a coated term multiplies what is left of its base as well.
      TermDescription coat = description.terms[static_cast<std::size_t>(over - material.terms.begin())];
      coat.layers.clear();
      TermDescription coated{};
      coated.values = layer.values;
      try {
        material.terms[k].coats.emplace_back(coat, completed_values<Coated>(coated));
      } catch (const MaterialError& error) {
        throw MaterialError(layer.place + error.pointer(), error.reason());
      }
    }
}

std::vector<double> let_through(const std::vector<Coat>& coats, const Columns& o, const Columns& i, std::size_t n,
                                int channels) {
  if (coats.empty()) return {};
  std::vector<double> factor(static_cast<std::size_t>(channels) * n, 1.0);
  for (const Coat& coat : coats) coat.attenuate(o, i, n, channels, factor);
  return factor;
}

} // namespace brdfplot
