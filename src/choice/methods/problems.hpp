/// \file
/// The list of problems: a file with a function, declared and listed here.
#pragma once

#include "choice/methods/method.hpp"

namespace brdfplot::choice {

Problem d_ggx();
Problem lambda_ggx();

/// Each makes a problem.
inline constexpr std::array problem_list = {&lambda_ggx, &d_ggx};

} // namespace brdfplot::choice
