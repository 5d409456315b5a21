#include "app/models/station_link.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "app/models/remote_station.h"
#include "session/session_file.h"

#include "core/error.h"
#include "training/case_score.h"

namespace bodkin::app {

namespace {

constexpr std::chrono::milliseconds watch_interval{4};

// Thrown out of a Progress to end the preparation.
struct PreparationCancelled : std::exception {
  const char* what() const noexcept override { return "given up"; }
};

AttemptResult result_of(const std::filesystem::path& file, const anatomy::Case& patient, const AttemptRules& rules,
                        session::RunResult run) {
  AttemptResult result;
  result.session = file;
  result.run = std::move(run);
  const session::Session saved = session::read_session(file);
  if (!rules.is_planned) {
    result.headline = "The session is saved";
    result.remarks = {"This patient has no planned path, so there is nothing to judge by."};
    return result;
  }
  training::Score score;
  try {
    score = training::score_on_case(saved, patient, rules.procedure);
  } catch (const InputError& error) {
    result.headline = "The session is saved, but cannot be judged";
    result.remarks = {error.what()};
    return result;
  }
  const auto value = [&score](const char* metric) {
    const training::MetricResult* found = score.find(metric);
    return found == nullptr ? 0.0 : found->value;
  };
  result.verdict = score.verdict;
  result.reached = score.reached;
  result.headline = score.headline;
  for (const training::Finding& each : score.findings) result.remarks.push_back(each.sentence);
  result.deepest = value("deepest_mm");
  result.peak_force = value("peak_force_N");
  result.target_distance = value("final_distance_mm");
  result.time_in_body = value("time_in_body_s");
  result.bone_contacts = static_cast<int>(value("bone_contacts"));
  result.record = training::record_of(saved, patient.description.name, score);
  result.record->file = std::filesystem::absolute(file).lexically_normal().string();
  return result;
}

}  // namespace

struct StationLink::Shared {
  std::mutex lock;  // guards all but `ended`
  StationUpdate news;
  std::vector<station::StationCommand> commands;
  std::optional<station::ScanSetup> setup;
  std::optional<BodyPlace> body;
  std::optional<std::pair<std::vector<Vec3>, Vec3>> points;  // and the entry that they are about
  std::optional<std::pair<anatomy::HapticSettings, std::vector<anatomy::TissueProperties>>> numbers;
  std::atomic<bool> ended{false};
};

class StationLink::Observer : public station::StationObserver {
 public:
  Observer(std::shared_ptr<Shared> shared, std::vector<Vec3> points)
      : shared_(std::move(shared)), points_(std::move(points)) {}

  Progress progress() override {
    return [shared = shared_](std::string_view stage, double fraction) {
      if (shared->ended.load()) throw PreparationCancelled();
      const std::lock_guard guard(shared->lock);
      shared->news.stage = stage;
      shared->news.fraction = fraction;
    };
  }

  void note(const std::string& sentence) override {
    const std::lock_guard guard(shared_->lock);
    shared_->news.notes.push_back(sentence);
  }

  std::vector<Vec3> prepare(const anatomy::Case& /*patient*/, const fem::BodyDescription* body) override {
    return body != nullptr ? points_ : std::vector<Vec3>();
  }

  std::chrono::milliseconds interval() const override { return watch_interval; }

  void update(station::Station& station, const station::StationStatus& status) override {
    std::vector<station::StationCommand> commands;
    std::optional<station::ScanSetup> setup;
    std::optional<BodyPlace> body;
    decltype(shared_->points) points;
    decltype(shared_->numbers) numbers;
    std::shared_ptr<const station::LiveImage> picture;
    if (status.ultrasound != nullptr && status.ultrasound->number != shown_picture_) {
      shown_picture_ = status.ultrasound->number;
      picture = std::make_shared<const station::LiveImage>(*status.ultrasound);
    }
    {
      const std::lock_guard guard(shared_->lock);
      commands.swap(shared_->commands);
      setup.swap(shared_->setup);
      body.swap(shared_->body);
      points.swap(shared_->points);
      numbers.swap(shared_->numbers);
      publish(status, std::move(picture));
      if (points) shared_->news.displacements.assign(3 * points->first.size(), 0.0F);  // the status is of others
    }
    for (const station::StationCommand command : commands) station.command(command);
    if (points) follow(station, points->first, points->second);
    if (setup) station.set_scan_setup(*setup);
    if (body && !station.move_body(body->middle, body->rotation))
      note("The body stays where it is: a needle touches it, or a second hand takes part.");
    if (numbers) station.change_numbers(numbers->first, numbers->second);
    if (shared_->ended.load()) station.end();
  }

 private:
  void follow(station::Station& station, const std::vector<Vec3>& points, const Vec3& entry) {
    try {
      station.follow(points, entry);
    } catch (const std::exception& refused) {
      note(refused.what());
    }
  }

