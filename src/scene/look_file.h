#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/look.h"

namespace bodkin::scene {

// A look saved with a case, optionally with its direction of view.
struct NamedLook {
  std::string name;  // 1 to 100 characters
  Look look;
  std::optional<Camera> camera;
};

struct CaseLooks {
  std::string opens_with;  // name of the case's initial look; empty: none
  std::vector<NamedLook> looks;

  const NamedLook* find(std::string_view name) const;
};

// looks.xml in a case's folder (docs/case-format.md). Empty if it does not exist. Throws InputError with file, line
// and error.
CaseLooks read_looks(const std::filesystem::path& folder);
// Throws SystemError where the folder cannot be written.
void write_looks(const CaseLooks& looks, const std::filesystem::path& folder);

}  // namespace bodkin::scene
