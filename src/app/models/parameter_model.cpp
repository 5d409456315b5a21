#include "app/models/parameter_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "core/settings_check.h"
#include "io/tissue_library_file.h"

namespace bodkin::app {

namespace {

using Place = forces::ModelPart;

// Models applicable to any patient: those without a deformable body. The needle cannot pass the surface of
// `surface_proxy`, and registered models have no settings of known names.
std::vector<std::string_view> rigid_models() {
  std::vector<std::string_view> names;
  const auto add = [&names]<std::size_t... index>(std::index_sequence<index...>) {
    const auto add_one = [&names](const anatomy::ResistanceSettings& settings) {
      const bool excluded = std::holds_alternative<anatomy::SurfaceProxySettings>(settings) ||
                            std::holds_alternative<anatomy::RegisteredSettings>(settings);
      if (!excluded && anatomy::body_of(settings) == nullptr) names.push_back(anatomy::name_of(settings));
    };
    (add_one(std::variant_alternative_t<index, anatomy::ResistanceSettings>{}), ...);
  };
  add(std::make_index_sequence<std::variant_size_v<anatomy::ResistanceSettings>>{});
  return names;
}

// The eleven steps of the acupuncture simulator's wizard.
struct UsualStep {
  Place place;
  anatomy::TissueId tissue;
  std::string_view name;  // prefix of the parameter's name
  std::string_view question;
};
constexpr std::array usual_steps = {
    UsualStep{Place::weight, 0, "weight_N", "How heavy is the stylus, whose weight the hand should not feel?"},
    UsualStep{Place::tissue, anatomy::tissue::skin, "stiffness", "How stiff is the skin before it gives way?"},
    UsualStep{Place::tissue, anatomy::tissue::skin, "break_force_N",
              "How hard must one push before the skin gives way?"},
    UsualStep{Place::tissue, anatomy::tissue::skin, "static_friction", "How firmly does the skin grip the shaft?"},
    UsualStep{Place::tissue, anatomy::tissue::fat, "drag", "How viscous is the fat?"},
    UsualStep{Place::tissue, anatomy::tissue::muscle, "stiffness", "How stiff is the muscle before it gives way?"},
    UsualStep{Place::tissue, anatomy::tissue::muscle, "static_friction",
              "How firmly does the muscle grip a needle at rest?"},
    UsualStep{Place::tissue, anatomy::tissue::muscle, "dynamic_friction",
              "How much does the muscle resist a needle that slides?"},
    UsualStep{Place::tissue, anatomy::tissue::muscle, "roughness", "How rough does the needle feel as it slides?"},
    UsualStep{Place::tissue, anatomy::tissue::cortical_bone, "contact_stiffness", "How hard is bone?"},
    UsualStep{Place::constraint, 0, "", "How firmly does the body hold the needle on its path?"}};

// The display names of the parts that a case adds to its resistance, in the order of forces::added_parts.
constexpr auto part_titles = std::to_array<std::string_view>(
    {"Relaxation", "Shaft friction", "Winding up", "Bevel", "Fluid", "Syringe", "Finger"});
static_assert(part_titles.size() == forces::added_parts.size());

std::string part_words(Place place, std::size_t index) {
  const std::size_t part = static_cast<std::size_t>(place) - static_cast<std::size_t>(Place::relaxation);
  return place == Place::relaxation ? fmt::format("{} {}", part_titles[part], index + 1)
                                    : std::string(part_titles[part]);
}

// Parameters of a specific model, not common to all.
void give_own_parts(anatomy::ForceParts& to, const anatomy::ForceParts& from) {
  to.relaxation = from.relaxation;
  to.shaft_friction = from.shaft_friction;
  to.needle_grasp = from.needle_grasp;
}

// The number of a step, where it is used; null if there is none.
template <typename Settings>
auto* number_at(Settings& settings, const SettingStep& step) {
  using Number = std::conditional_t<std::is_const_v<Settings>, const double, double>;
  Number* found = nullptr;
  forces::visit_part(settings, step.place, step.tissue, [&](auto& owner) {
    const std::string_view word = alternative_of(owner);
    for_each_parameter(
        [&](const auto& parameter, auto& value) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
            if (parameter.name == step.name && counts_for(parameter, word)) found = &value;
          }
        },
        owner);
  });
  return found;
}

std::string capitalised(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

// Fluids are a thousand million times less viscous than the unit of stress and time: nobody reads nine zeros.
void use_readable_unit(SettingStep& step) {
  if (step.unit != "MPa s") return;
  step.unit = "mPa s";
  step.size_of_unit = 1e-9;
  step.range.low /= step.size_of_unit;
  step.range.high /= step.size_of_unit;
}

// Range of a slider around a value: wide enough to feel a difference, within the permitted limits.
void span_slider(SettingStep& step, double value) {
  constexpr double wide = 3.0;
  const double size =
      value != 0.0 ? std::abs(value) : std::min(1.0, std::isfinite(step.range.high) ? step.range.high : 1.0);
  step.low = std::max(step.range.low, step.range.low < 0.0 ? -wide * size : 0.0);
  step.high = std::min(step.range.high, wide * size);
  if (step.high <= step.low) step.high = step.low + size;
  step.digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 8);
  step.grain = std::pow(10.0, -step.digits);
  if (!step.range.includes_low && step.low <= step.range.low) step.low = step.range.low + step.grain;
  if (!step.range.includes_high && step.high >= step.range.high) step.high = step.range.high - step.grain;
}

