#pragma once

#include <string>

#include "training/score.h"

namespace bodkin::training {

// Version of the format below; share/bodkin/score.schema.json describes it.
inline constexpr int score_version = 1;

// A score as one JSON object of the published format, indented. Times in s, lengths in mm, forces in N; missing
// values are null. Thresholds of its metrics are included if they are not the default. `session`: the scored file.
std::string score_json(const Score& score, const Attempt& attempt, const std::string& session);

// A score in a table of attempts: the names of its columns, and its values, separated by commas. Missing values are
// empty.
std::string score_csv_columns();
std::string score_csv_fields(const Score& score);

}  // namespace bodkin::training
