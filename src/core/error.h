#pragma once

#include <stdexcept>
#include <string>

namespace bodkin {

// The user's input is wrong: a file, a value, a path that misses the body. The message is one sentence that names the
// file (and line or field), what was found, what was expected and how to correct it. Programs end with exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The environment failed: the disk is full, a library is missing, a child process died. Exit code 1.
class SystemError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace bodkin
