#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace bodkin::haptics {

// A library that could not be loaded, or that lacks what was expected of it.
class LibraryError : public SystemError {
 public:
  LibraryError(bool absent, const std::string& message) : SystemError(message), absent_(absent) {}

  // True: there is no such library here. False: there is one, and it does not fit.
  bool absent() const noexcept { return absent_; }

 private:
  bool absent_;
};

// Where a vendor's library may be.
struct LibraryPlaces {
  std::string product;              // "OpenHaptics", for messages
  std::string chosen;               // by the user: the only place when not empty
  std::vector<std::string> places;  // in this order; see below
  std::string advice;               // "install OpenHaptics 3.4 or newer", ends every message
  bool share_symbols = false;       // when symbols are missing, try again with the library's symbols shared
};

// A library loaded at run time. A place is a bare name ("libHD.so", found as the system finds libraries) or an
// absolute path, which may begin with an environment variable ("$OH_SDK_BASE/lib/libHD.so"; left out where it is not
// set to an absolute path) and may end in ".*" for the newest version in that folder. Nothing is looked for in the
// working folder.
//
// The library stays loaded for the life of the process, for vendors' libraries start threads and register exit
// handlers; copies of this object refer to the same one.
class DriverLibrary {
 public:
  // Throws LibraryError.
  explicit DriverLibrary(const LibraryPlaces& places);

  // The file that was loaded.
  const std::string& path() const noexcept { return path_; }

  // The function of that name. Throws LibraryError naming the symbol and the library.
  template <typename Function>
  void need(Function*& function, const char* symbol) const {
    function = reinterpret_cast<Function*>(needed(symbol));
  }
  // Null when the library lacks it.
  template <typename Function>
  void take(Function*& function, const char* symbol) const noexcept {
    function = reinterpret_cast<Function*>(find(symbol));
  }

  // Unloads the library. Only for one that has neither threads nor pointers in use any more.
  void unload() noexcept;

 private:
  void* find(const char* symbol) const noexcept;
  void* needed(const char* symbol) const;

  void* handle_ = nullptr;
  std::string path_;
  std::string product_;
  std::string advice_;
};

}  // namespace bodkin::haptics
