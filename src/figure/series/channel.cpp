#include "figure/series/channel.hpp"

#include "analysis/integrals.hpp"

#include <algorithm>

namespace brdfplot::plot {

namespace {

/// Whether all colours that stand among the values are the same in every channel.
bool is_grey(const Value& value) {
  const auto* rgb = std::get_if<Rgb>(&value);
  return rgb == nullptr || ((*rgb)[0] == (*rgb)[1] && (*rgb)[0] == (*rgb)[2]);
}

bool is_grey(const MaterialDescription& material) {
  return std::ranges::all_of(material.terms, [](const TermDescription& term) {
    const auto grey = [](const auto& entry) { return is_grey(entry.second); };
    const auto grey_layer = [&](const LayerDescription& layer) {
      return is_grey(layer.weight) && std::ranges::all_of(layer.values.map(), grey);
    };
    return is_grey(term.weight) && std::ranges::all_of(term.layers, grey_layer) &&
           std::ranges::all_of(term.values.map(), grey) && std::ranges::all_of(term.fresnel.values.map(), grey);
  });
}

} // namespace

const std::vector<std::string>& channel_names() {
  static const std::vector<std::string> names = {"r", "g", "b", "luminance"};
  return names;
}

Rgb weights_of(Channel channel) {
  switch (channel) {
  case Channel::r: return {1, 0, 0};
  case Channel::g: return {0, 1, 0};
  case Channel::b: return {0, 0, 1};
  case Channel::luminance: break;
  }
  return {0.2126, 0.7152, 0.0722};
}

int single_channel(std::optional<Channel> channel, const std::string& quantity) {
  if (channel == Channel::luminance)
    throw InputError("", "\"" + quantity + "\" has no luminance; accepted: \"channel\": \"r\", \"g\" or \"b\"");
  return static_cast<int>(channel.value_or(Channel::r));
}

bool is_coloured(const std::string& quantity) {
  const std::string name = quantity.substr(quantity.rfind('.') + 1);
  const auto known = std::ranges::find(quantities(), name, &QuantityInfo::name);
  if (known != quantities().end()) return known->coloured();
  if (name == "pdf") return false;
  const auto integral = std::ranges::find(integrals(), name, &IntegralInfo::name);
  return integral == integrals().end() || integral->coloured;
}

bool channels_differ(const MaterialDescription& description, const Material& material, const std::string& quantity) {
  return material.channels() > 1 && is_coloured(quantity) && !is_grey(description);
}

void require_channel(const MaterialDescription& description, const Material& material, std::optional<Channel> channel,
                     const std::string& quantity) {
  if (channel || !channels_differ(description, material, quantity)) return;
  throw InputError("", "\"" + quantity +
                           "\" has three channels with this material, which differ; write which is meant: \"channel\": "
                           "\"r\", \"g\", \"b\" or \"luminance\"");
}

} // namespace brdfplot::plot
