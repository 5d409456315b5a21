#include "station/corridor_keeper.h"

#include <chrono>
#include <exception>
#include <string_view>
#include <utility>

#include "patient/prepared_body.h"
#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/patient_body.h"

namespace bodkin::station {

namespace {

struct GivenUp : std::exception {};

constexpr double same_place = 5.0;  // mm, within which a path that was refused is not tried again
constexpr double still = 1.0;       // mm, by which a hand that aims may move from update to update

bool within(double distance, const anatomy::NeedlePath& one, const anatomy::NeedlePath& other) {
  return (one.entry - other.entry).norm() < distance && (one.target - other.target).norm() < distance;
}

}  // namespace

CorridorKeeper::CorridorKeeper(std::shared_ptr<const anatomy::Case> patient,
                               std::shared_ptr<const fem::BodyDescription> body, double length, std::size_t room,
                               std::shared_ptr<const fem::ContactBody> kept)
    : patient_(std::move(patient)),
      body_(std::move(body)),
      length_(length),
      room_(room),
      corridors_{patient_->corridor},
      kept_(std::move(kept)) {}

CorridorKeeper::~CorridorKeeper() {
  given_up_.store(true);
}

std::optional<anatomy::NeedlePath> CorridorKeeper::uncovered(const Pose& needle) const {
  std::optional<anatomy::NeedlePath> path = patient::aimed_path(needle, patient_->tissues, length_);
  if (!path) return {};
  const anatomy::DeformableBodySettings& settings = *anatomy::body_of(patient_->description.haptics.resistance);
  for (const anatomy::PreparedCorridor& corridor : corridors_)
    if (fem::covers(corridor, *path, settings)) return {};
  if (refused_ && within(same_place, *refused_, *path)) return {};
  return path;
}

CorridorKeeper::News CorridorKeeper::update(const Pose& needle, std::uint64_t tick) {
  News news;
  if (making_.valid()) {
    if (making_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return news;
    try {
      news.ready = making_.get();
      corridors_.push_back(*news.ready);
      if (!has_points()) news.sentence = "the deformable body is prepared where the needle aimed";
    } catch (const InputError& error) {
      refused_ = wanted_;
      if (!has_points())
        news.sentence = fmt::format("the deformable body cannot be prepared where the needle aims: {}", error.what());
    }
    return news;
  }
  const std::optional<anatomy::NeedlePath> path = uncovered(needle);
  const std::optional<anatomy::NeedlePath> before = std::exchange(aimed_, path);
  if (!path) return news;
  if (has_points() && !(before && within(still, *before, *path))) return news;
  if (corridors_.size() > room_) {
    if (!has_points() && !std::exchange(said_full_, true)) {
      news.sentence = fmt::format(
          "the needle aims where the deformable body is not prepared, and there is no room for more than {} "
          "corridors: begin a new session there",
          room_ + 1);
    }
    return news;
  }
  wanted_ = *path;
  making_ = std::async(std::launch::async, [this, about = *path, tick] {
    return patient::another_corridor(*body_, *patient_, about, tick, kept_, [this](std::string_view, double) {
      if (given_up_.load()) throw GivenUp();
    });
  });
  if (has_points()) return news;
  news.sentence =
      "the needle aims where the deformable body is not prepared: that is being done, wait outside until it is";
  return news;
}

}  // namespace bodkin::station
