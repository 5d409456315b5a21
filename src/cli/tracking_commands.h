#pragma once

#include "cli/commands.h"

namespace bodkin::cli {

// The commands of a build with OpenCV, like those of commands.h.
void add_scene_render_command(CLI::App& scene_group, CommandContext& context);
void add_track_command(CLI::App& app, CommandContext& context);
// Returns the group, which is also a command itself.
CLI::App* add_markers_command(CLI::App& app, CommandContext& context);
void add_markers_calibrate_command(CLI::App& markers_group, CommandContext& context);
void add_markers_pivot_command(CLI::App& markers_group, CommandContext& context);
void add_camera_board_command(CLI::App& camera_group, CommandContext& context);
void add_camera_calibrate_command(CLI::App& camera_group, CommandContext& context);
void add_register_command(CLI::App& app, CommandContext& context);
void add_overlay_command(CLI::App& app, CommandContext& context);

}  // namespace bodkin::cli
