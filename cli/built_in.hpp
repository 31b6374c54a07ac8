/// \file
/// The configs that come with the program.
#pragma once

#include <string>

namespace brdfplot::cli {

/// The path of `name` ("reports/heitz2014.json") in the configs beside the executable, in the source tree of the build
/// or in the installation. \throws FileError when it is in none.
std::string built_in_config(const std::string& name);

} // namespace brdfplot::cli
