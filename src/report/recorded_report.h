#pragma once

#include <filesystem>
#include <string>

namespace bodkin::report {

// The report of a session file on the case that it was recorded on, judged by the procedure that this case names: see
// report_html(). Throws InputError when the session or its case cannot be read.
std::string recorded_report_html(const std::filesystem::path& session);

}  // namespace bodkin::report
