#include "cli/moving_patient.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "core/error.h"

namespace bodkin {

namespace {

constexpr double pace = 1.0 / 60.0;             // s of a step
constexpr double step_time_of_a_node = 2.5e-6;  // s on one core of 2.4 GHz (docs/corotational.md)
constexpr double slow_motion = 0.9;             // of the steps; fewer are worth a word

using FaceSetting = std::pair<std::string_view, double ProbeFace::*>;
constexpr std::array<FaceSetting, 3> face_settings = {FaceSetting{"width_mm", &ProbeFace::width},
                                                      FaceSetting{"thickness_mm", &ProbeFace::thickness},
                                                      FaceSetting{"radius_mm", &ProbeFace::radius}};

// The words of a text, without the blanks between them.
std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return words;
    const auto end = std::min(text.find_first_of(" \t", first), text.size());
    words.push_back(text.substr(first, end - first));
    text.remove_prefix(end);
  }
}

void take_face_setting(std::string_view word, ProbeFace& face) {
  const auto sign = std::min(word.find('='), word.size());
  for (const auto& [name, member] : face_settings) {
    if (word.substr(0, sign) != name) continue;
    const std::string_view digits = word.substr(std::min(sign + 1, word.size()));
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), face.*member);
    if (error == std::errc() && end == digits.data() + digits.size()) return;
    throw InputError(fmt::format("--body: {} is '{}', expected a number of mm", name, digits));
  }
  throw InputError(
      fmt::format("--body: there is no setting '{}', expected width_mm, thickness_mm or radius_mm of the "
                  "probe's face, as SETTING=VALUE",
                  word.substr(0, sign)));
}

}  // namespace

void add_body_option(CLI::App& command, std::string& body) {
  add_text(command, "--body", body,
           "static (the default), or \"moving SETTING=VALUE ...\": one that the probe of the second device presses "
           "far, on a thread of its own; width_mm, thickness_mm, radius_mm of the probe's face");
}

std::optional<ProbeFace> choose_body(const std::string& body, const std::optional<ChosenSecond>& second,
                                     const ResistanceSettings& resistance) {
  if (body.empty()) return {};
  const std::vector<std::string_view> words = split_words(body);
  const bool moves = !words.empty() && words.front() == "moving";
  if (!moves && (words.size() != 1 || words.front() != "static"))
    throw InputError(fmt::format("--body is '{}'; expected static, or moving with settings of the probe", body));
  if (!moves) return {};
  ProbeFace face;
  for (std::size_t word = 1; word < words.size(); ++word) take_face_setting(words[word], face);
  if (!second || second->role != SecondRole::probe) {
    throw InputError(
        "--body is 'moving', which a probe presses, but no second device holds one; add --second DEVICE --second-as "
        "probe");
  }
  if (!std::holds_alternative<EmbeddedNeedleSettings>(resistance)) {
    throw InputError(
        fmt::format("--body is 'moving', which only the resistance embedded_needle feels, and this one is {}; add "
                    "--resistance embedded_needle",
                    name_of(resistance)));
  }
  return face;
}

std::string text_of(const ProbeFace& face, std::size_t nodes) {
  nlohmann::ordered_json json = {{"nodes", nodes}};
  for (const auto& [name, member] : face_settings) json[std::string(name)] = face.*member;
  return json.dump();
}

MovingPatient::MovingPatient(const Case& patient, const BodyDescription& body, const ProbeFace& face,
                             Console& console) {
  const std::size_t nodes = body.mesh.nodes.size();
  const double step = step_time_of_a_node * static_cast<double>(nodes);
  if (step > pace) {
    console.note(
        fmt::format("the mesh has {} nodes, of which a step of the moving body takes about {:.0f} ms, and 60 steps a "
                    "second leave {:.1f} ms: it will move in slow motion; a mesh of {:.0f} nodes keeps up",
                    nodes, 1e3 * step, 1e3 * pace, 1e3 * std::floor(1e-3 * pace / step_time_of_a_node)));
  }
  PressedBodySettings settings;
  settings.motion.dt = pace;
  settings.probe = face;
  body_ = std::make_shared<PressedPatient>(patient, body, settings);
}

void MovingPatient::say(const std::string& sentence, std::string& said, Console& console) {
  said = sentence;
  console.clear_bar();
  console.note(sentence);
}

void MovingPatient::look(HandSession& session, const Case& patient, std::string& said, Console& console) {
  const BodyPicture& now = body_->picture();
  steps_ = now.steps;
  most_met_ = std::max(most_met_, now.probe_nodes);
  if (body_->failed()) {
    if (!std::exchange(failed_, true))
      say("the moving body failed: the probe loses its force, and the needle finds the body at rest", said, console);
    return;
  }
  if (now.corridor_failed && !std::exchange(corridor_failed_, true))
    say("the corridor of the pressed body could not be made: the needle feels the one before", said, console);
  const HandMoment& moment = session.moment();
  if (moment.ticks > 0) {
    if (const std::optional<std::string> sentence = body_->look(moment.needle, patient))
      say(*sentence, said, console);
  }
  const std::optional<PreparedCorridor> corridor = body_->next_corridor();
  if (!corridor) return;
  try {
    session.refresh_corridor(*corridor);
    if (corridors_++ == 0)
      say("the body is pressed: the needle feels that, whether it is in or enters, as after every press", said,
          console);
  } catch (const InputError& error) {
    say(fmt::format("the needle cannot enter the body as it is pressed: {}", error.what()), said, console);
  }
}

void MovingPatient::tell(double time, Console& console) const {
  if (most_met_ == 0) {
    console.note(
        "the probe met no node of the mesh: it was not pressed in, or its face is smaller than the mesh is fine; "
        "give "
        "--body \"moving thickness_mm=30\", or make a finer mesh");
  }
  const double rate = static_cast<double>(steps_) / time;
  console.note(fmt::format("the body moved {:.0f} times a second{} and gave the needle {} corridor{}", rate,
                           rate < slow_motion / pace ? " instead of 60, in slow motion," : "", corridors_,
                           corridors_ == 1 ? "" : "s"));
}

}  // namespace bodkin
