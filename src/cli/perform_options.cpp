#include "cli/perform_options.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "session/left_needles.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/body_options.h"
#include "cli/pane_options.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "io/placement_file.h"

namespace bodkin::cli {

const char* const perform_footer = R"(Examples:
  bodkin perform patient openhaptics                      the first Touch that is connected
  bodkin perform patient spacemouse                       no force at the hand; the force is displayed
  bodkin perform patient mouse                            the mouse, in the window of bodkin-app
  bodkin perform patient simulated                        a simulated hand
  bodkin perform patient recorded:mine.bodkin             the hand of a session
  bodkin perform patient tracked:/dev/video0 --settings "camera=camera.json bodies=bodies.json registration=placed.json"
                                                          a real needle with markers over a mannequin
  bodkin perform patient force_dimension --force-scale 0.5
  bodkin perform patient openhaptics --mannequin placed.json --hub                 a real hub over a mannequin
  bodkin perform patient ./my_driver.so -o mine.bodkin
  bodkin perform patient mouse --ultrasound C5-2 --resistance embedded_needle      with live ultrasound
  bodkin perform patient force_dimension:104 --second openhaptics                  the other hand on the plunger
  bodkin perform patient force_dimension:104 --second force_dimension:105 --second-as probe
  bodkin perform patient simulated --second openhaptics --second-as probe --resistance embedded_needle --body moving

The patient lies prone, the head away from you, the skin below the middle of the workspace. Keys: space holds the
needle where it is and takes it up again; c engages and releases the clutch; a arms after a fault and d disarms, also the
second hand; b presses and releases the plunger of a syringe ('--part syringe'); f feels the skin with a finger and takes the
needle again ('--part fingertip'); s takes the stylet out and puts it back, m connects and removes the manometer ('--part
csf_flow'); q ends the session. The session also ends when the needle has been wholly out of the body for 5 s after the
procedure's aim was reached. Run 'bodkin devices check' first to see whether the device works.)";

void add_perform_options(CLI::App& command, PerformOptions& options) {
  add_text(command, "CASE", options.folder, "Folder of the case").required();
  add_text(command, "DEVICE", options.device.device, "DRIVER or DRIVER:IDENTITY, as 'devices list' prints it")
      .required();
  add_driver_settings(command, options.device);
  add_text(command, "-o,--output", options.output, "Session file");
  add_switch(command, "--overwrite", options.overwrite, "Replace the session file if it exists");
  add_number(command, "--scale", options.scale, 0.1, 10.0, "mm of the needle per mm of the hand, 0.1 to 10");
  add_number(command, "--force-scale", options.force_scale, 0.01, 1.0,
             "N at the hand per N at the needle, for weak devices, 0.01 to 1; recorded, but not part of the score");
  add_text(command, "--mannequin", options.mannequin,
           "Registration of the device to a mannequin ('devices touch', 'register'), in which the patient then lies");
  add_switch(command, "--hub", options.at_hub,
             "With --mannequin: the device holds a needle's hub; the tip is the needle's length in front of it");
  add_switch(command, "--no-calibration", options.no_calibration,
             "Ignore the calibration that 'devices calibrate' saved for this device");
  add_switch(command, "--allow-late", options.allow_late,
             "Allow the full force without real-time priority, although the system may then delay the servo");
  add_number(command, "--max-time", options.longest, 1.0, 3600.0, "Longest duration of the session, s, 1 to 3600");
  add_second_options(command, options.second);
  add_force_options(command, options.forces);
  add_body_option(command, options.body);
  add_texts(
      command, "--left", options.left,
      "x,y,z:x,y,z, mm: entry and tip of a needle that was left in the body, with --resistance embedded_needle; may "
      "be given more than once");
  add_text(command, "--ultrasound", options.ultrasound,
           "\"PROBE SETTING=VALUE ...\": its picture live in the window of bodkin-app, with the needle and the "
           "tissue that it drags; "
           "view, at, from, press_mm, depth_mm, gain_dB, dynamic_range_dB, focus_mm, frequency_MHz");
}

namespace {

// Nothing without --mannequin. Throws InputError if it is incompatible with other options.
std::optional<station::MannequinPlace> mannequin_place(const PerformOptions& options,
                                                       const station::DeviceChoice& device,
                                                       const std::optional<station::SecondChoice>& second) {
  if (options.mannequin.empty()) {
    if (options.at_hub) throw InputError("--hub needs --mannequin, the registration of the device");
    return std::nullopt;
  }
  if (device.is_seen()) {
    throw InputError(
        fmt::format("--mannequin is for a device that touches it; give '{}' its registration with "
                    "--settings registration={}",
                    options.device.device, options.mannequin));
  }
  if (is_mouse(options.device) || device.is_recorded() || device.is_tracked()) {
    throw InputError(
        fmt::format("--mannequin is for a device that touches it, found '{}'; leave it out", options.device.device));
  }
  if (options.scale != 1.0) throw InputError("--mannequin needs motions at true scale; leave out --scale");
  if (second && second->role == session::SecondRole::probe)
    throw InputError("--mannequin places the needle's device alone; leave out --second-as probe");
  return station::MannequinPlace{
      io::read_rigid_placement(options.mannequin, "a hand is not scaled: register without --scale"), options.at_hub};
}

// Throws InputError naming the option.
std::vector<anatomy::NeedlePath> left_needles(const std::vector<std::string>& texts) {
  std::vector<anatomy::NeedlePath> left;
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) {
      throw InputError(fmt::format("--left is '{}', expected entry and tip of a needle as x,y,z:x,y,z in mm", text));
    }
    left.push_back({parse_point(text.substr(0, colon), "--left"), parse_point(text.substr(colon + 1), "--left")});
  }
  session::check_left_needles(left);
  return left;
}

}  // namespace

