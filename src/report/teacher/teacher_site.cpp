#include "report/teacher/teacher_site.h"

#include <filesystem>

#include "report/recorded_report.h"
#include "report/teacher/teacher_page.h"
#include <fmt/format.h>

#include "core/error.h"
#include "training/store/plan_attempts.h"
#include "training/store/results_csv.h"

namespace bodkin::report {

namespace {

constexpr const char* cookie_name = "bodkin_teacher";
constexpr std::chrono::milliseconds store_patience{2000};

HttpReply message(int status, const std::string& title, const std::string& sentence) {
  return {.status = status, .body = message_page(title, sentence)};
}

HttpReply not_found() {
  return message(404, "Not found", "There is no such page; the trainee or attempt may have been deleted.");
}

// Takes the same time for every wrong token.
bool is_same(const std::string& given, const std::string& token) {
  if (given.size() != token.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < token.size(); ++i) different |= static_cast<unsigned>(given[i] ^ token[i]);
  return different == 0;
}

std::string host_name(const std::string& host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

// The text after `name=` in "a=1; name=2" or "a=1&name=2".
std::string value_after(const std::string& text, const std::string& name, char separator) {
  std::size_t at = 0;
  while (at < text.size()) {
    while (at < text.size() && text[at] == ' ') ++at;
    const std::size_t end = std::min(text.find(separator, at), text.size());
    if (text.compare(at, name.size() + 1, name + "=") == 0)
      return text.substr(at + name.size() + 1, end - at - name.size() - 1);
    at = end + 1;
  }
  return {};
}

std::vector<PlanPlace> plan_places(training::ResultStore& store) {
  std::vector<PlanPlace> places;
  for (const training::StoredPlan& stored : store.plans()) {
    const training::Plan plan = training::parse_plan(stored.document, stored.name);
    const auto attempts = store.summaries_of_plan(stored.name);
    for (std::size_t first = 0; first < attempts.size();) {
      std::vector<training::StageAttempt> own;
      std::size_t last = first;
      for (; last < attempts.size() && attempts[last].trainee == attempts[first].trainee; ++last)
        own.push_back({attempts[last].stage, attempts[last].verdict, attempts[last].score});
      const training::PlanProgress progress = training::progress_in(plan, own);
      const bool is_over = progress.stage > static_cast<int>(plan.stages.size());
      std::string words = "finished";
      if (!is_over) {
        const training::PlanStage& stage = plan.stages[static_cast<std::size_t>(progress.stage - 1)];
        words = fmt::format("stage {} of {}, {}: {}", progress.stage, plan.stages.size(), stage.title,
                            training::progress_words(stage, progress.here));
      }
      places.push_back({attempts[first].trainee, plan.title, words});
      first = last;
    }
  }
  return places;
}

}  // namespace

TeacherSite::TeacherSite(std::string store, std::string token, std::function<std::vector<StationCard>()> stations)
    : store_(std::move(store)), token_(std::move(token)), stations_(std::move(stations)) {}

bool TeacherSite::may_look(const HttpRequest& request, const std::string& query) const {
  if (token_.empty()) {
    const std::string name = host_name(request.host);
    return name == "localhost" || is_loopback(name) ||
           (name.size() > 2 && name.front() == '[' && is_loopback(name.substr(1, name.size() - 2)));
  }
  return is_same(value_after(query, "token", '&'), token_) ||
         is_same(value_after(request.cookie, cookie_name, ';'), token_);
}

HttpReply TeacherSite::answer(const HttpRequest& request) const {
  const std::size_t mark = request.target.find('?');
  const std::string query = mark == std::string::npos ? "" : request.target.substr(mark + 1);
  if (!may_look(request, query))
    return message(403, "Access denied", "Open the address that 'bodkin teacher' printed, with its token.");
  HttpReply reply;
  try {
    reply = page(request.target.substr(0, mark));
  } catch (const InputError& error) {
    reply = message(404, "This cannot be shown", error.what());
  } catch (const SystemError& error) {
    reply = message(503, "The store does not answer", error.what());
  }
  if (!token_.empty()) reply.cookie = fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_name, token_);
  return reply;
}

HttpReply TeacherSite::page(const std::string& path) const {
  if (path == "/stations") return {.body = stations_page(stations_ ? stations_() : std::vector<StationCard>())};
  training::ResultStore store(store_, store_patience);
  const auto after = [&](const std::string& folder) { return percent_decoded(path.substr(folder.size())); };
  if (path == "/")
    return {.body = cohort_page(training::cohort_table(store.summaries()), plan_places(store), store.place(),
                                stations_ != nullptr)};
  if (path == "/results.csv")
    return {.type = "text/csv; charset=utf-8", .body = training::results_csv(store.attempts())};
  if (path.starts_with("/trainee/")) {
    const auto label = after("/trainee/");
    if (!label || label->empty()) return not_found();
    const auto attempts = store.attempts(*label);
    return attempts.empty() ? not_found() : HttpReply{.body = trainee_page(attempts)};
  }
  if (!path.starts_with("/attempt/")) return not_found();
  auto digest = after("/attempt/");
  if (!digest) return not_found();
  constexpr std::string_view report_part = "/report";
  const bool wants_report = digest->ends_with(report_part);
  if (wants_report) digest->erase(digest->size() - report_part.size());
  const auto attempt = store.attempt(*digest);
  if (!attempt) return not_found();
  std::error_code failure;
  const bool is_here = !attempt->file.empty() && std::filesystem::is_regular_file(attempt->file, failure);
  if (!wants_report) return {.body = attempt_page(*attempt, is_here)};
  return is_here ? HttpReply{.body = recorded_report_html(attempt->file)} : not_found();
}

}  // namespace bodkin::report
