#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tracking/station_footage.h"

#include "cli/arguments.h"
#include "cli/console.h"

namespace bodkin::cli {

// Pictures, their camera and the bodies in them as the command line gives them.
struct FootageArguments {
  std::string source, camera, bodies;
  double rate = 30.0, seconds = 0.0;
};

void add_footage_options(CLI::App& command, FootageArguments& arguments);
// Those of the pictures alone: FOOTAGE, --rate and --seconds.
void add_source_options(CLI::App& command, FootageArguments& arguments);

// Throws InputError.
tracking::OpenedFootage open_footage_of(const FootageArguments& arguments);

// Gives every picture to `take`, which may keep it, with a bar; of a live camera until Ctrl-C. `take` returns false
// to end. Notes of the source are printed.
void for_each_picture(tracking::PictureSource& source, const FootageArguments& arguments, Console& console,
                      const std::string& what, const std::function<bool(tracking::SourcePicture&)>& take);

}  // namespace bodkin::cli
