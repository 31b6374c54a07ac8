/// \file
/// The list of problems: a file with a function, declared and listed here.
#pragma once

#include "choice/methods/method.hpp"

namespace brdfplot::choice {

Problem albedo_oren_nayar();
Problem alpha_o();
Problem angle_from_cosine();
Problem d_beckmann();
Problem d_ggx();
Problem d_gtr();
Problem half_vector();
Problem lambda_beckmann();
Problem lambda_ggx();
Problem narrow_peak();
Problem weak_furnace();

/// Each makes a problem.
inline constexpr std::array problem_list = {
    &albedo_oren_nayar, &alpha_o,         &angle_from_cosine, &d_beckmann,  &d_ggx,       &d_gtr,
    &half_vector,       &lambda_beckmann, &lambda_ggx,        &narrow_peak, &weak_furnace};

} // namespace brdfplot::choice
