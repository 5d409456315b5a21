#pragma once

#include <string>
#include <string_view>

#include "core/geometry.h"
#include "io/pose_log.h"

namespace bodkin::io {

// The text of 16 numbers row by row as a pose, normalised to an exact rotation. Throws InputError, beginning with
// `where`, for anything else and for a matrix that scales, shears or mirrors by more than 1 %.
Pose pose_of_numbers(std::string_view text, const std::string& where);

// 16 numbers, row by row.
std::string numbers_of_pose(const Pose& pose);

// Sorts a log's poses by time; of two at one time the later one in the file is kept.
void sort_by_time(PoseLog& log);

}  // namespace bodkin::io
