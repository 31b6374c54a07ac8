/// \file
/// A fit as source code.
#pragma once

#include "analysis/fit.hpp"

#include <string>
#include <vector>

namespace brdfplot {

enum class FitLanguage { cpp, glsl, hlsl };

/// The name of a material as an identifier of all three languages: lower-case letters, digits and single underscores,
/// beginning with a letter.
std::string fit_identifier(const std::string& name);

/// What the fit is and how good it is: lines of plain text.
std::vector<std::string> describe(const FitResult& result, double tolerance);

/// The functions NAME_lambda, NAME_g1 and NAME_g2 (height-correlated), and NAME_terms, of which they are made; the
/// description stands above them as a comment. They take cosines and the parameters that are not constants, are finite
/// at every cosine, grazing and normal included, and 0 (lambda: large) below the horizon. C++: templates over the
/// floating-point type, a header of its own. GLSL: every version from 1.10 on. HLSL: every shader model.
std::string fit_code(const FitResult& result, double tolerance, FitLanguage language);

} // namespace brdfplot
