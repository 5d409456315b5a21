#include "session/operator_file.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/resources.h"
#include "io/xml_document.h"

namespace bodkin::session {

namespace {

constexpr std::size_t largest_file = 1 << 20;  // bytes

haptics::HandParameters hand_from(const io::XmlElement& element) {
  haptics::HandParameters hand;
  hand.mass = element.number("mass_kg", hand.mass);
  hand.stiffness = element.number("stiffness_N_per_mm", hand.stiffness);
  hand.damping = element.number("damping_N_s_per_mm", hand.damping);
  hand.inertia = element.number("inertia_kg_mm2", hand.inertia);
  hand.rotation_stiffness = element.number("rotation_stiffness_N_mm_per_rad", hand.rotation_stiffness);
  hand.rotation_damping = element.number("rotation_damping_N_mm_s_per_rad", hand.rotation_damping);
  hand.tremor = element.number("tremor_mm", 0.0);
  hand.tremor_angle = element.number("tremor_deg", 0.0) * degree;
  return hand;
}

// Turns the names of phases into their positions.
class PhaseNames {
 public:
  PhaseNames(const io::XmlElement& root, const std::string& origin) : origin_(origin) {
    for (const io::XmlElement& element : root.children) {
      if (element.name != "phase") continue;
      const std::string name = element.string("name");
      if (name == "end")
        io::fail_at(origin, element.line, "a phase is called 'end', expected another name: 'end' ends the script");
      const auto [earlier, is_new] = positions_.emplace(name, static_cast<int>(positions_.size()));
      if (!is_new)
        io::fail_at(origin, element.line,
                    fmt::format("there is a second phase '{}', expected every name once", name));
    }
  }

  int position(const io::XmlElement& element, const char* attribute) const {
    const std::string name = element.string(attribute, "end");
    if (name == "end") return simulation::OperatorCondition::end;
    const auto found = positions_.find(name);
    if (found != positions_.end()) return found->second;
    io::fail_at(origin_, element.line,
                fmt::format("{} is '{}', expected the name of a phase of this file or 'end'", attribute, name));
  }

