#include <algorithm>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

std::optional<double> duration(const Measured& measured) {
  return measured.attempt.time.back();
}

std::optional<double> time_in_body(const Measured& measured) {
  return static_cast<double>(std::count(measured.attempt.inside.begin(), measured.attempt.inside.end(), 1)) *
         measured.attempt.dt();
}

std::optional<double> time_to_final_position(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& attempt) {
    return attempt.time[attempt.final_tip->tick] - attempt.time[attempt.first_contact()];
  });
}

std::optional<double> insertions(const Measured& measured) {
  return static_cast<double>(measured.attempt.insertions.size());
}

std::optional<double> redirections(const Measured& measured) {
  return measured.redirections;
}

}  // namespace

std::vector<Metric> metrics_of_time() {
  return {{"duration_s", "s", "duration", "from the first to the last tick", "PerkTutor, Elapsed Time", duration},
          {"time_in_body_s", "s", "time in the body", "ticks in contact times dt", "PerkTutor, Time in Tissue",
           time_in_body},
          {"time_to_final_position_s", "s", "time to the final position",
           "from the first contact to the end of the rest that is the final position", "Kwon et al. 2001, total time",
           time_to_final_position},
          {"insertions", "", "insertions",
           "contacts with the body after the needle was outside for over 0.5 s or by over 5 mm",
           "Kwon et al. 2001, number of trials", insertions},
          {"redirections", "", "redirections",
           "retreats of over 5 mm in the body, then an advance of at least 1 mm with the axis turned by over 3 deg",
           "Bodkin", redirections}};
}

}  // namespace bodkin::training
