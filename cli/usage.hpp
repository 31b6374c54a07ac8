/// \file
/// What CLI11 says of a wrong command line, in one line that names what is accepted.
#pragma once

#include "base/errors.hpp"

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace brdfplot::cli {

/// `app` is the whole program, parsed as far as it went.
InputError usage_error(const CLI::App& app, const CLI::ParseError& error);

/// No command is given.
InputError no_command(const CLI::App& app);

} // namespace brdfplot::cli
