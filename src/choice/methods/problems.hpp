/// \file
/// The list of problems: a file with a function, declared and listed here.
#pragma once

#include "choice/methods/method.hpp"

namespace brdfplot::choice {

Problem lambda_beckmann();
Problem lambda_ggx();

/// Each makes a problem.
inline constexpr std::array problem_list = {&lambda_beckmann, &lambda_ggx};

} // namespace brdfplot::choice
