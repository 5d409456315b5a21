#include "scene/volume_painter.h"

#include <chrono>
#include <utility>

#include "scene/graphics_card/card_volume.h"
#include "scene/graphics_card/opengl_context.h"

#include "core/error.h"

namespace bodkin::scene {

std::string_view name_of(VolumeDrawer drawer) {
  constexpr std::array<std::string_view, 3> names = {"automatic", "card", "processor"};
  return names[static_cast<std::size_t>(drawer)];
}

imaging::VolumeCamera volume_camera(const Projection& projection) {
  imaging::VolumeCamera camera;
  const Mat3& axes = projection.axes();
  camera.eye = projection.camera().eye;
  camera.width = projection.width();
  camera.height = projection.height();
  camera.right = axes.col(0) / projection.focal_length();
  camera.down = axes.col(1) / projection.focal_length();
  camera.first = axes.col(2) + (0.5 - 0.5 * camera.width) * camera.right + (0.5 - 0.5 * camera.height) * camera.down;
  return camera;
}

VolumePainter::VolumePainter(std::shared_ptr<const imaging::PreparedVolume> volume, int threads)
    : volume_(std::move(volume)), pool_(threads) {}

VolumePainter::~VolumePainter() = default;

// The card is tried once per setting: a failure would recur, and takes some tenths of a second.
bool VolumePainter::takes_card(VolumeDrawer requested) {
  if (requested == VolumeDrawer::processor) {
    refusal_.clear();
    return false;
  }
  if (requested == tried_for_) return card_ != nullptr;
  tried_for_ = requested;
  refusal_.clear();
  const bool software_too = requested == VolumeDrawer::card;
  if (card_ && (software_too || is_graphics_card(card_->renderer()))) return true;
  card_.reset();
  card_name_.clear();
  try {
    card_ = std::make_unique<CardVolume>(volume_, software_too);
    card_name_ = card_->renderer();
  } catch (const SystemError& failure) {
    refusal_ = failure.what();
  }
  return card_ != nullptr;
}

void VolumePainter::make_caster(const VolumeRequest& request) {
  const double step = imaging::step_of(*volume_, request.voxels);
  if (caster_ && caster_->step() == step && caster_->look() == request.look) return;
  caster_ = std::make_shared<const imaging::RayCaster>(volume_, request.look, step);
}

bool VolumePainter::draw(const VolumeRequest& request, const std::function<bool()>& cancelled, VolumeResult& result) {
  const auto begin = std::chrono::steady_clock::now();
  result.request = request;
  result.by_card = false;
  make_caster(request);
  result.caster = caster_;
  const imaging::VolumeCamera camera = volume_camera(Projection(request.camera, request.width, request.height));
  const bool by_tissue = request.look.mode == imaging::VolumeMode::colour && request.look.tissue_colours;
  bool finished = true;
  if (takes_card(request.drawer) && !by_tissue) {
    try {
      card_->draw(camera, request.look, caster_->step(), result.pixels);
      result.by_card = true;
    } catch (const SystemError& failure) {
      refusal_ = failure.what();
      card_.reset();
      card_name_.clear();
    }
  }
  if (!result.by_card) finished = caster_->draw(camera, pool_, result.pixels, cancelled);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return finished;
}

}  // namespace bodkin::scene
