#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "patient/planning/path_search.h"
#include "views/clearance_colour.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// A path proposed by the planner.
struct ProposedPath {
  std::string way;  // "L3/L4, in the midline", "from behind on the left"
  patient::PathReport report;
  std::string nearest;  // the nearest structure, "bone"; empty: none is near
};

// The suitability of a skin point as an entry.
struct EntrySuitability {
  enum class Kind : std::uint8_t { unknown, out_of_reach, blocked, open };
  Kind kind = Kind::unknown;
  // mm to the nearest obstacle on the path to 10 mm before the target, at most map_top; for open entries.
  float clearance = 0.0F;
};

// The slow computations for one target, on separate threads: the obstacles on the path, the suitability of each skin
// point as an entry, the proposed paths. Results appear in result() one by one. Calls from one thread.
class PlanWork {
 public:
  struct Request {
    std::shared_ptr<const OpenCase> patient;
    patient::PlanningRules rules;
    Vec3 target = Vec3::Zero();  // LPS mm
    Vec3 around = Vec3::Zero();  // the map is computed outwards from the entries nearest to this point
    // Points of the skin, LPS mm, shared with the surface that holds them; null: no map.
    std::shared_ptr<const std::vector<Eigen::Vector3f>> skin;
  };
  struct Result {
    std::shared_ptr<const patient::Obstacles> obstacles;  // null: not yet
    std::vector<EntrySuitability> map;                    // of the points of the skin
    std::vector<ProposedPath> proposals;
    std::string why_none;  // why there are none, a sentence
    std::string failure;   // cause of a failure, a sentence
    bool map_done = false, proposals_done = false;
    int version = 0;  // increases with every change
  };

  explicit PlanWork(Request request);
  // Cancels; returns within some milliseconds.
  ~PlanWork();
  PlanWork(const PlanWork&) = delete;
  PlanWork& operator=(const PlanWork&) = delete;

  // The newest state, if newer than `version`.
  bool poll(int version, Result& result) const;

 private:
  void make_map(const std::stop_token& stop, const patient::Obstacles& obstacles);
  void make_proposals(const std::stop_token& stop, const std::shared_ptr<const patient::Obstacles>& obstacles);

  Request request_;
  patient::PathCriteria criteria_;
  mutable std::mutex mutex_;
  Result result_;
  std::jthread searching_, mapping_;
};

// The suitability of a skin point as an entry to `target`.
EntrySuitability entry_suitability(const patient::PatientView& patient, const patient::Obstacles& obstacles,
                                   const Vec3& skin, const Vec3& target, const patient::PathCriteria& criteria);

// 0xAARRGGBB, overlay colour of the skin: grey where unknown, transparent where no needle reaches.
std::uint32_t tint_of(const EntrySuitability& room);

}  // namespace bodkin::app
