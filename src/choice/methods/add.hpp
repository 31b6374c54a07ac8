/// \file
/// What the files of problems share: a formula in double and float.
#pragma once

#include "choice/methods/method.hpp"

namespace brdfplot::choice {

/// A formula for any number type, in double and, as NAME_float, in float.
template <std::size_t inputs, class F>
void add_formula(Problem& problem, const std::string& name, const std::string& doc, const std::string& source,
                 Kind kind, F formula, const std::vector<std::array<double, inputs>>& examples) {
  problem.methods.push_back(method_of<double>(name, doc, source, kind, formula, examples));
  problem.methods.push_back(method_of<float>(name + "_float", doc + ", in float", source, kind, formula, examples));
}

} // namespace brdfplot::choice
