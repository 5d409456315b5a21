#pragma once

#include <string>

#include "training/score.h"

namespace bodkin::training {

// Version of the form below; share/bodkin/score.schema.json describes it.
inline constexpr int score_version = 1;

// A score as one JSON object of the published form, indented. Times in s, lengths in mm, forces in N; what an attempt
// does not have is null. The thresholds of its metrics are told where they are not the default. `session`: the file
// that was scored.
std::string score_json(const Score& score, const Attempt& attempt, const std::string& session);

// A score in a table of attempts: the names of its columns, and its values in them, with commas between. Fields that
// a score does not have are empty.
std::string score_csv_columns();
std::string score_csv_fields(const Score& score);

}  // namespace bodkin::training
