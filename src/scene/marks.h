#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "scene/camera.h"
#include "scene/moving_pixels.h"

#include "anatomy/needle_path.h"

namespace bodkin::scene {

// The path of a tip, LPS mm, in one colour.
struct Trail {
  std::vector<Vec3> points;
  std::uint32_t colour = 0xFFFFFF;  // 0xRRGGBB
  double width = 2.5;               // pixels
};

// Markings in addition to patient and needles.
struct SceneMarks {
  std::optional<anatomy::NeedlePath> path;  // planned: a dashed line, a ring at the target, one at the entry
  // Forbidden sections of the path, mm from its entry: drawn broken, in red.
  std::vector<std::pair<double, double>> broken;
  double target_tolerance = 3.0;  // mm, radius of the ring at the target
  bool path_shown = true;         // the aid can be switched off
  // "Insert here": the ring on the skin, phase 0 to 1 of its pulse; empty: not shown.
  std::optional<double> insert_here;
  Vec3 entry_normal = Vec3::UnitY();                 // unit, of the skin there, outwards
  std::vector<anatomy::NeedlePath> other_paths;      // fainter: proposals, earlier attempts
  std::uint32_t colour = 0x2EE6C5;                   // 0xRRGGBB, of plan and target
  std::shared_ptr<const std::vector<Trail>> trails;  // of finished sessions; null: none
};

// Whether they look alike.
bool same_marks(const SceneMarks& a, const SceneMarks& b);

void draw_marks(const SceneMarks& marks, const Projection& projection, MovingPixels& pixels);

}  // namespace bodkin::scene
