#pragma once

#include <functional>
#include <memory>
#include <string>

#include "scene/volume_order.h"

#include "core/thread_pool.h"

namespace bodkin::scene {

class CardVolume;

// Draws a volume by the graphics card or by the processor, as an order wishes and the machine can. Colours of the
// tissues are drawn by the processor in any case: VTK's mapper takes colours by value alone. One thread.
class VolumePainter {
 public:
  // `threads`: that draw on the processor; 0: as many as the machine has cores.
  VolumePainter(std::shared_ptr<const imaging::PreparedVolume> volume, int threads);
  ~VolumePainter();
  VolumePainter(const VolumePainter&) = delete;
  VolumePainter& operator=(const VolumePainter&) = delete;

  // False if it was cancelled; the graphics card is not.
  bool draw(const VolumeOrder& order, const std::function<bool()>& cancelled, VolumeResult& result);

  // The graphics card's name; empty before one has drawn.
  const std::string& card() const { return card_name_; }
  // Why the graphics card that was wished for last does not draw, one sentence; empty if it does.
  const std::string& refusal() const { return refusal_; }

 private:
  bool takes_card(VolumeDrawer wished);
  void make_caster(const VolumeOrder& order);

  std::shared_ptr<const imaging::PreparedVolume> volume_;
  ThreadPool pool_;
  std::unique_ptr<CardVolume> card_;
  std::shared_ptr<const imaging::RayCaster> caster_;
  VolumeDrawer tried_for_ = VolumeDrawer::processor;  // processor: no card was asked for yet
  std::string card_name_, refusal_;
};

}  // namespace bodkin::scene
