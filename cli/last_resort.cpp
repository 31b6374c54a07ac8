#include "last_resort.hpp"

#include "command.hpp"
#include "terminal.hpp"

#include <exception>
#include <new>

#include <unistd.h>

namespace brdfplot::cli {

namespace {

std::terminate_handler standard = nullptr;

/// Whether this thread was refused memory.
thread_local bool refused = false;

[[noreturn]] void refuse() {
  refused = true;
  throw std::bad_alloc();
}

/// std::terminate is called where a library says noexcept and then asks for memory (CLI11 does while its constants are
/// made, before main; oneTBB and Embree in their threads; the destructor of nlohmann-json's arrays). It is an error all
/// the same, not a crash. GCC does not always say which exception it was.
[[noreturn]] void end_without_memory() {
  try {
    if (const auto failure = std::current_exception()) std::rethrow_exception(failure);
    if (refused) throw std::bad_alloc();
  } catch (const std::bad_alloc&) {
    print_error(Settings{}, no_memory);
    _exit(no_memory_code);
  } catch (...) { // NOLINT(bugprone-empty-catch): a fault of the program, of which the standard handler tells
  }
  standard();
  _exit(2);
}

/// Before every other constant of the program is made.
struct LastResort {
  LastResort() {
    standard = std::set_terminate(end_without_memory);
    std::set_new_handler(refuse);
  }
};
[[gnu::init_priority(101)]] const LastResort last_resort;

} // namespace

} // namespace brdfplot::cli
