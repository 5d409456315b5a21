#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tracking/station_footage.h"

#include "cli/arguments.h"
#include "cli/console.h"

namespace bodkin::cli {

// Images, their camera and the bodies in them, from the command line.
struct FootageArguments {
  std::string source, camera, bodies;
  double rate = 30.0, seconds = 0.0;
};

void add_footage_options(CLI::App& command, FootageArguments& arguments);
// Only the options of the images: FOOTAGE, --rate and --seconds.
void add_source_options(CLI::App& command, FootageArguments& arguments);

// Throws InputError.
tracking::OpenedFootage open_footage_of(const FootageArguments& arguments);

// Passes every image to `take`, which may keep it, with a progress bar; for a live camera until Ctrl-C. `take`
// returns false to stop. Prints the notes of the source.
void for_each_picture(tracking::PictureSource& source, const FootageArguments& arguments, Console& console,
                      const std::string& what, const std::function<bool(tracking::SourcePicture&)>& take);

}  // namespace bodkin::cli
