/// \file
/// What is computed as it was asked for and is perhaps not what was meant. The command line prints it at its end.
#pragma once

#include <string>
#include <vector>

namespace brdfplot {

/// Keeps "WHERE: WHAT" for the end, each text once, twenty at most. From any thread.
void warn(const std::string& where, const std::string& what);

/// What has been kept, in its order; then there is nothing.
std::vector<std::string> take_warnings();

/// Warns of an angle given as a plain number beyond a full circle: degrees, most likely.
void warn_of_degrees(const std::string& where, const std::string& name, double radians);

} // namespace brdfplot
