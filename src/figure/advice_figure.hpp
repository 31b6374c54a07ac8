/// \file
/// The models of a ladder of simplifications: error against cost.
#pragma once

#include "choice/advise/advise.hpp"
#include "draw/model.hpp"

namespace brdfplot::plot {

/// Every model that was evaluated as a dot, the front as a staircase, the tolerance as a line; the answer, the next
/// cheaper model and those that are one step further are named.
Figure advice_figure(const choice::AdviceScene& scene, const choice::MaterialAdvice& advice, const std::string& id);

} // namespace brdfplot::plot
