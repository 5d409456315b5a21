#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "anatomy/case.h"
#include "fem/contact_line.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/line_points.h"

namespace bodkin::fem {

// What the points of a needle's line are like; see EmbeddedNeedleSettings.
struct ContactStreamSettings {
  double length = 100.0;                       // mm, above 0, how deep needles go
  double spacing = 1.0;                        // mm, above 0
  double tip_radius = 1.0;                     // mm, above 0
  std::vector<anatomy::NeedlePath> left = {};  // needles that were left in the body, from entry to tip
};

// Computes the contact points of every line that is asked for (ContactLine) on a thread of its own: the first one
// alone, since the needle touches it already, then more and more at once. Those of the planned line are the patient's
// (Case::corridor).
class ContactStream {
 public:
  // `patient`: its tissues and its library. Starts the thread.
  ContactStream(std::shared_ptr<const ContactBody> body, std::shared_ptr<const anatomy::Case> patient,
                const ContactStreamSettings& settings, std::shared_ptr<ContactLine> line);
  // Closes the line, and waits for the points that are being computed.
  ~ContactStream();
  ContactStream(const ContactStream&) = delete;
  ContactStream& operator=(const ContactStream&) = delete;

 private:
  void serve();
  void find_points(const ContactLine::Line& line);
  void compute(const ContactLine::Line& line);
  void couple(const ContactLine::Line& line);

  std::shared_ptr<const ContactBody> body_;
  std::shared_ptr<const anatomy::Case> patient_;
  ContactStreamSettings settings_;
  std::shared_ptr<ContactLine> line_;
  std::optional<BoundPoints> bound_;  // by `held_`; of the thread
  std::vector<std::uint32_t> held_;
  std::optional<LinePoints> points_;  // of the newest line; of the thread
  Vec3 begin_ = Vec3::Zero();         // mm, LPS, where that line touches the body
  std::thread thread_;                // the last member: it uses the others
};

}  // namespace bodkin::fem
