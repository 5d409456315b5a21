#include "haptics/driver_library.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>

#include <dlfcn.h>
#include <link.h>

namespace bodkin::haptics {

namespace {

namespace fs = std::filesystem;

// Places where the variable is unset, relative or empty do not exist.
std::optional<std::string> expanded(const std::string& place) {
  if (place.empty() || place.front() != '$') return place;
  const std::size_t slash = place.find('/');
  const char* value = std::getenv(place.substr(1, slash - 1).c_str());
  if (value == nullptr || *value != '/') return std::nullopt;
  return value + (slash == std::string::npos ? std::string() : place.substr(slash));
}

// "libdrd.so.*": the file of that folder with the greatest version; the pattern itself when no file matches.
std::string newest(const std::string& place) {
  if (!place.ends_with(".*")) return place;
  const fs::path pattern = place.substr(0, place.size() - 1);
  const std::string prefix = pattern.filename();
  fs::path best;
  std::error_code trouble;
  for (const auto& entry : fs::directory_iterator(pattern.parent_path(), trouble)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(prefix)) continue;
    if (best.empty() || strverscmp(name.c_str(), best.filename().c_str()) > 0) best = entry.path();
  }
  return best.empty() ? place : best.string();
}

std::string last_error() {
  const char* text = dlerror();
  return text == nullptr ? "unknown error" : text;
}

std::string file_of(void* handle, const std::string& otherwise) {
  const link_map* map = nullptr;
  if (dlinfo(handle, RTLD_DI_LINKMAP, static_cast<void*>(&map)) != 0 || map == nullptr) return otherwise;
  return *map->l_name == '\0' ? otherwise : map->l_name;
}

}  // namespace

DriverLibrary::DriverLibrary(const LibraryPlaces& places) : product_(places.product), advice_(places.advice) {
  std::string tried;
  std::string broken;  // the system's message about a library that exists but does not load
  const std::vector<std::string> chosen = {places.chosen};
  for (const std::string& place : places.chosen.empty() ? places.places : chosen) {
    const std::optional<std::string> known = expanded(place);
    if (!known) continue;
    const std::string file = newest(*known);
    handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    std::string error = handle_ == nullptr ? last_error() : "";
    if (handle_ == nullptr && places.share_symbols && error.find("undefined symbol") != std::string::npos) {
      handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
      if (handle_ == nullptr) error = last_error();
    }
    if (handle_ != nullptr) {
      path_ = file_of(handle_, file);
      return;
    }
    tried += (tried.empty() ? "" : ", ") + file;
    // An error about an existing library begins with its own path too, so ask the disk; one found by its bare name
    // complains about another file.
    const bool there = file.find('/') == std::string::npos ? !error.starts_with(file + ":") : fs::exists(file);
    if (broken.empty() && there) broken = std::move(error);
  }
  if (!broken.empty()) {
    throw LibraryError(false, "the library of " + product_ + " does not load (" + broken + "): " + advice_);
  }
  throw LibraryError(true, "the library of " + product_ + " is not here (looked for " + tried + "): " + advice_);
}

void* DriverLibrary::find(const char* symbol) const noexcept {
  return dlsym(handle_, symbol);
}

void* DriverLibrary::needed(const char* symbol) const {
  void* address = find(symbol);
  if (address == nullptr) {
    throw LibraryError(false, path_ + " has no function " + symbol + ", which Bodkin needs: " + advice_);
  }
  return address;
}

void DriverLibrary::unload() noexcept {
  if (handle_ != nullptr) dlclose(handle_);
  handle_ = nullptr;
}

}  // namespace bodkin::haptics
