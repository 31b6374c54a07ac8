/// \file
/// The list of problems: a file with a function, declared and listed here.
#pragma once

#include "choice/methods/method.hpp"

#include <string_view>

namespace brdfplot::choice {

Problem albedo_ggx();
Problem albedo_ggx_a();
Problem albedo_ggx_b();
Problem albedo_oren_nayar();
Problem alpha_o();
Problem angle_from_cosine();
Problem brdf_ggx();
Problem d_beckmann();
Problem d_ggx();
Problem d_gtr();
Problem fresnel_conductor();
Problem fresnel_dielectric();
Problem g2();
Problem g2_directions();
Problem half_vector();
Problem lambda_beckmann();
Problem lambda_ggx();
Problem lambda_sheen();
Problem lambda_student_t();
Problem narrow_peak();
Problem sample_beckmann();
Problem weak_furnace();

/// A problem by its name: making one takes a while where it has tables and fits.
struct ListedProblem {
  std::string_view name;
  Problem (*make)();
};

inline constexpr std::array problem_list = {
    ListedProblem{"lambda_beckmann", &lambda_beckmann},
    ListedProblem{"lambda_ggx", &lambda_ggx},
    ListedProblem{"lambda_sheen", &lambda_sheen},
    ListedProblem{"lambda_student_t", &lambda_student_t},
    ListedProblem{"g2", &g2},
    ListedProblem{"g2_directions", &g2_directions},
    ListedProblem{"fresnel_dielectric", &fresnel_dielectric},
    ListedProblem{"fresnel_conductor", &fresnel_conductor},
    ListedProblem{"brdf_ggx", &brdf_ggx},
    ListedProblem{"sample_beckmann", &sample_beckmann},
    ListedProblem{"albedo_ggx", &albedo_ggx},
    ListedProblem{"albedo_ggx_a", &albedo_ggx_a},
    ListedProblem{"albedo_ggx_b", &albedo_ggx_b},
    ListedProblem{"albedo_oren_nayar", &albedo_oren_nayar},
    ListedProblem{"alpha_o", &alpha_o},
    ListedProblem{"angle_from_cosine", &angle_from_cosine},
    ListedProblem{"d_beckmann", &d_beckmann},
    ListedProblem{"d_ggx", &d_ggx},
    ListedProblem{"d_gtr", &d_gtr},
    ListedProblem{"half_vector", &half_vector},
    ListedProblem{"narrow_peak", &narrow_peak},
    ListedProblem{"weak_furnace", &weak_furnace},
};

std::vector<std::string> problem_names();

/// The problem of this name, which is one of problem_names(); else nothing.
std::optional<Problem> make_problem(const std::string& name);

} // namespace brdfplot::choice
