/// \file
/// The list of problems: a file with a function, declared and listed here.
#pragma once

#include "choice/methods/method.hpp"

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

/// Each makes a problem.
inline constexpr std::array problem_list = {
    &lambda_beckmann,    //
    &lambda_ggx,         //
    &lambda_sheen,       //
    &lambda_student_t,   //
    &g2,                 //
    &g2_directions,      //
    &fresnel_dielectric, //
    &fresnel_conductor,  //
    &brdf_ggx,           //
    &sample_beckmann,    //
    &albedo_ggx,         //
    &albedo_ggx_a,       //
    &albedo_ggx_b,       //
    &albedo_oren_nayar,  //
    &alpha_o,            //
    &angle_from_cosine,  //
    &d_beckmann,         //
    &d_ggx,              //
    &d_gtr,              //
    &half_vector,        //
    &narrow_peak,        //
    &weak_furnace,       //
};

} // namespace brdfplot::choice
