#pragma once

#include <functional>
#include <memory>
#include <string>

#include "scene/volume_request.h"

#include "core/thread_pool.h"

namespace bodkin::scene {

class CardVolume;

// Draws a volume by the graphics card or by the processor, depending on the request and the machine. Colours of the
// tissues are always drawn by the processor: VTK's mapper only uses colours by value. One thread.
class VolumePainter {
 public:
  // `threads`: for drawing on the processor; 0: one per core.
  VolumePainter(std::shared_ptr<const imaging::PreparedVolume> volume, int threads);
  ~VolumePainter();
  VolumePainter(const VolumePainter&) = delete;
  VolumePainter& operator=(const VolumePainter&) = delete;

  // False if it was cancelled; the graphics card cannot be cancelled.
  bool draw(const VolumeRequest& request, const std::function<bool()>& cancelled, VolumeResult& result);

  // The graphics card's name; empty before one has drawn.
  const std::string& card() const { return card_name_; }
  // Why the last requested graphics card does not draw, one sentence; empty if it does.
  const std::string& refusal() const { return refusal_; }

 private:
  bool takes_card(VolumeDrawer requested);
  void make_caster(const VolumeRequest& request);

  std::shared_ptr<const imaging::PreparedVolume> volume_;
  ThreadPool pool_;
  std::unique_ptr<CardVolume> card_;
  std::shared_ptr<const imaging::RayCaster> caster_;
  VolumeDrawer tried_for_ = VolumeDrawer::processor;  // processor: no card was requested yet
  std::string card_name_, refusal_;
};

}  // namespace bodkin::scene
