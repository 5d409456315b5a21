#pragma once

#include <filesystem>

namespace bodkin::session {

// Whether a session file states that its recording ended on purpose, without reading its ticks. False: the recording
// process died, or still runs. Throws InputError as read_session() does.
bool is_finished(const std::filesystem::path& file);

}  // namespace bodkin::session
