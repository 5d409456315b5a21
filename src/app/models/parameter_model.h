#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "views/open_case.h"

#include "core/parameter.h"
#include "forces/model_settings.h"

namespace bodkin::app {

using namespace views;

using forces::ModelSettings;

// One number, as one step of the wizard. Range, unit, description and origin are those of the parameter's
// declaration.
struct SettingStep {
  forces::ModelPart place = forces::ModelPart::resistance;
  anatomy::TissueId tissue = anatomy::tissue::air;  // of ModelPart::tissue; for relaxation, its index
  std::string name;                                 // "break_force_N"
  std::string title;                                // "Skin: break force"
  std::string question;                             // one sentence
  std::string description;                          // from the declaration: "H, at which the tissue gives way"
  std::string unit;                                 // "N"; empty: none; unit of all members below
  double size_of_unit = 1.0;                        // in the unit of the declaration
  Range range;                                      // allowed values
  double low = 0.0, high = 1.0;                     // of the slider, within the range
  double grain = 0.01;                              // one unit of the last digit shown
  int digits = 2;                                   // after the point
  Origin origin = Origin::choice;                   // of the default
  std::string source;                               // of its numbers, from the tissue library; may be empty
};

// A parameter's name for display: "break_force_N" of unit "N" is "break force".
std::string parameter_words(std::string_view name, std::string_view unit);

// The settings of a patient's force model, step by step, with undo. The steps of `layered` are the eleven of the
// acupuncture simulator (Heng et al. 2004), or all of its numbers; every other model has a step for each declared
// number, of the tissues on the planned path, and of the parts added by the case, such as its syringe.
class ParameterModel {
 public:
  explicit ParameterModel(std::shared_ptr<const OpenCase> patient);

  // The available models: those without a deformable body, and the patient's original one.
  std::vector<std::string_view> models() const;
  std::string_view model() const;
  // With its default settings, or the patient's original settings for the original model; tissues and parts valid for
  // any model are kept. Can be undone. Throws InputError for an unknown name.
  void choose_model(std::string_view name);
  // All numbers instead of the eleven; affects only `layered`.
  void show_all(bool all);
  bool shows_all() const { return all_; }

  const std::vector<SettingStep>& steps() const { return steps_; }
  // In the unit of the step, as are all values here.
  double value(std::size_t step) const;
  double before(std::size_t step) const;  // of the reference
  // Empty, or the reason for rejecting the value; then nothing has changed. `continues`: part of the same gesture as
  // the last change, and undone with it.
  std::string set(std::size_t step, double value, bool continues = false);
  void reset(std::size_t step);

  bool can_undo() const { return !undone_from_.empty(); }
  bool can_redo() const { return !redone_from_.empty(); }
  void undo();
  void redo();

  const ModelSettings& now() const { return now_; }
  const ModelSettings& reference() const { return reference_; }
  bool is_changed() const;

  // Loads the tissues of a library file; keeps tissues whose ids the file lacks. Throws InputError.
  void load(const std::filesystem::path& file);
  // The same from a library. `continues`: as for set().
  void take(const anatomy::TissueLibrary& library, bool continues);
  // The tissues that differ from the reference, and air, which every library has; empty if none differs.
  anatomy::TissueLibrary changed_tissues() const;
  // All tissues as a library file. Throws SystemError.
  void save(const std::filesystem::path& file) const;

 private:
  void find_steps();
  void remember(bool continues);

  std::shared_ptr<const OpenCase> patient_;
  ModelSettings reference_, now_;
  std::vector<anatomy::TissueId> on_path_;
  std::vector<SettingStep> steps_;
  std::vector<ModelSettings> undone_from_, redone_from_;
  bool all_ = false;
};

}  // namespace bodkin::app
