// Overlays of the practice page: the probe, and the user's measurements.
#include "app/models/probe_outline.h"
#include "app/models/stored_measures.h"
#include "app/pages/practise.h"

#include "core/error.h"

namespace bodkin::app {

using namespace views;

void PractisePage::take_measures(const std::filesystem::path& folder) {
  measured_in_ = folder;
  if (!folder.empty()) measures_->set(stored_measures(folder));
}

void PractisePage::save_measures() {
  if (measured_in_.empty() || measures_->waiting()) return;
  try {
    store_measures(measures_->all(), measured_in_);
  } catch (const SystemError& error) {
    emit message_requested(QString::fromStdString(error.what()));
  }
}

// The probe and its image with body, needle and plan in 3-D; in the slices only the border of the image.
void PractisePage::show_probe(const Frame& frame) {
  const bool is_seen = probe_.has_value() && frame.ultrasound != nullptr && frame.ultrasound->number > 0;
  if (!is_seen && outlined_) {
    outlined_.reset();
    view3d_->set_trails({});
    for (SliceView* slice : slices_) slice->set_trails({});
  }
  if (!is_seen) return;
  const station::ScanSetup& setup = frame.ultrasound->setup;
  if (outlined_ && outlined_->first.matrix() == setup.probe.matrix() && outlined_->second == setup.settings.depth)
    return;
  outlined_.emplace(setup.probe, setup.settings.depth);
  auto lines = std::make_shared<std::vector<scene::Trail>>(probe_outline(*probe_, setup.settings.depth, setup.probe));
  const auto border = std::make_shared<std::vector<scene::Trail>>(lines->begin(), lines->begin() + 1);
  view3d_->set_trails(std::move(lines));
  for (SliceView* slice : slices_) slice->set_trails(border);
}

}  // namespace bodkin::app
