/// \file
/// How different two colours on a screen look.
#pragma once

#include "choice/advise/images/scene.hpp"

namespace brdfplot::choice {

/// The screen: white, the brightest it shows, and what it reflects of the room (cd/m^2). Without the last, black
/// decides.
inline constexpr double screen_white = 203, screen_peak = 1000, screen_flare = 1;

/// Linear BT.709 in cd/m^2 as the screen shows radiance `rgb` times the exposure.
Rgb shown(const Rgb& rgb, double exposure);

/// Delta E_ITP of two colours in linear BT.709, cd/m^2 (ITU-R BT.2124-0, with BT.2100's IC_TC_P): 720 times the
/// distance in (I, C_T / 2, C_P); 1 is just noticeable. Colours outside of BT.709 are not made.
double delta_e_itp(const Rgb& a, const Rgb& b);

/// The difference of two radiances by a metric; relative: the largest of the channels, |a - b| / a with the flare added
/// to both.
double difference(Metric metric, const Rgb& a, const Rgb& b, double exposure);

} // namespace brdfplot::choice
