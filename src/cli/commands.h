#pragma once

#include <string>

namespace CLI {
class App;
}

namespace bodkin::cli {

// Options of all subcommands.
struct CommandContext {
  bool quiet = false;  // no progress, no notes; errors are still printed
  bool json = false;   // the result as one JSON object on standard output
  int exit_code = 0;   // return value of main after a command
};

// Each adds one subcommand to `app`, defined in the file of its name. The command runs in CLI11's callback; it throws
// InputError (exit code 2) or SystemError (exit code 1).
void add_case_new_command(CLI::App& case_group, CommandContext& context);
void add_case_synthesize_command(CLI::App& case_group, CommandContext& context);
void add_case_synthesize_body_command(CLI::App& group, CommandContext& context);
void add_case_synthesize_phantom_command(CLI::App& group, CommandContext& context);
void add_case_synthesize_shoulder_command(CLI::App& group, CommandContext& context);
void add_case_check_command(CLI::App& case_group, CommandContext& context);
void add_case_show_command(CLI::App& case_group, CommandContext& context);
void add_case_plan_command(CLI::App& case_group, CommandContext& context);
void add_case_warp_command(CLI::App& case_group, CommandContext& context);  // of a build with VTK
void add_case_breathe_command(CLI::App& case_group, CommandContext& context);
void add_case_mesh_command(CLI::App& case_group, CommandContext& context);
void add_devices_list_command(CLI::App& devices_group, CommandContext& context);
void add_devices_check_command(CLI::App& devices_group, CommandContext& context);
void add_devices_calibrate_command(CLI::App& devices_group, CommandContext& context);
void add_devices_touch_command(CLI::App& devices_group, CommandContext& context);
void add_app_command(CLI::App& app, CommandContext& context);
void add_points_command(CLI::App& app, CommandContext& context);
void add_profile_command(CLI::App& app, CommandContext& context);
void add_compare_command(CLI::App& app, CommandContext& context);
void add_run_command(CLI::App& app, CommandContext& context);
void add_perform_command(CLI::App& app, CommandContext& context);
void add_serve_command(CLI::App& app, CommandContext& context);
void add_replay_command(CLI::App& app, CommandContext& context);
void add_export_command(CLI::App& app, CommandContext& context);
void add_import_command(CLI::App& app, CommandContext& context);
void add_cohort_command(CLI::App& app, CommandContext& context);
void add_score_command(CLI::App& app, CommandContext& context);
void add_plan_command(CLI::App& app, CommandContext& context);
void add_experts_command(CLI::App& app, CommandContext& context);
void add_results_command(CLI::App& app, CommandContext& context);
void add_teacher_command(CLI::App& app, CommandContext& context);
void add_stations_command(CLI::App& app, CommandContext& context);
void add_report_command(CLI::App& app, CommandContext& context);
void add_fit_command(CLI::App& app, CommandContext& context);
void add_figures_command(CLI::App& app, CommandContext& context);
void add_ultrasound_command(CLI::App& app, CommandContext& context);

}  // namespace bodkin::cli
