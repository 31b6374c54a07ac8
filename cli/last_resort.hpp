/// \file
/// What is said when there is no memory left, also where no exception can be caught.
#pragma once

namespace brdfplot::cli {

inline constexpr const char* no_memory = "memory: there is not enough";
inline constexpr int no_memory_code = 3;

} // namespace brdfplot::cli
