#include "figure/series/term.hpp"

#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "choice/advise/shader/sampling_cost.hpp"

#include <algorithm>
#include <array>

namespace brdfplot::plot {

namespace {

/// One channel of `all`, which has three, n apart, or a mixture of them.
std::vector<double> mixed(const std::vector<double>& all, std::size_t n, Channel channel) {
  const Rgb weights = weights_of(channel);
  std::vector<double> out(n, 0);
  for (std::size_t c = 0; c < 3; ++c)
    if (weights[c] != 0)
      for (std::size_t k = 0; k < n; ++k) out[k] += weights[c] * all[c * n + k];
  return out;
}

bool has_cost(SampledQuantity quantity) {
  return quantity == SampledQuantity::sampling_cost || quantity == SampledQuantity::variance_times_cost;
}

/// The names under which a term's quantity may go.
std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const auto& info : quantities()) names.push_back(info.name);
  for (const auto& info : integrals()) names.push_back(info.name);
  for (const auto& info : sampled_quantities()) names.push_back(info.name);
  return names;
}

} // namespace

std::string quantity_part(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? name : name.substr(dot + 1);
}

std::string term_part(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

bool depends_on(const std::string& name, const std::string& variable) {
  const std::string quantity = quantity_part(name);
  if (variable == "channel") return is_coloured(quantity);
  const bool of_m = variable == "theta_m" || variable == "phi_m" || variable == "slope";
  const bool of_i = variable == "theta_i" || variable == "phi_i";
  const bool sampled =
      std::ranges::find(sampled_quantities(), quantity, &SampledQuantityInfo::name) != sampled_quantities().end();
  const bool of_o_alone = quantity == "lambda" || (sampled && quantity != "pdf") ||
                          std::ranges::find(integrals(), quantity, &IntegralInfo::name) != integrals().end();
  if (of_o_alone) return !of_m && !of_i;
  return !of_m || (quantity != "brdf" && quantity != "brdf_cos" && quantity != "pdf");
}

TermFunction::TermFunction(const Term& term, std::vector<std::string> swept, double tolerance)
    : name_(term.quantity), term_(term_part(term.quantity)), configuration_(term, std::move(swept)),
      tolerance_(tolerance) {
  const std::string quantity = quantity_part(term.quantity);
  for (const auto& info : quantities())
    if (info.name == quantity) quantity_ = info.quantity;
  for (const auto& info : integrals())
    if (info.name == quantity) integral_ = info.integral;
  for (const auto& info : sampled_quantities())
    if (info.name == quantity) sampled_ = info.quantity;
  if (sampled_ && !term_.empty())
    throw InputError("", "found \"" + name_ + "\", accepted: \"" + quantity + "\", of all terms together");
  if (!quantity_ && !integral_ && !sampled_)
    throw InputError("", unknown_name("quantity", term.quantity, quantity_names()));
}

void TermFunction::require_all(const MaterialDescription& description, const Material& material,
                               const Directions& directions) const {
  if ((integral_ || sampled_) && !directions.o) throw InputError("", "this quantity needs theta_o");
  if (sampled_ == SampledQuantity::pdf && !directions.i) throw InputError("", "this quantity needs theta_i");
  if (sampled_ && has_cost(*sampled_)) (void)choice::sampling_operations(description, fixed().strategy());
  if (sampled_)
    require_strategy(material, fixed().strategy());
  else if (quantity_)
    require(material, info_of(*quantity_), directions.o.has_value(), directions.i.has_value(), directions.m.has_value(),
            term_);
  else
    require(material, integrals()[static_cast<std::size_t>(*integral_)], term_);
  require_channel(description, material, fixed().channel(), name_);
  const bool mixes = !is_integral() || integral_ == Integral::albedo;
  if (!mixes && is_coloured(name_) && material.channels() > 1) single_channel(fixed().channel(), name_);
}

void TermFunction::check(const std::vector<double>& values) const {
  const auto ready = configuration_.at(values);
  require_all(ready.description, ready.material, {ready.o, ready.i, ready.m});
}

double TermFunction::integral_at(const Material& material, const Direction& o) const {
  throw_if_interrupted();
  const auto of_channel = [&](int channel) {
    return compute_or_throw(*integral_, material, o, tolerance_, channel, term_);
  };
  if (material.channels() == 1) return of_channel(0);
  if (fixed().channel() != Channel::luminance) return of_channel(single_channel(fixed().channel(), name_));
  const Rgb weights = weights_of(Channel::luminance);
  double sum = 0;
  for (int channel = 0; channel < 3; ++channel) sum += weights[static_cast<std::size_t>(channel)] * of_channel(channel);
  return sum;
}

std::vector<double> TermFunction::evaluated(const Material& material, const std::vector<Directions>& directions) const {
  const std::size_t n = directions.size();
  std::array<std::vector<double>, 9> components;
  const auto columns = [&](std::size_t first, const auto& direction) {
    for (const Directions& row : directions) {
      const Direction d = direction(row);
      components[first].push_back(d.x);
      components[first + 1].push_back(d.y);
      components[first + 2].push_back(d.z);
    }
    return Columns{components[first].data(), components[first + 1].data(), components[first + 2].data()};
  };
  Batch batch{n, {}, {}, {}};
  batch.o = columns(0, [](const Directions& row) { return row.o.value_or(Direction{0, 0, 1}); });
  if (directions.front().i) batch.i = columns(3, [](const Directions& row) { return *row.i; });
  if (directions.front().m) batch.m = columns(6, [](const Directions& row) { return *row.m; });
  const auto channels = static_cast<std::size_t>(channels_of(material, *quantity_, term_));
  std::vector<double> all(channels * n);
  evaluate(material, *quantity_, batch, all.data(), term_);
  if (channels > 1) all = mixed(all, n, fixed().channel().value_or(Channel::r));
  for (const double value : all)
    if (!is_told(*quantity_, value))
      throw AccuracyError("", "\"" + name_ + "\": found " + format_number(value) + ", accepted: a finite number");
  return all;
}

std::vector<double> TermFunction::sampled(const MaterialDescription& description, const Material& material,
                                          const std::vector<Directions>& directions) const {
  const double cost =
      has_cost(*sampled_) ? choice::cost(choice::sampling_operations(description, fixed().strategy())) : 1;
  if (*sampled_ == SampledQuantity::sampling_cost) return std::vector<double>(directions.size(), cost);
  const Sampler sampler(material, fixed().strategy());
  const int channel = material.channels() == 1 ? 0 : single_channel(fixed().channel(), name_);
  std::vector<double> values;
  for (const Directions& row : directions) {
    throw_if_interrupted();
    const Direction& o = *row.o;
    values.push_back(0);
    if (*sampled_ == SampledQuantity::pdf)
      sampler.densities(1, {&o.x, &o.y, &o.z}, {&row.i->x, &row.i->y, &row.i->z}, &values.back());
    else if (*sampled_ == SampledQuantity::largest_weight)
      values.back() = largest_weight(material, sampler, o, channel);
    else
      values.back() = cost * weight_variance(material, sampler, o, tolerance_, channel);
  }
  return values;
}

std::vector<double> TermFunction::operator()(const SweptColumns& columns) const {
  std::vector<double> out(columns.empty() ? 1 : columns.front().size());
  configuration_.for_each_surface(columns,
                                  [&](const Configuration::Surface& surface, const auto& rows, const auto& directions) {
                                    require_all(surface.description, surface.material, directions.front());
                                    std::vector<double> values;
                                    if (quantity_) {
                                      values = evaluated(surface.material, directions);
                                    } else if (sampled_) {
                                      values = sampled(surface.description, surface.material, directions);
                                    } else if (configuration_.is_constant()) {
                                      values.assign(rows.size(), integral_at(surface.material, *directions.front().o));
                                    } else {
                                      for (const Directions& row : directions)
                                        values.push_back(integral_at(surface.material, *row.o));
                                    }
                                    for (std::size_t k = 0; k < rows.size(); ++k) out[rows[k]] = values[k];
                                  });
  return out;
}

} // namespace brdfplot::plot