  void publish(const station::StationStatus& status, std::shared_ptr<const station::LiveImage> picture) {
    StationUpdate& news = shared_->news;
    news.time = status.time;
    news.servo = status.servo;
    news.needle = status.needle;
    news.timings = status.timings;
    news.message = status.message;
    if (news.diagnostic_names.empty())
      news.diagnostic_names.assign(status.diagnostic_names.begin(), status.diagnostic_names.end());
    if (news.samples.size() < StationUpdate::most_samples)
      news.samples.insert(news.samples.end(), status.samples.begin(), status.samples.end());
    news.events.insert(news.events.end(), status.events.begin(), status.events.end());
    news.displacements.assign(status.displacements.begin(), status.displacements.end());
    if (picture != nullptr) news.ultrasound = std::move(picture);
  }

  std::shared_ptr<Shared> shared_;
  std::vector<Vec3> points_;
  std::uint64_t shown_picture_ = 0;
};

StationLink::StationLink() = default;

StationLink::~StationLink() {
  stop();
}

void StationLink::stop() {
  if (remote_ != nullptr) {
    remote_.reset();
    news_.samples.clear();
    news_.events.clear();
  }
  end();
  if (thread_.joinable()) thread_.join();
}

void StationLink::follow(std::unique_ptr<RemoteStation> station) {
  stop();
  shared_.reset();
  news_ = StationUpdate{};
  news_.phase = StationUpdate::Phase::preparing;
  remote_ = std::move(station);
}

void StationLink::start(station::StationOptions options, const std::string& device, AttemptRules rules,
                        std::vector<Vec3> points) {
  stop();
  shared_ = std::make_shared<Shared>();
  shared_->news.phase = StationUpdate::Phase::preparing;
  shared_->news.device = device;
  news_ = StationUpdate{};
  thread_ = std::jthread([shared = shared_, options = std::move(options), rules = std::move(rules),
                          points = std::move(points)]() mutable {
    const auto enter = [&shared](StationUpdate::Phase phase) {
      const std::lock_guard guard(shared->lock);
      shared->news.phase = phase;
    };
    const std::filesystem::path file = options.output;
    bool is_made = false;  // the file
    const auto remove_empty = [&] {
      std::error_code ignored;
      if (is_made && shared->news.needle.ticks == 0) std::filesystem::remove(file, ignored);
      return !is_made || shared->news.needle.ticks == 0;
    };
    try {
      Observer observer(shared, std::move(points));
      station::Station station(std::move(options), observer);
      is_made = true;
      if (shared->ended.load()) throw PreparationCancelled();
      {
        const std::lock_guard guard(shared->lock);
        shared->news.limits = station.patient().description.device;
      }
      station.start();
      enter(StationUpdate::Phase::running);
      while (!station.ended()) {
        std::this_thread::sleep_for(watch_interval);
        observer.update(station, station.update());
      }
      enter(StationUpdate::Phase::finishing);
      session::RunResult run = station.finish().run;
      AttemptResult result = result_of(file, station.patient(), rules, std::move(run));
      const std::lock_guard guard(shared->lock);
      shared->news.result = std::move(result);
      shared->news.phase = StationUpdate::Phase::finished;
    } catch (const PreparationCancelled&) {
      remove_empty();
      enter(StationUpdate::Phase::idle);
    } catch (const std::exception& failure) {
      const bool is_empty = remove_empty();
      const std::lock_guard guard(shared->lock);
      if (!is_empty) {
        shared->news.result.emplace();
        shared->news.result->session = file;
        shared->news.result->headline = "The session was cut off; what was recorded until then is kept";
      }
      shared->news.error = failure.what();
      shared->news.phase = StationUpdate::Phase::failed;
    }
  });
}

void StationLink::follow_points(std::vector<Vec3> points, const Vec3& entry) {
  if (remote_ != nullptr) return remote_->follow_points(std::move(points));
  if (shared_ == nullptr) return;
  const std::lock_guard guard(shared_->lock);
  shared_->news.displacements.assign(3 * points.size(), 0.0F);
  shared_->points = {std::move(points), entry};
}

void StationLink::command(station::StationCommand command) {
  if (remote_ != nullptr) return remote_->command(command);
  if (shared_ == nullptr) return;
  const std::lock_guard guard(shared_->lock);
  shared_->commands.push_back(command);
}

void StationLink::set_scan_setup(const station::ScanSetup& setup) {
  if (remote_ != nullptr) return remote_->set_scan_setup(setup);
  if (shared_ == nullptr) return;
  const std::lock_guard guard(shared_->lock);
  shared_->setup = setup;
}

void StationLink::move_body(const BodyPlace& place) {
  if (shared_ == nullptr) return;
  const std::lock_guard guard(shared_->lock);
  shared_->body = place;
}

void StationLink::change_numbers(const anatomy::HapticSettings& haptics,
                                 const std::vector<anatomy::TissueProperties>& tissues) {
  if (shared_ == nullptr) return;
  const std::lock_guard guard(shared_->lock);
  shared_->numbers = {haptics, tissues};
}

void StationLink::end() {
  if (remote_ != nullptr) return remote_->end();
  if (shared_ != nullptr) shared_->ended.store(true);
}

const StationUpdate& StationLink::poll() {
  if (remote_ != nullptr) {
    remote_->poll(news_);
    return news_;
  }
  if (shared_ == nullptr) return news_;
  const std::lock_guard guard(shared_->lock);
  news_ = shared_->news;
  shared_->news.notes.clear();
  shared_->news.samples.clear();
  shared_->news.events.clear();
  return news_;
}

}  // namespace bodkin::app
