#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"

#include "anatomy/case.h"
#include "anatomy/tissue_surface.h"
#include "core/progress.h"

namespace bodkin::scene {

// The role of a part of the patient for the viewer.
enum class SurfaceKind : std::uint8_t {
  skin,
  bone,
  tissue,    // landmarks: discs, ligamentum flavum, the dural sac, a lesion
  forbidden  // a vessel or an organ
};

// Triangles of a surface that belong to one structure of the segmentation.
struct SurfaceSection {
  std::string name;                  // "kidney_right"; the surface's own for triangles without a structure
  std::size_t first = 0, count = 0;  // triangles
};

// The surface of some tissues of a patient.
struct PatientSurface {
  SurfaceKind kind = SurfaceKind::tissue;
  std::string name;                           // in files: "ligamentum_flavum"
  std::uint32_t colour = 0;                   // 0xRRGGBB, lit from everywhere
  SceneMesh mesh;                             // LPS mm
  std::vector<SurfaceSection> sections = {};  // all triangles, one after another; empty: not divided
};

struct PatientSurfaces {
  std::vector<PatientSurface> parts;  // the skin first

  std::size_t triangles() const;
  // Of the skin; does not throw, because parts[0] is always the skin.
  const SceneMesh& skin() const { return parts.front().mesh; }
};

// The plan of a part: its tissues, resolution, and number of triangles.
struct SurfacePlan {
  SurfaceKind kind;
  std::string_view name;
  std::uint32_t colour;  // of light, natural tones: bone is ivory, not the white of a slice's overlay
  anatomy::TissueSet tissues;
  anatomy::TissueSurfaceSettings settings;
  int most_triangles;
};

// The parts searched in every patient; missing ones are left out. At most 60000 triangles in total.
std::vector<SurfacePlan> surface_plans();

// The surfaces of a patient: computed from the tissue map (anatomy::tissue_surface), smoothed by a windowed sinc
// filter of 15 iterations (Taubin et al. 1996), which preserves the volume, decimated by quadric errors, with normals
// and the visible fraction of the sky of each point (openness.h). The same tissues give the same surfaces. Takes
// seconds, for a separate thread; `progress` may throw to cancel. Throws InputError for a patient without any tissue.
PatientSurfaces make_surfaces(const anatomy::TissueVolume& tissues, const Progress& progress = {});

}  // namespace bodkin::scene
