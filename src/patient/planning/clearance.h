#pragma once

#include <string>
#include <vector>

#include "patient/planning/obstacles.h"

#include "anatomy/needle_path.h"

namespace bodkin::patient {

// The distance of a path from one kind of obstacle.
struct Clearance {
  std::size_t kind = 0;         // position in Obstacles::kinds
  double distance = 0.0;        // mm; 0: the path enters it
  Vec3 nearest = Vec3::Zero();  // LPS mm, the middle of the nearest voxel
};

// The least distance from the segment between entry and target to every kind within `reach` mm: to the centres of its
// voxels, less half of the smallest voxel spacing; 0 if a point of the segment lies in one of its voxels. Exact:
// every voxel that can be nearer is examined. 0.1 to 0.3 ms for 100 mm and a reach of 10 mm. In order of kinds.
std::vector<Clearance> clearances(const Obstacles& obstacles, const anatomy::NeedlePath& path, double reach);

// The room along a path in brief, for maps and for ranking.
struct Room {
  bool blocked = false;    // it enters an obstacle
  double clearance = 0.0;  // mm to the nearest obstacle, at most the requested reach
  double spare = 0.0;      // mm, least of distance less margin; below 0: a margin is violated
  std::size_t kind = 0;    // the obstacle with the least spare; meaningful if one is near
};
Room clearance_along(const Obstacles& obstacles, const anatomy::NeedlePath& path, double most);

// A tissue on the path, mm from the entry.
struct Crossed {
  anatomy::TissueId tissue = anatomy::tissue::air;
  double from = 0.0, to = 0.0;
};

// The properties of a path for a person.
struct PathReport {
  anatomy::NeedlePath path;
  std::vector<Clearance> near;  // within 30 mm, the least room first
  Room room;
  double cranial = 0.0;          // degrees, the needle points towards the head
  double lateral = 0.0;          // degrees, the needle points towards the patient's left
  std::vector<Crossed> crosses;  // in order; without air and layers thinner than 0.3 mm
  std::vector<Crossed> blocked;  // sections inside obstacles, with their tissue
};
PathReport report_on(const PatientView& patient, const Obstacles& obstacles, const anatomy::NeedlePath& path);

// "nearest: kidney left 6.2 mm, bone 8.0 mm", at most `most` of them; "nothing to avoid within 30 mm".
std::string nearest_text(const Obstacles& obstacles, const PathReport& report, std::size_t most);

}  // namespace bodkin::patient