 private:
  const std::string& origin_;
  std::map<std::string, int> positions_;
};

simulation::OperatorCondition condition_from(const io::XmlElement& element, const PhaseNames& names,
                                             const std::string& origin) {
  simulation::OperatorCondition condition;
  bool any = false;
  const auto read = [&](const char* attribute, std::optional<double>& value) {
    if (element.find(attribute) == nullptr) return;
    value = element.number(attribute, 0.0);
    any = true;
  };
  read("time_s", condition.time);
  read("travel_mm", condition.travel);
  read("depth_above_mm", condition.depth_above);
  read("depth_below_mm", condition.depth_below);
  read("remaining_below_mm", condition.remaining_below);
  read("force_above_N", condition.force_above);
  read("force_below_N", condition.force_below);
  read("force_drop_N", condition.force_drop);
  read("hardness_above_N_per_mm", condition.hardness_above);
  read("drop_share", condition.drop_share);
  read("force_above_share", condition.force_above_share);
  condition.share_of = element.string("share_of", "");
  if (condition.has_share() == condition.share_of.empty())
    io::fail_at(origin, element.line,
                "drop_share and force_above_share need a tissue, share_of, and it needs one of them");
  if (!any)
    io::fail_at(origin, element.line,
                "this 'until' says nothing to wait for, expected at least one of its conditions");
  condition.next = names.position(element, "then");
  return condition;
}

simulation::OperatorPhase phase_from(const io::XmlElement& element, const PhaseNames& names,
                                     const std::string& origin) {
  simulation::OperatorPhase phase;
  phase.name = element.string("name");
  phase.speed = element.number("speed_mm_per_s", 0.0);
  phase.acceleration = element.number("acceleration_mm_per_s2", phase.acceleration);
  phase.step = element.number("step_mm", 0.0);
  phase.pause = element.number("pause_s", 0.0);
  phase.tilt = element.number("tilt_cephalad_deg", 0.0) * degree;
  phase.shift = element.number("shift_cephalad_mm", 0.0);
  phase.twirl = element.number("twirl_deg", 0.0) * degree;
  phase.twirl_rate = element.number("twirl_Hz", phase.twirl_rate);
  phase.finger = element.boolean("finger", false);
  phase.move_stylet = element.boolean("move_stylet", false);
  phase.move_manometer = element.boolean("move_manometer", false);
  phase.aim_again = element.boolean("aim_again", false);
  phase.at_most = element.integer("at_most", 0);
  phase.otherwise = names.position(element, "otherwise");
  for (const io::XmlElement& until : element.children) phase.until.push_back(condition_from(until, names, origin));
  return phase;
}

nlohmann::ordered_json condition_json(const simulation::OperatorCondition& condition,
                                      const simulation::OperatorScript& script) {
  nlohmann::ordered_json json;
  const auto put = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  put("time_s", condition.time);
  put("travel_mm", condition.travel);
  put("depth_above_mm", condition.depth_above);
  put("depth_below_mm", condition.depth_below);
  put("remaining_below_mm", condition.remaining_below);
  put("force_above_N", condition.force_above);
  put("force_below_N", condition.force_below);
  put("force_drop_N", condition.force_drop);
  put("hardness_above_N_per_mm", condition.hardness_above);
  put("drop_share", condition.drop_share);
  put("force_above_share", condition.force_above_share);
  if (!condition.share_of.empty()) json["share_of"] = condition.share_of;
  json["then"] = condition.next < 0 ? "end" : script.phases[static_cast<std::size_t>(condition.next)].name;
  return json;
}

nlohmann::ordered_json phase_json(const simulation::OperatorPhase& phase, const simulation::OperatorScript& script) {
  nlohmann::ordered_json json = {
      {"name", phase.name},           {"speed_mm_per_s", phase.speed}, {"acceleration_mm_per_s2", phase.acceleration},
      {"step_mm", phase.step},        {"pause_s", phase.pause},        {"tilt_cephalad_deg", phase.tilt / degree},
      {"aim_again", phase.aim_again}, {"at_most", phase.at_most}};
  if (phase.shift != 0.0) json["shift_cephalad_mm"] = phase.shift;
  if (phase.twirl != 0.0) {
    json["twirl_deg"] = phase.twirl / degree;
    json["twirl_Hz"] = phase.twirl_rate;
  }
  if (phase.finger) json["finger"] = true;
  if (phase.move_stylet) json["move_stylet"] = true;
  if (phase.move_manometer) json["move_manometer"] = true;
  json["otherwise"] = phase.otherwise < 0 ? "end" : script.phases[static_cast<std::size_t>(phase.otherwise)].name;
  for (const simulation::OperatorCondition& condition : phase.until)
    json["until"].push_back(condition_json(condition, script));
  return json;
}

}  // namespace

simulation::OperatorScript parse_operator(std::string_view text, const std::string& origin) {
  static const io::XmlSchema schema("operator.xsd");
  const io::XmlElement root = schema.read(text, origin);
  const PhaseNames names(root, origin);
  simulation::OperatorScript script;
  script.name = root.string("name");
  for (const io::XmlElement& element : root.children) {
    if (element.name == "description") {
      script.description = io::one_line(element.text);
    } else if (element.name == "hand") {
      script.hand = hand_from(element);
    } else if (element.name == "accuracy") {
      script.aim_position = element.number("entry_mm", 0.0);
      script.aim_angle = element.number("direction_deg", 0.0) * degree;
      script.wander = element.number("wander_mm", 0.0);
      script.wander_angle = element.number("wander_deg", 0.0) * degree;
      script.unsteadiness = element.number("unsteadiness", 0.0);
    } else if (element.name == "reaction") {
      script.reaction = element.number("time_s", 0.0);
      script.reaction_spread = element.number("spread_s", 0.0);
    } else if (element.name == "start") {
      script.start_distance = element.number("distance_mm", 0.0);
    } else if (element.name == "phase") {
      script.phases.push_back(phase_from(element, names, origin));
    }
  }
  simulation::check(script, origin);
  return script;
}

std::vector<std::string> shipped_operators() {
  std::vector<std::string> names;
  std::error_code failed;
  const std::filesystem::path folder = io::shared_file("operators/expert.xml").parent_path();
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  if (failed) throw SystemError(fmt::format("{} cannot be read: {}", folder.string(), failed.message()));
  std::sort(names.begin(), names.end());
  return names;
}

simulation::OperatorScript load_operator(const std::string& name) {
  const std::vector<std::string> shipped = shipped_operators();
  const bool bundled = std::find(shipped.begin(), shipped.end(), name) != shipped.end();
  const std::filesystem::path file =
      bundled ? io::shared_file("operators/" + name + ".xml") : std::filesystem::path(name);
  if (!bundled && !std::filesystem::exists(file)) {
    throw InputError(fmt::format("--operator is '{}', expected '{}' or the name of an operator file", name,
                                 fmt::join(shipped, "', '")));
  }
  return parse_operator(io::read_text_file(file, largest_file), file.string());
}

std::string operator_json(const simulation::OperatorScript& script) {
  nlohmann::ordered_json json = {{"name", script.name},
                                 {"description", script.description},
                                 {"hand",
                                  {{"mass_kg", script.hand.mass},
                                   {"stiffness_N_per_mm", script.hand.stiffness},
                                   {"damping_N_s_per_mm", script.hand.damping},
                                   {"inertia_kg_mm2", script.hand.inertia},
                                   {"rotation_stiffness_N_mm_per_rad", script.hand.rotation_stiffness},
                                   {"rotation_damping_N_mm_s_per_rad", script.hand.rotation_damping},
                                   {"tremor_mm", script.hand.tremor},
                                   {"tremor_deg", script.hand.tremor_angle / degree}}},
                                 {"accuracy",
                                  {{"entry_mm", script.aim_position},
                                   {"direction_deg", script.aim_angle / degree},
                                   {"wander_mm", script.wander},
                                   {"wander_deg", script.wander_angle / degree},
                                   {"unsteadiness", script.unsteadiness}}},
                                 {"reaction", {{"time_s", script.reaction}, {"spread_s", script.reaction_spread}}},
                                 {"start", {{"distance_mm", script.start_distance}}}};
  for (const simulation::OperatorPhase& phase : script.phases) json["phases"].push_back(phase_json(phase, script));
  return json.dump();
}

}  // namespace bodkin::session