station::StationOptions station_options(const PerformOptions& options, Console& console) {
  require_writable(options.output, "--output");
  station::DeviceChoice device = choose_device(options.device);
  std::optional<station::SecondChoice> second = choose_second(options.second, device);
  const std::optional<station::MannequinPlace> mannequin = mannequin_place(options, device, second);
  std::optional<fem::ProbeFace> moving_body = parse_body(options.body);
  anatomy::Case patient = io::load_case(options.folder, console.progress());
  apply(options.forces, patient.description.haptics);
  return {.patient = std::move(patient),
          .case_folder = options.folder,
          .path = {},
          .device = std::move(device),
          .scale = options.scale,
          .force_scale = options.force_scale,
          .mannequin = mannequin,
          .allow_late = options.allow_late,
          .use_calibration = !options.no_calibration,
          .second = std::move(second),
          .moving_body = moving_body,
          .left_needles = left_needles(options.left),
          .ultrasound = {},
          .output = options.output,
          .overwrite = options.overwrite,
          .longest = options.longest};
}

bool needs_window(const PerformOptions& options) {
  return is_mouse(options.device) || !options.ultrasound.empty();
}

std::string attempt_json(const PerformOptions& options) {
  require_writable(options.output, "--output");
  const auto words_of = [](const DeviceOptions& device) -> nlohmann::json {
    const std::size_t colon = device.device.find(':');
    return {{"driver", driver_of(device)},
            {"identity", colon == std::string::npos ? "" : device.device.substr(colon + 1)},
            {"settings", device.settings}};
  };
  nlohmann::json attempt = {{"resistance", options.forces.resistance},
                            {"constraint", options.forces.constraint},
                            {"parts", options.forces.parts},
                            {"mechanics", options.forces.mechanics},
                            {"force_in_organs", options.forces.force_in_organs},
                            {"output", std::filesystem::absolute(options.output).string()},
                            {"overwrite", options.overwrite},
                            {"longest_s", options.longest},
                            {"scale", options.scale},
                            {"force_scale", options.force_scale},
                            {"allow_late", options.allow_late},
                            {"use_calibration", !options.no_calibration}};
  station::DeviceChoice device;
  if (is_mouse(options.device)) {
    if (!options.device.settings.empty()) throw InputError("the mouse has no settings; leave out --settings");
  } else {
    device = choose_device(options.device);
    attempt["device"] = words_of(options.device);
  }
  const std::optional<station::SecondChoice> second = choose_second(options.second, device);
  if (mannequin_place(options, device, second)) {
    attempt["mannequin"] = std::filesystem::absolute(options.mannequin).string();
    attempt["at_hub"] = options.at_hub;
  }
  if (second) {
    attempt["second"] = words_of(options.second.device);
    attempt["second_as"] = session::name_of(second->role);
  }
  if (const std::optional<fem::ProbeFace> face = parse_body(options.body)) {
    attempt["moving_body_mm"] = {face->width, face->thickness, face->radius};
  }
  for (const anatomy::NeedlePath& left : left_needles(options.left))
    attempt["left_needles_mm"].push_back(session::left_needles_text({left}));
  if (!options.ultrasound.empty()) attempt["ultrasound"] = station::to_json(pane_request(options.ultrasound));
  io::read_case_description(options.folder);
  anatomy::HapticSettings unused;
  apply(options.forces, unused);  // refuses what it cannot read
  return attempt.dump();
}

}  // namespace bodkin::cli
