#include "cli/program.h"

#include <exception>
#include <string_view>

#include "station/driver_inquiry.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/all_drivers.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/standard_streams.h"
#ifdef BODKIN_HAS_TRACKING
#include "cli/tracking_commands.h"
#endif
#include "core/error.h"

namespace bodkin::cli {

namespace {

constexpr int exit_system_error = 1;
constexpr int exit_input_error = 2;

constexpr const char* main_footer = R"(Examples:
  bodkin app                                     practise in a window
  bodkin case synthesize lumbar patient          make a lumbar torso from parameters and a seed
  bodkin case synthesize body patient --point ST36   a body around an acupuncture point
  bodkin case new patient --ct dicom_folder      make a case from a CT
  bodkin case show patient                       what is in it, as text and as a figure
  bodkin case plan patient --target liver        paths to any place, and what they keep clear of
  bodkin case mesh patient                       tetrahedra for the deformable body
  bodkin profile patient                         force against depth along the planned path
  bodkin compare patient                         every force model on the same motion
  bodkin run patient --operator novice           a simulated hand performs the procedure
  bodkin score session.bodkin                    how good it was, and why
  bodkin results list                            results of every trainee
  bodkin report session.bodkin                   what happened, as one HTML file
  bodkin fit layered skin.csv                    parameters of a force model from a measured curve
  bodkin perform patient openhaptics             perform it yourself on a haptic device
  bodkin ultrasound patient --ct                 what an ultrasound probe shows, next to the CT
  bodkin overlay patient footage                 the patient within a tracked mannequin
  bodkin devices list                            haptic devices that are connected
  bodkin figures figures                         published experiments, simulated and plotted

'bodkin COMMAND --help' explains a command. Coordinates are patient coordinates, LPS, in mm.)";

}  // namespace

int run_program(int argc, char** argv) {
  // This program querying a driver in a child process: not a command for users.
  if (argc == 2 && std::string_view(argv[1]) == station::driver_inquiry_argument) {
    return station::answer_driver_inquiry(load_driver);
  }
  ignore_broken_pipes();
  CLI::App app{"Bodkin: put needles into bodies, feel what they meet, and see how well it went."};
  app.footer(main_footer);
  app.require_subcommand(1);
  app.fallthrough();
  app.set_version_flag("--version", "bodkin " BODKIN_VERSION);

  CommandContext context;
  add_switch(app, "--quiet,-q", context.quiet, "No progress bars and no notes");
  add_switch(app, "--json", context.json, "The result as one JSON object on standard output");

  CLI::App* case_group = app.add_subcommand("case", "Make, check and look at patients");
  case_group->require_subcommand(1);
  add_case_new_command(*case_group, context);
  add_case_synthesize_command(*case_group, context);
  add_case_check_command(*case_group, context);
  add_case_show_command(*case_group, context);
  add_case_plan_command(*case_group, context);
  add_case_breathe_command(*case_group, context);
  add_case_mesh_command(*case_group, context);
#ifdef BODKIN_HAS_WARP
  add_case_warp_command(*case_group, context);
#endif
  CLI::App* devices_group = app.add_subcommand("devices", "Find haptic devices and see how well they answer");
  devices_group->require_subcommand(1);
  add_devices_list_command(*devices_group, context);
  add_devices_check_command(*devices_group, context);
  add_devices_calibrate_command(*devices_group, context);
  add_devices_touch_command(*devices_group, context);
  add_app_command(app, context);
  add_points_command(app, context);
  add_profile_command(app, context);
  add_compare_command(app, context);
  add_run_command(app, context);
  add_perform_command(app, context);
  add_serve_command(app, context);
  add_replay_command(app, context);
  add_export_command(app, context);
  add_import_command(app, context);
  add_cohort_command(app, context);
  add_score_command(app, context);
  add_plan_command(app, context);
  add_experts_command(app, context);
  add_results_command(app, context);
  add_teacher_command(app, context);
  add_stations_command(app, context);
  add_report_command(app, context);
  add_fit_command(app, context);
  add_figures_command(app, context);
  add_ultrasound_command(app, context);
#ifdef BODKIN_HAS_TRACKING
  CLI::App* scene_group = app.add_subcommand("scene", "Footage of a teaching station");
  scene_group->require_subcommand(1);
  add_scene_render_command(*scene_group, context);
  add_track_command(app, context);
  CLI::App* markers_group = add_markers_command(app, context);
  add_markers_calibrate_command(*markers_group, context);
  add_markers_pivot_command(*markers_group, context);
  CLI::App* camera_group = app.add_subcommand("camera", "Calibrate a camera");
  camera_group->require_subcommand(1);
  add_camera_board_command(*camera_group, context);
  add_camera_calibrate_command(*camera_group, context);
  add_register_command(app, context);
  add_overlay_command(app, context);
#endif

  try {
    app.parse(argc, argv);
    return context.exit_code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    write_remark(fmt::format("bodkin: {}\n", usage_sentence(app, error)));
    return exit_input_error;
  } catch (const OutputClosed&) {
    return context.exit_code != 0 ? context.exit_code : exit_output_closed;
  } catch (const InputError& error) {
    write_error(error.what(), exit_input_error, context.json);
    return exit_input_error;
  } catch (const std::exception& error) {
    write_error(error.what(), exit_system_error, context.json);
    return exit_system_error;
  }
}

}  // namespace bodkin::cli
