#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
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
// (Case::prepared). Where it fails, the needle goes on in the points that there are, and take_failures() says why.
class ContactStream {
 public:
  // `patient`: its tissues and its library. Starts the thread.
  ContactStream(std::shared_ptr<const ContactBody> body, std::shared_ptr<const anatomy::Case> patient,
                const ContactStreamSettings& settings, std::shared_ptr<ContactLine> line);
  // Closes the line, and waits for the points that are being computed.
  ~ContactStream();
  ContactStream(const ContactStream&) = delete;
  ContactStream& operator=(const ContactStream&) = delete;

  // Any thread but the tick's, which must not wait: what could not be computed and why, one sentence each, and each
  // of them once however often it happens.
  std::vector<std::string> take_failures();
  // For programs that go on only with all points. Throws SystemError with the first of take_failures().
  void throw_failure();

 private:
  void serve();
  template <typename Work>
  bool attempt(std::string_view failed, const Work& work) noexcept;
  void add_failure(std::string_view sentence, std::string_view why) noexcept;
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
  std::mutex lock_;                   // of what could not be computed:
  std::vector<std::string> failures_, told_;
  bool failed_without_words_ = false;  // there was no memory for them
  std::thread thread_;                 // the last member: it uses the others
};

}  // namespace bodkin::fem