bool same_library(const std::vector<anatomy::TissueProperties>& a, const std::vector<anatomy::TissueProperties>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& one, const auto& other) { return same_parameters(one, other); });
}

}  // namespace

std::string parameter_words(std::string_view name, std::string_view unit) {
  std::string words(name_without_unit(name, unit));
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

ParameterModel::ParameterModel(std::shared_ptr<const OpenCase> patient) : patient_(std::move(patient)) {
  const anatomy::Case& opened = patient_->patient;
  now_ = reference_ = forces::model_settings(opened);
  if (const std::optional<anatomy::NeedlePath>& path = opened.description.procedure.path) {
    constexpr double stride = 0.25;  // mm
    for (double depth = 0.0; depth <= path->length(); depth += stride) {
      const anatomy::TissueId id =
          anatomy::nearest(opened.tissues, Vec3(path->entry + depth * path->direction()), anatomy::tissue::air);
      const bool is_new = std::find(on_path_.begin(), on_path_.end(), id) == on_path_.end();
      if (id != anatomy::tissue::air && is_new) on_path_.push_back(id);
    }
  }
  find_steps();
}

std::vector<std::string_view> ParameterModel::models() const {
  std::vector<std::string_view> names = rigid_models();
  const std::string_view own = anatomy::name_of(reference_.haptics.resistance);
  if (std::find(names.begin(), names.end(), own) == names.end()) names.push_back(own);
  return names;
}

std::string_view ParameterModel::model() const {
  return anatomy::name_of(now_.haptics.resistance);
}

void ParameterModel::choose_model(std::string_view name) {
  if (name == model()) return;
  anatomy::ResistanceSettings chosen;
  bool found = false;
  const auto make = [&]<std::size_t... index>(std::index_sequence<index...>) {
    ((anatomy::resistance_names[index] == name ? (chosen.emplace<index>(), found = true) : false), ...);
  };
  make(std::make_index_sequence<std::variant_size_v<anatomy::ResistanceSettings>>{});
  if (!found) throw InputError(fmt::format("there is no force model '{}'", name));
  remember(false);
  if (name == anatomy::name_of(reference_.haptics.resistance)) {
    now_.haptics.resistance = reference_.haptics.resistance;
    give_own_parts(now_.haptics.parts, reference_.haptics.parts);
  } else {
    anatomy::CaseDescription with = patient_->patient.description;
    with.haptics.resistance = std::move(chosen);
    now_.haptics.resistance = forces::model_settings(with, patient_->patient.library).haptics.resistance;
    give_own_parts(now_.haptics.parts, {});
  }
  find_steps();
}

void ParameterModel::show_all(bool all) {
  all_ = all;
  find_steps();
}

void ParameterModel::find_steps() {
  steps_.clear();
  const auto add_all = [this](Place place, anatomy::TissueId id, const std::string& group, const std::string& source,
                              std::string_view only, std::string_view question) {
    forces::visit_part(std::as_const(now_), place, id, [&](const auto& owner) {
      const std::string_view word = alternative_of(owner);
      for_each_parameter(
          [&](const auto& parameter, const auto& value) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
              if (!counts_for(parameter, word) || !parameter.name.starts_with(only)) return;
              if (!question.empty() && !steps_.empty() && steps_.back().question == question)
                return;  // the first one
              SettingStep step;
              step.place = place;
              step.tissue = id;
              step.name = parameter.name;
              const std::string words = parameter_words(parameter.name, parameter.unit);
              step.title = fmt::format("{}: {}", group, words);
              step.question = question.empty() ? fmt::format("{}: {}", group, words) : std::string(question);
              step.description = parameter.description;
              step.unit = parameter.unit;
              step.range = parameter.range;
              step.origin = parameter.origin;
              step.source = source;
              const double* const was = number_at(std::as_const(reference_), step);
              use_readable_unit(step);
              span_slider(step, (was != nullptr ? *was : value) / step.size_of_unit);
              steps_.push_back(std::move(step));
            }
          },
          owner);
    });
  };
  const auto tissue_called = [this](anatomy::TissueId id) {
    return std::find_if(now_.tissues.begin(), now_.tissues.end(),
                        [id](const auto& tissue) { return tissue.id == id; });
  };
  const auto add_tissue = [&](anatomy::TissueId id, std::string_view only, std::string_view question) {
    const auto tissue = tissue_called(id);
    if (tissue != now_.tissues.end())
      add_all(Place::tissue, id, capitalised(tissue->title), tissue->source, only, question);
  };
  if (model() == "layered" && !all_) {
    for (const UsualStep& usual : usual_steps) {
      if (usual.place == Place::tissue)
        add_tissue(usual.tissue, usual.name, usual.question);
      else
        add_all(usual.place, 0, usual.place == Place::weight ? "Stylus" : "Path", {}, usual.name, usual.question);
    }
    return;
  }
  add_all(Place::resistance, 0, "Model", {}, {}, {});
  for (const anatomy::TissueId id : on_path_) add_tissue(id, {}, {});
  add_all(Place::constraint, 0, "Path", {}, {}, {});
  for (const Place place : forces::added_parts) {
    const std::size_t count = place == Place::relaxation ? now_.haptics.parts.relaxation.size() : 1;
    for (std::size_t index = 0; index < count; ++index)
      add_all(place, static_cast<anatomy::TissueId>(index), part_words(place, index), {}, {}, {});
  }
}

