/// \file
/// The list of measures. A new one is one file in measures/ and its name here, declared and listed.
#pragma once

#include "simulation/measures/measure.hpp"

#include <vector>

namespace brdfplot::simulation {

MeasureType g1_measure();
MeasureType g1_by_normal_measure();
MeasureType g2_measure();
MeasureType visible_normals_measure();
MeasureType lobe_measure();
MeasureType hemisphere_measure();
MeasureType bounces_measure();

inline const std::vector<MeasureType>& measure_types() {
  static const std::vector<MeasureType> all = {g1_measure(),              //
                                               g1_by_normal_measure(),    //
                                               g2_measure(),              //
                                               visible_normals_measure(), //
                                               lobe_measure(),            //
                                               hemisphere_measure(),      //
                                               bounces_measure()};
  return all;
}

} // namespace brdfplot::simulation
