#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace bodkin::haptics {

// A library that could not be loaded, or that lacks a required function.
class LibraryError : public SystemError {
 public:
  LibraryError(bool absent, const std::string& message) : SystemError(message), absent_(absent) {}

  // True: the library does not exist here. False: it exists, and is not suitable.
  bool absent() const noexcept { return absent_; }

 private:
  bool absent_;
};

// Where to look for a vendor's library.
struct LibraryPlaces {
  std::string product;              // "OpenHaptics", for messages
  std::string chosen;               // by the user: the only place unless empty
  std::vector<std::string> places;  // in this order; see below
  std::string advice;               // "install OpenHaptics 3.4 or newer", ends every message
  bool share_symbols = false;       // when symbols are missing, try again with the library's symbols shared
};

// A library loaded at run time. A place is a bare name ("libHD.so", found as the system finds libraries) or an
// absolute path, which may begin with an environment variable ("$OH_SDK_BASE/lib/libHD.so"; skipped unless it is set
// to an absolute path) and may end in ".*" for the newest version in that folder. The working folder is never
// searched.
//
// The library stays loaded for the life of the process, because vendors' libraries start threads and register exit
// handlers; copies of this object refer to the same library.
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

  // Unloads the library. Only for one of which no threads or pointers are in use.
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
