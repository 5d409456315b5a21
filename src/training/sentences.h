#pragma once

#include <string>

#include "training/score.h"

namespace bodkin::training {

// Sentences as a teacher would say them, one or two each, to the person who held the needle.

// The requirement of a goal: "came to rest in the cerebrospinal fluid" after "the tip", or with `to_come` "come to
// rest in ..." after "must".
std::string goal_words(const Goal& goal, const Attempt& attempt, bool to_come);

// "The tip entered the aorta at 12.3 s, 81 mm deep: ..."
std::string harm_sentence(const Harm& harm);

// "Path in the body: 140.2 mm; at most 120 mm passes. ADVICE"
std::string rule_sentence(const Rule& rule, const Metric& metric, double value);

// "The ligamentum flavum gave way at 45.7 mm; you went 6.2 mm further, at up to 31 mm/s, and stopped after 0.4 s."
std::string loss_sentence(const Puncture& loss, bool too_far);

// "It came to rest 2.3 mm from the planned target: 1.8 mm too deep and 1.4 mm to the side."
std::string ending_sentence(const FinalPosition& final_tip, const Attempt& attempt);

// "The ultrasound showed nerve and cartilage."
std::string scanned_sentence(const std::vector<session::ScannedPart>& parts);

}  // namespace bodkin::training
