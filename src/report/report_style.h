#pragma once

#include <string_view>

namespace bodkin::report {

// The style sheet of a report: readable on a screen in light and dark, and on paper.
std::string_view report_style();

}  // namespace bodkin::report
