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

// Properties of the points of a needle's line; see EmbeddedNeedleSettings.
struct ContactStreamSettings {
  double length = 100.0;                       // mm, above 0, largest insertion depth
  double spacing = 1.0;                        // mm, above 0
  double tip_radius = 1.0;                     // mm, above 0
  std::vector<anatomy::NeedlePath> left = {};  // left in the body, from entry to tip
};

// Computes the contact points of every requested line (ContactLine) on its own thread: the first one on its own,
// because the needle touches it already, then in growing groups. Those of the planned line come from the patient
// (Case::prepared). After a failure, the needle continues in the existing points, and take_failures() says why.
class ContactStream {
 public:
  // `patient`: for its tissues and tissue library. Starts the thread.
  ContactStream(std::shared_ptr<const ContactBody> body, std::shared_ptr<const anatomy::Case> patient,
                const ContactStreamSettings& settings, std::shared_ptr<ContactLine> line);
  // Closes the line, and waits for the points that are being computed.
  ~ContactStream();
  ContactStream(const ContactStream&) = delete;
  ContactStream& operator=(const ContactStream&) = delete;

  // Any thread but the tick's, which must not wait: what could not be computed and why, one sentence each, and each
  // only once however often it occurs.
  std::vector<std::string> take_failures();
  // For programs that need all points. Throws SystemError with the first of take_failures().
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
  std::optional<BoundPoints> bound_;  // for `held_`; used by the thread
  std::vector<std::uint32_t> held_;
  std::optional<LinePoints> points_;  // of the newest line; used by the thread
  Vec3 begin_ = Vec3::Zero();         // mm, LPS, where that line touches the body
  std::mutex lock_;                   // guards the record of failures:
  std::vector<std::string> failures_, reported_;
  bool failed_without_words_ = false;  // no memory was left for the sentences
  std::thread thread_;                 // the last member: it uses the others
};

}  // namespace bodkin::fem
