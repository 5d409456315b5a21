#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scene/marks.h"
#include "scene/needle_actor.h"
#include "scene/picture.h"
#include "scene/volume_job.h"

namespace bodkin::scene {

// An image of a VolumeJob, scaled to the size of a view, with needles and marks in it at their depth: the volume in
// front of a needle attenuates its light, pixel by pixel. While the volume does not change, only the pixels of
// needles and marks take time.
class VolumePicture {
 public:
  void set_size(int width, int height);  // pixels
  void set_base(std::shared_ptr<const VolumeResult> base);
  const std::shared_ptr<const VolumeResult>& base() const { return base_; }

  // The image with these overlays; nothing is drawn before there is a base.
  void draw(const std::vector<NeedleLook>& needles, const SceneMarks& marks);
  const Picture& picture() const { return picture_; }
  // Of the camera from which the image was drawn.
  Projection projection() const { return {base_->request.camera, picture_.width, picture_.height}; }

 private:
  void scale_base();
  std::uint32_t mixed(const Projection& projection, int x, int y, const MovingPixels::Fragment& fragment) const;

  std::shared_ptr<const VolumeResult> base_;
  Picture still_, picture_;
  std::optional<MovingPixels> moving_;
};

}  // namespace bodkin::scene
