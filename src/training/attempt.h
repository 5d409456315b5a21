#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "session/session_file.h"

#include "anatomy/case.h"
#include "training/thresholds.h"

namespace bodkin::training {

// An insertion: from the contact with the skin until the needle has left the body. A needle that returns within the
// thresholds outside_s and outside_mm continues the same insertion.
struct Insertion {
  std::size_t first = 0;  // index of the first tick in contact
  std::size_t last = 0;   // of the last one
  double deepest = 0.0;   // mm
};

// A rest of the tip in the body for at least rest_s: the mean of its position over 0.2 s moved by less than
// rest_mm_per_s from the mean over the 0.2 s before. A tremor of 8 to 12 Hz cancels in these means, so that a
// trembling hand can rest.
struct Rest {
  std::size_t first = 0;  // ticks at which the tip rested
  std::size_t last = 0;
  Vec3 tip = Vec3::Zero();  // mean, LPS mm
  double depth = 0.0;       // mean, mm
};

// The final position of the tip: the deepest rest of the last insertion (the last one of those within same_rest_mm),
// or the insertion's deepest point without a rest. A rest before the skin is punctured is in air and does not count.
struct FinalPosition {
  bool is_rest = false;
  std::size_t tick = 0;     // index: the end of the rest, or the deepest tick
  Vec3 tip = Vec3::Zero();  // LPS mm
  double depth = 0.0;       // mm
  anatomy::TissueId tissue = anatomy::tissue::air;
};

// One recorded attempt in the form needed for metrics: a column per quantity, all of one length. All data come from
// the session, and the description from the case.xml stored in it.
class Attempt {
 public:
  // Throws InputError for a session without ticks. `session` must outlive the object.
  Attempt(const session::Session& session, const anatomy::CaseDescription& description,
          const Thresholds& thresholds = {});

  const session::Session& session() const { return session_; }
  const anatomy::CaseDescription& description() const { return description_; }
  const Thresholds& thresholds() const { return thresholds_; }
  const anatomy::NeedlePath& path() const { return session_.header.path; }
  std::size_t size() const { return time.size(); }
  double dt() const { return session_.header.dt; }

  std::vector<double> time;                // s since the first tick
  std::vector<Vec3> hand;                  // LPS mm, the tip as held by the hand
  std::vector<Vec3> tip;                   // LPS mm, position after expiration of the tissue at the tip
  std::vector<Vec3> axis;                  // unit, hub to tip
  std::vector<double> depth;               // mm along the needle's line
  std::vector<double> resistance;          // N
  std::vector<Vec3> force;                 // N, applied to the hand
  std::vector<anatomy::TissueId> tissue;   // at the tip
  std::vector<char> inside;                // 1: the needle touches the body
  std::vector<Insertion> insertions;       // in order
  std::vector<Rest> rests;                 // in the last insertion, in order
  std::optional<FinalPosition> final_tip;  // none without an insertion
  double missing = 0.0;                    // s of ticks lost while the needle was in the body

  // Index of the first tick in contact; only with an insertion.
  std::size_t first_contact() const { return insertions.front().first; }
  // LPS mm, position at a tick of the tissue that lies at `material` after expiration.
  Vec3 now(const Vec3& material, std::size_t index) const;
  // Index of the tick of an event.
  std::size_t index_of(const session::SessionEvent& event) const;
  // The tissue of that name in the session's own list.
  std::optional<anatomy::TissueId> find_tissue(const std::string& name) const;
  // "ligamentum flavum", or "tissue N" for an id without a name in the session.
  std::string title_of(anatomy::TissueId id) const;

 private:
  void find_insertions();
  void find_rests();
  void find_final_tip();
  anatomy::TissueId tissue_of(const Rest& rest) const;  // the most frequent tissue at the tip

  std::vector<double> drawn_in_;  // 0 to 1; empty: the patient does not breathe
  const session::Session& session_;
  anatomy::CaseDescription description_;
  Thresholds thresholds_;
};

// The description of its case stored in the session. Throws InputError when it cannot be read.
anatomy::CaseDescription description_of(const session::Session& session);

}  // namespace bodkin::training
