#include "fem/solid/contact_stream.h"

#include <algorithm>
#include <exception>
#include <span>
#include <utility>
#include <vector>

namespace bodkin::fem {

ContactStream::ContactStream(std::shared_ptr<const ContactBody> body, std::shared_ptr<const anatomy::Case> patient,
                             const ContactStreamSettings& settings, std::shared_ptr<ContactLine> line)
    : body_(std::move(body)),
      patient_(std::move(patient)),
      settings_(settings),
      line_(std::move(line)),
      thread_([this] { serve(); }) {}

ContactStream::~ContactStream() {
  line_->close();
  thread_.join();
}

void ContactStream::serve() {
  while (const std::optional<ContactLine::Line> line = line_->next_line()) {
    try {
      compute(*line);
    } catch (const std::exception&) {
      // No memory for a patch of the mesh: the needle goes on in the points that there are.
    }
    line_->complete(*line);
  }
}

void ContactStream::compute(const ContactLine::Line& line) {
  const anatomy::NeedlePath path{line.entry, line.entry + settings_.length * line.direction};
  const std::vector<NeedleStation> stations = stations_along(path, settings_.length, settings_.spacing, *patient_);
  const std::span<const std::uint32_t> held(line.held.data(), line.held_count);
  if (!bound_ || !std::equal(held.begin(), held.end(), held_.begin(), held_.end())) {
    bound_ = body_->bind(settings_.left, held);
    held_.assign(held.begin(), held.end());
  }
  body_->stream(
      stations, line.direction, settings_.tip_radius,
      [&](const ContactPoint& point) { return line_->append(line, point); }, *bound_);
}

}  // namespace bodkin::fem
