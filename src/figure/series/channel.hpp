/// \file
/// Which channel of a coloured quantity a figure draws.
#pragma once

#include "brdf/material.hpp"

#include <optional>
#include <string>
#include <vector>

namespace brdfplot::plot {

/// Red, green, blue, or the luminance Y of linear RGB, Y = 0.2126 r + 0.7152 g + 0.0722 b (ITU-R BT.709, item 3.2).
enum class Channel { r, g, b, luminance };

/// The names of `Channel`, in its order.
const std::vector<std::string>& channel_names();

/// The share that each of three channels has in `channel`.
Rgb weights_of(Channel channel);

/// The one channel that `channel` is; that of all where none is named.
/// \throws InputError for luminance, which is none.
int single_channel(std::optional<Channel> channel, const std::string& quantity);

/// Whether a quantity has a value for each channel of a coloured material; all that is simulated has.
bool is_coloured(const std::string& quantity);

/// Whether a quantity has channels of different values with this material.
bool channels_differ(const MaterialDescription& description, const Material& material, const std::string& quantity);

/// \throws InputError where the colours of a material differ and none is named: what to write.
void require_channel(const MaterialDescription& description, const Material& material, std::optional<Channel> channel,
                     const std::string& quantity);

} // namespace brdfplot::plot
