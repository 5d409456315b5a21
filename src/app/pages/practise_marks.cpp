// What is drawn into the pictures of the practise page: the probe that is held, and what a person has measured.
#include "app/models/kept_measures.h"
#include "app/models/probe_outline.h"
#include "app/pages/practise.h"

#include "core/error.h"

namespace bodkin::app {

using namespace views;

void PractisePage::take_measures(const std::filesystem::path& folder) {
  measured_in_ = folder;
  if (!folder.empty()) measures_->set(kept_measures(folder));
}

void PractisePage::save_measures() {
  if (measured_in_.empty() || measures_->waiting()) return;
  try {
    keep_measures(measures_->all(), measured_in_);
  } catch (const SystemError& error) {
    emit said(QString::fromStdString(error.what()));
  }
}

// Probe and picture among the body, needle and plan in 3-D; in the slices the picture's border alone.
void PractisePage::show_probe(const Frame& frame) {
  const bool is_seen = probe_.has_value() && frame.ultrasound != nullptr && frame.ultrasound->number > 0;
  if (!is_seen && outlined_) {
    outlined_.reset();
    view3d_->set_trails({});
    for (SliceView* slice : slices_) slice->set_trails({});
  }
  if (!is_seen) return;
  const station::ScanOrder& order = frame.ultrasound->order;
  if (outlined_ && outlined_->first.matrix() == order.probe.matrix() && outlined_->second == order.settings.depth)
    return;
  outlined_.emplace(order.probe, order.settings.depth);
  auto lines = std::make_shared<std::vector<scene::Trail>>(probe_outline(*probe_, order.settings.depth, order.probe));
  const auto border = std::make_shared<std::vector<scene::Trail>>(lines->begin(), lines->begin() + 1);
  view3d_->set_trails(std::move(lines));
  for (SliceView* slice : slices_) slice->set_trails(border);
}

}  // namespace bodkin::app