double ParameterModel::value(std::size_t step) const {
  const double* const number = number_at(now_, steps_.at(step));
  return number == nullptr ? 0.0 : *number / steps_.at(step).size_of_unit;
}

double ParameterModel::before(std::size_t step) const {
  const double* const number = number_at(reference_, steps_.at(step));
  // A different model has no previous value.
  return number == nullptr ? value(step) : *number / steps_.at(step).size_of_unit;
}

std::string ParameterModel::set(std::size_t step, double value, bool continues) {
  const SettingStep& asked = steps_.at(step);
  ModelSettings changed = now_;
  double* const number = number_at(changed, asked);
  const double wanted = value * asked.size_of_unit;
  if (number == nullptr || *number == wanted) return {};
  *number = wanted;
  try {
    forces::visit_part(std::as_const(changed), asked.place, asked.tissue,
                       [&](const auto& owner) { check(owner, asked.title); });
    check(changed.haptics.parts, asked.title);  // the shares of relaxation together
  } catch (const InputError& refused) {
    return refused.what();
  }
  remember(continues);
  now_ = std::move(changed);
  return {};
}

void ParameterModel::reset(std::size_t step) {
  set(step, before(step));
}

void ParameterModel::remember(bool continues) {
  redone_from_.clear();
  if (!continues || undone_from_.empty()) undone_from_.push_back(now_);
}

void ParameterModel::undo() {
  if (!can_undo()) return;
  redone_from_.push_back(std::exchange(now_, std::move(undone_from_.back())));
  undone_from_.pop_back();
  find_steps();
}

void ParameterModel::redo() {
  if (!can_redo()) return;
  undone_from_.push_back(std::exchange(now_, std::move(redone_from_.back())));
  redone_from_.pop_back();
  find_steps();
}

bool ParameterModel::is_changed() const {
  const auto differs = [this](Place place) {
    bool same = true;
    forces::visit_part(now_, place, 0, [&](const auto& owner) {
      forces::visit_part(reference_, place, 0, [&](const auto& other) {
        if constexpr (std::is_same_v<decltype(owner), decltype(other)>) same = same_parameters(owner, other);
      });
    });
    return !same;
  };
  return model() != anatomy::name_of(reference_.haptics.resistance) || differs(Place::resistance) ||
         differs(Place::constraint) || differs(Place::weight) ||
         !same_parameters(now_.haptics.parts, reference_.haptics.parts) ||
         !same_library(now_.tissues, reference_.tissues);
}

void ParameterModel::load(const std::filesystem::path& file) {
  take(io::read_tissue_library(file), false);
}

void ParameterModel::take(const anatomy::TissueLibrary& library, bool continues) {
  // With a physical description, the value for the needle, as all numbers here.
  const std::vector<anatomy::TissueProperties> felt =
      forces::model_settings(patient_->patient.description, library).tissues;
  remember(continues);
  for (anatomy::TissueProperties& tissue : now_.tissues) {
    const auto loaded =
        std::find_if(felt.begin(), felt.end(), [&](const auto& each) { return each.id == tissue.id; });
    if (loaded != felt.end()) tissue = *loaded;
  }
  find_steps();
}

anatomy::TissueLibrary ParameterModel::changed_tissues() const {
  std::vector<anatomy::TissueProperties> changed;
  bool differs = false;
  for (std::size_t i = 0; i < now_.tissues.size(); ++i) {
    const bool is_changed = !same_parameters(now_.tissues[i], reference_.tissues[i]);
    differs = differs || is_changed;
    if (is_changed || now_.tissues[i].id == anatomy::tissue::air) changed.push_back(now_.tissues[i]);
  }
  if (!differs) return {};
  return anatomy::TissueLibrary(std::move(changed));
}

void ParameterModel::save(const std::filesystem::path& file) const {
  write_file(file, io::tissue_library_xml(anatomy::TissueLibrary(now_.tissues)));
}

}  // namespace bodkin::app
