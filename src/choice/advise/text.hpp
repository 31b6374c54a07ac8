/// \file
/// The answer as people read it.
#pragma once

#include "choice/advise/advise.hpp"

namespace brdfplot::choice {

/// Cost, errors and reasons of one material, a line each.
std::string advice_text(const AdviceScene& scene, const MaterialAdvice& advice);

/// Every model: cost, errors, and what is simpler, with one header line.
std::string models_csv(const AdviceScene& scene, const MaterialAdvice& advice);

/// "Delta E_ITP" or "relative radiance".
std::string metric_name(Metric metric);

} // namespace brdfplot::choice
