#include "plot/channel.hpp"

#include "analysis/integrals.hpp"

#include <algorithm>

namespace brdfplot::plot {

namespace {

/// Whether a colour stands among the values, and all that do are the same in every channel.
bool is_grey(const Values& values) {
  bool found = false;
  for (const auto& entry : values.map()) {
    const auto* rgb = std::get_if<Rgb>(&entry.second);
    if (rgb == nullptr) continue;
    found = true;
    if ((*rgb)[0] != (*rgb)[1] || (*rgb)[0] != (*rgb)[2]) return false;
  }
  return found;
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
  const auto known = std::ranges::find(quantities(), quantity, &QuantityInfo::name);
  if (known != quantities().end()) return known->coloured;
  const auto integral = std::ranges::find(integrals(), quantity, &IntegralInfo::name);
  return integral == integrals().end() || integral->coloured;
}

void require_channel(const MaterialDescription& description, const Material& material, std::optional<Channel> channel,
                     const std::string& quantity) {
  if (channel || material.channels() == 1 || !is_coloured(quantity) || is_grey(description.fresnel.values)) return;
  throw InputError("", "\"" + quantity +
                           "\" has three channels with this material, which differ; write which is meant: \"channel\": "
                           "\"r\", \"g\", \"b\" or \"luminance\"");
}

} // namespace brdfplot::plot
