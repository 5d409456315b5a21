#pragma once

#include <string>
#include <vector>

#include "patient/planning/obstacles.h"

#include "anatomy/needle_path.h"

namespace bodkin::patient {

// How far a path stays from one kind of obstacle.
struct Clearance {
  std::size_t kind = 0;         // position in Obstacles::kinds
  double distance = 0.0;        // mm; 0: the path goes into it
  Vec3 nearest = Vec3::Zero();  // LPS mm, the middle of the nearest voxel
};

// The least distance from the segment between entry and target to every kind that comes within `reach` mm: to the
// centres of its voxels, less half of the smallest voxel spacing; 0 where a point of the segment lies in one of its
// voxels. Exact: every voxel is looked at that can be nearer. 0.1 to 0.3 ms for 100 mm and a reach of 10 mm. In order
// of kinds.
std::vector<Clearance> clearances(const Obstacles& obstacles, const anatomy::NeedlePath& path, double reach);

// What a path leaves in short, for maps and for ranking.
struct Room {
  bool blocked = false;    // it goes into an obstacle
  double clearance = 0.0;  // mm to the nearest obstacle, at most what was asked for
  double spare = 0.0;      // mm, least of distance less margin; below 0: too close to something
  std::size_t kind = 0;    // the obstacle that spares least; meaningful where one is near
};
Room room_along(const Obstacles& obstacles, const anatomy::NeedlePath& path, double most);

// A tissue on the way, mm from the entry.
struct Crossed {
  anatomy::TissueId tissue = anatomy::tissue::air;
  double from = 0.0, to = 0.0;
};

// What a person wants to know of a path.
struct PathReport {
  anatomy::NeedlePath path;
  std::vector<Clearance> near;  // within 30 mm, the least room first
  Room room;
  double cranial = 0.0;          // degrees, the needle points towards the head
  double lateral = 0.0;          // degrees, the needle points towards the patient's left
  std::vector<Crossed> crosses;  // in order; air and what is thinner than 0.3 mm left out
  std::vector<Crossed> blocked;  // stretches inside obstacles, with their tissue
};
PathReport report_on(const PatientView& patient, const Obstacles& obstacles, const anatomy::NeedlePath& path);

// "nearest: kidney left 6.2 mm, bone 8.0 mm", at most `most` of them; "nothing to avoid within 30 mm".
std::string nearest_text(const Obstacles& obstacles, const PathReport& report, std::size_t most);

}  // namespace bodkin::patient
