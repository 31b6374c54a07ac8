/// \file
/// Whether there is memory for what is about to be made.
#pragma once

#include <string>

namespace brdfplot {

/// Bytes that the system can give without swapping; infinity where it does not say.
double available_memory();

/// Asks before anything large is made: the system would grant it and end the program later. `what` is what takes about
/// so many bytes. \throws FileError
void require_memory(double bytes, const std::string& what);

} // namespace brdfplot
