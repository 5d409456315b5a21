#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/look.h"

namespace bodkin::scene {

// A look that was saved with a case, perhaps with the direction that the patient is seen from.
struct NamedLook {
  std::string name;  // 1 to 100 characters
  Look look;
  std::optional<Camera> camera;
};

struct CaseLooks {
  std::string opens_with;  // the name of the look that the case opens with; empty: none
  std::vector<NamedLook> looks;

  const NamedLook* find(std::string_view name) const;
};

// looks.xml in a case's folder (docs/case-format.md). None where there is no such file. Throws InputError with file,
// line and what is wrong.
CaseLooks read_looks(const std::filesystem::path& folder);
// Throws SystemError where the folder cannot be written.
void write_looks(const CaseLooks& looks, const std::filesystem::path& folder);

}  // namespace bodkin::scene
