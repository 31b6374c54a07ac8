/// \file
/// A fit as source code.
#pragma once

#include "analysis/fit/fit.hpp"

#include <string>
#include <vector>

namespace brdfplot {

enum class FitLanguage { cpp, glsl, hlsl };

/// The name of a material as an identifier of all three languages: lower-case letters, digits and single underscores,
/// beginning with a letter.
std::string fit_identifier(const std::string& name);

/// What the fit is and how good it is: lines of plain text.
std::vector<std::string> describe(const FitResult& result, double tolerance);

/// The functions NAME_lambda, NAME_g1 and NAME_g2 (of the material's form of shadowing), and NAME_terms, of which they
/// are made; the description stands above them as a comment. They are finite at every direction, grazing and normal
/// included, and 0 (lambda: large) below the horizon. Their arguments are
/// - where the azimuth does not count: cosines, and alpha where the distribution is shape-invariant;
/// - where it does (anisotropy, correlation, a mean slope): unit vectors, alpha_x, alpha_y, and correlation and mean
///   slope where the material has one, from which NAME_project makes c and s (SlopeMap::project()). Where there is no
///   mean slope NAME_lambda and NAME_g1 take a cosine and alpha_o too;
/// then the parameter, if the fit has one, and, where G2 depends on it and is not given vectors, the difference in
/// azimuth. C++: templates over the floating-point type, a header of its own. GLSL: every version from 1.10 on. HLSL:
/// every shader model. The arithmetic is that of fit_arithmetic.hpp.
std::string fit_code(const FitResult& result, double tolerance, FitLanguage language);

} // namespace brdfplot
