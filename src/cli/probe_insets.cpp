#include "cli/probe_insets.h"

#include <utility>

#include "station/probe_contact.h"
#include <fmt/format.h>

#include "imaging/canvas.h"
#include "imaging/ultrasound/ultrasound.h"
#include "io/probe_library_file.h"

namespace bodkin::cli {

namespace {

station::UltrasoundChoice usual_choice() {
  station::UltrasoundChoice made;
  made.probe = io::find_probe("C5-2");
  made.settings.depth = 90.0;  // mm
  return made;
}

void frame_and_name(imaging::Canvas& canvas, double x, double y, double width, double height,
                    const std::string& words) {
  canvas.stroke(imaging::Path::rectangle(x, y, width, height), {imaging::Ink(0xFFFFFF, 0.8), 1.0});
  canvas.text({x + 8.0, y + 18.0}, words, {.size = 13.0, .ink = 0xFFFFFF, .halo = true});
}

}  // namespace

ProbeInsets::ProbeInsets(const anatomy::Case& patient, const std::filesystem::path& folder,
                         const std::function<void(const std::string&)>& note)
    : patient_(patient), scan_(patient, folder, usual_choice(), note) {}

std::shared_ptr<const imaging::TissueDisplacement> ProbeInsets::press(const std::optional<Pose>& probe, double time) {
  held_.reset();
  if (probe) held_ = station::probe_in_hand(*probe);
  scan_.advance(held_, last_ ? time - *last_ : 0.0);
  last_ = time;
  return scan_.moved_tissue();
}

void ProbeInsets::draw(imaging::ImageRgb& picture, const std::optional<Pose>& needle) {
  if (!held_) return;
  std::optional<imaging::NeedleInUltrasound> in_sound;
  if (needle) in_sound = imaging::NeedleInUltrasound{*needle, patient_.description.needle};
  const imaging::UltrasoundFrame& frame = scan_.image(*held_, in_sound);
  imaging::ImageRgb grey(frame.width, frame.height);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i)
    grey.pixels[i] = {frame.pixels[i], frame.pixels[i], frame.pixels[i]};
  const std::string words =
      frame.why != imaging::NoImage::none ? std::string(reason(frame.why))
      : scan_.force() > 0.05 ? fmt::format("ultrasound, {:.1f} N, moved {:.0f} mm", scan_.force(), scan_.most_moved())
      : frame.press > 0.5    ? fmt::format("ultrasound, pressed {:.0f} mm", frame.press)
                             : "ultrasound";
  imaging::Canvas canvas(picture.width, picture.height);
  const double height = 0.4 * picture.height, width = height * frame.width / frame.height;
  const double x = picture.width - width - 12.0, y = 12.0;
  canvas.image(std::move(grey), x, y, width, height);
  frame_and_name(canvas, x, y, width, height, words);

  imaging::ImageRgb ct = scan_.slice(*held_);
  const double ct_height = 0.3 * picture.height, ct_width = ct_height * ct.width / ct.height;
  const double ct_x = 12.0, ct_y = picture.height - ct_height - 12.0;
  canvas.image(std::move(ct), ct_x, ct_y, ct_width, ct_height);
  frame_and_name(canvas, ct_x, ct_y, ct_width, ct_height, "CT where the probe points");
  canvas.draw_over(picture);
}

}  // namespace bodkin::cli
