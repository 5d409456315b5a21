#include "imaging/ultrasound/frame.h"

namespace bodkin::imaging {

std::string_view reason(NoImage why) {
  switch (why) {
    case NoImage::none:
      return "";
    case NoImage::outside_volume:
      return "The probe is outside the volume that the CT shows; move it to the patient's skin.";
    case NoImage::no_contact:
      return "The probe does not touch the skin; press it on, or use gel.";
    case NoImage::inside_body:
      return "The probe's face is inside the body; pull it back to the skin.";
    case NoImage::broken_pose:
      return "The probe's pose is not a rigid placement of finite numbers; check where it comes from.";
  }
  return "The reason is unknown.";
}

}  // namespace bodkin::imaging
