#include "app/models/kept_sessions.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <system_error>
#include <utility>

#include "session/session_end.h"

#include "core/error.h"

namespace bodkin::app {

namespace {

namespace fs = std::filesystem;

constexpr double megabyte = 1e6;
constexpr std::size_t most_looked_at = 20;

std::string local_time(fs::file_time_type when) {
  const auto since = std::chrono::duration_cast<std::chrono::seconds>(when - fs::file_time_type::clock::now());
  const std::time_t clock = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now() + since);
  std::tm parts{};
  localtime_r(&clock, &parts);
  char text[32];
  const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return {text, length};
}

}  // namespace

std::vector<KeptSession> kept_sessions(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, KeptSession>> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != ".bodkin" || !entry.is_regular_file(ignored)) continue;
    const fs::file_time_type when = entry.last_write_time(ignored);
    found.push_back({when,
                     {entry.path(), entry.path().stem().string(), local_time(when),
                      static_cast<double>(entry.file_size(ignored)) / megabyte}});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second.file > b.second.file;
  });
  std::vector<KeptSession> sessions;
  sessions.reserve(found.size());
  for (auto& each : found) sessions.push_back(std::move(each.second));
  return sessions;
}

fs::path cut_off_session(const std::vector<KeptSession>& sessions, const std::vector<fs::path>& forgotten) {
  for (std::size_t i = 0; i < std::min(sessions.size(), most_looked_at); ++i) {
    const fs::path& file = sessions[i].file;
    if (std::find(forgotten.begin(), forgotten.end(), file) != forgotten.end()) continue;
    try {
      if (!session::is_finished(file)) return file;
    } catch (const InputError&) {  // damaged, or of another program: the review says so when it is opened
    }
  }
  return {};
}

}  // namespace bodkin::app
