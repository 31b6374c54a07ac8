/// \file
/// A loop over independent indices, on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace brdfplot {

/// How many threads the machine runs at once; at least 1.
int hardware_threads();

/// Calls body(0) ... body(n - 1), each once, in ascending order of their start, on up to `threads` threads (this one
/// among them). After an exception no further index is started; when all have ended, the exception of the smallest
/// index is rethrown, which is the same whatever `threads` is. \throws Interrupted when the user pressed Ctrl-C.
void parallel_for(std::size_t n, int threads, const std::function<void(std::size_t)>& body);

/// Runs `work` on up to `threads` threads, this one among them, and waits for all. `work` must not throw.
void run_on_threads(int threads, const std::function<void()>& work);

} // namespace brdfplot
