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

// A path that the planner proposes.
struct ProposedPath {
  std::string way;  // "L3/L4, in the midline", "from behind on the left"
  patient::PathReport report;
  std::string nearest;  // what it comes closest to, "bone"; empty: nothing is near
};

// How good a point of the skin is as an entry.
struct EntryRoom {
  enum class Kind : std::uint8_t { unknown, out_of_reach, blocked, open };
  Kind kind = Kind::unknown;
  // mm to the nearest thing to avoid on the way to 10 mm before the target, at most map_top; of open ones.
  float clearance = 0.0F;
};

// Everything about one target that takes time, on threads of its own: what the way must avoid, how good each point of
// the skin is as an entry, the paths to propose. What is computed appears in result() piece by piece. One thread
// calls.
class PlanWork {
 public:
  struct Wish {
    std::shared_ptr<const OpenCase> patient;
    patient::PlanningRules rules;
    Vec3 target = Vec3::Zero();  // LPS mm
    Vec3 around = Vec3::Zero();  // the map grows from the entries nearest to this point
    // Points of the skin, LPS mm, shared with the surface that holds them; null: no map.
    std::shared_ptr<const std::vector<Eigen::Vector3f>> skin;
  };
  struct Result {
    std::shared_ptr<const patient::Obstacles> obstacles;  // null: not yet
    std::vector<EntryRoom> map;                           // of the points of the skin
    std::vector<ProposedPath> proposals;
    std::string why_none;  // a sentence, where there are none
    std::string failure;   // what went wrong, a sentence
    bool map_done = false, proposals_done = false;
    int version = 0;  // rises with every change
  };

  explicit PlanWork(Wish wish);
  // Cancels; returns within some milliseconds.
  ~PlanWork();
  PlanWork(const PlanWork&) = delete;
  PlanWork& operator=(const PlanWork&) = delete;

  // The newest state, where it is newer than `version`.
  bool poll(int version, Result& result) const;

 private:
  void make_map(const std::stop_token& stop, const patient::Obstacles& obstacles);
  void make_proposals(const std::stop_token& stop, const std::shared_ptr<const patient::Obstacles>& obstacles);

  Wish wish_;
  patient::PathWishes wishes_;
  mutable std::mutex mutex_;
  Result result_;
  std::jthread searching_, mapping_;
};

// What a point of the skin is as an entry to `target`.
EntryRoom room_from(const patient::PatientView& patient, const patient::Obstacles& obstacles, const Vec3& skin,
                    const Vec3& target, const patient::PathWishes& wishes);

// 0xAARRGGBB to lay over the skin: grey where it is not known, nothing where no needle reaches.
std::uint32_t tint_of(const EntryRoom& room);

}  // namespace bodkin::app
