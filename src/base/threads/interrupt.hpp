/// \file
/// Ctrl-C as an exception: the signal sets a flag, long work looks at it. So destructors run, and remove what is half
/// written.
#pragma once

namespace brdfplot {

/// From now on SIGINT, SIGTERM and SIGHUP set the flag instead of ending the process (SIGHUP: unless it is ignored).
void install_interrupt_handler();

bool interrupted();

/// Takes the flag back, for who answers Ctrl-C by keeping what there is.
void forget_interrupt();

/// \throws Interrupted when the flag is set. Costs one load of memory: cheap enough for every row and integral.
void throw_if_interrupted();

} // namespace brdfplot
