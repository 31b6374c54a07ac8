/// \file
/// What can go wrong, by the exit code it leads to. The message of each is one line.
#pragma once

#include <stdexcept>
#include <string>

namespace brdfplot {

/// Base of every error that a user sees as `brdfplot: error: WHERE: WHAT`.
class Error : public std::runtime_error {
public:
  Error(int exit_code, const std::string& where, const std::string& what)
      : std::runtime_error(where.empty() ? what : where + ": " + what), code_(exit_code) {}
  int exit_code() const { return code_; }

private:
  int code_;
};

/// Bad usage or bad input: a wrong key, type, value or row.
class InputError : public Error {
public:
  InputError(const std::string& where, const std::string& what) : Error(2, where, what) {}
};

/// A file that could not be read or written.
class FileError : public Error {
public:
  FileError(const std::string& where, const std::string& what) : Error(3, where, what) {}
};

/// Nobody reads standard output any more: who reads a part of it, as head does, has what he wanted.
class ClosedPipe : public FileError {
public:
  using FileError::FileError;
};

/// A number that could not be computed to the accuracy asked; the message gives the estimate reached.
class AccuracyError : public Error {
public:
  AccuracyError(const std::string& where, const std::string& what) : Error(4, where, what) {}
};

/// The user pressed Ctrl-C.
class Interrupted : public Error {
public:
  Interrupted() : Error(130, "", "interrupted") {}
};

} // namespace brdfplot
