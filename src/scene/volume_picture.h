#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scene/marks.h"
#include "scene/needle_actor.h"
#include "scene/picture.h"
#include "scene/volume_job.h"

namespace bodkin::scene {

// A picture of a VolumeJob, brought to the size of a view, with needles and marks in it at their depth: what lies
// before a needle takes its light from it, pixel by pixel. Only the pixels of needles and marks cost time while the
// volume stays as it is.
class VolumePicture {
 public:
  void set_size(int width, int height);  // pixels
  void set_base(std::shared_ptr<const VolumeResult> base);
  const std::shared_ptr<const VolumeResult>& base() const { return base_; }

  // The picture with these over it; nothing is drawn before there is a base.
  void draw(const std::vector<NeedleLook>& needles, const SceneMarks& marks);
  const Picture& picture() const { return picture_; }
  // Of the camera that the picture was drawn from.
  Projection projection() const { return {base_->order.camera, picture_.width, picture_.height}; }

 private:
  void scale_base();
  std::uint32_t mixed(const Projection& projection, int x, int y, const MovingPixels::Fragment& fragment) const;

  std::shared_ptr<const VolumeResult> base_;
  Picture still_, picture_;
  std::optional<MovingPixels> moving_;
};

}  // namespace bodkin::scene
