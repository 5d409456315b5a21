#include <memory>

#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/new_case_options.h"
#include "core/error.h"
#include "io/image_worker.h"

namespace bodkin::cli {
namespace {

struct CaseNewOptions {
  NewCaseOptions common;
  std::string ct, labels, scheme, tissues, level, lowest_vertebra, conus;
  double age = -1.0;
  std::int64_t series = 0;
  bool resample_labels = false, fill_missing = false, assume_hu = false;
};

constexpr const char* case_new_footer = R"(Examples:
  bodkin case new patient --ct dicom_folder
  bodkin case new patient --ct ct.nii.gz --labels totalsegmentator.nii.gz
  bodkin case new patient --ct ct.nrrd --labels vertebrae.nii.gz --scheme tptbox
  bodkin case new patient --ct ct.mha --labels mine.nrrd --scheme mine.csv
  bodkin case new patient --ct ct.mha --labels mine.nrrd --scheme mine.csv --tissues mine.xml
  bodkin case new patient --ct ct.nii.gz --level L4_L5
  bodkin case new patient --ct ct.nii.gz --lowest-vertebra L5
  bodkin case new patient --ct ct.nii.gz --labels totalsegmentator.nii.gz --procedure ct_guided_biopsy \
                          --target liver_lesion --needle 18,150,chiba
  bodkin case new patient --ct dicom_folder --series 2 --entry 4.5,-45,293 --target 3,-117.5,294

The geometry of the CT is kept exactly. Nothing is flipped or resampled, except slices that do not form a regular grid
(gantry tilt, uneven steps); a note then says so. docs/importing.md has the rules.)";

void run_case_new(const CaseNewOptions& options, const CommandContext& context) {
  nlohmann::json request = new_case_request(options.common);
  request["ct"] = io::path_text(options.ct);
  if (!options.labels.empty()) {
    request["labels"] = io::path_text(options.labels);
    if (!options.scheme.empty()) request["scheme"] = io::path_text(options.scheme);
  } else if (!options.scheme.empty() || options.resample_labels) {
    throw InputError("--scheme and --resample-labels need a segmentation; give its file with --labels");
  }
  if (!options.tissues.empty()) request["tissues"] = io::path_text(options.tissues);
  if (!options.level.empty()) {
    if (!options.common.target.empty())
      throw InputError(
          "--level plans a path through an interspace, --target a path to a given point; give only one of them");
    request["level"] = options.level;
  }
  if (!options.lowest_vertebra.empty()) request["lowest_vertebra"] = options.lowest_vertebra;
  if (!options.conus.empty()) request["conus"] = options.conus;
  if (options.age >= 0.0) request["age"] = options.age;
  if (options.series != 0) request["series"] = options.series;
  request["resample_labels"] = options.resample_labels;
  request["fill_missing"] = options.fill_missing;
  request["assume_hu"] = options.assume_hu;
  make_case("case-new", request, options.ct, context);
}

}  // namespace

void add_case_new_command(CLI::App& case_group, CommandContext& context) {
  add_command(
      case_group, "new", "Make a case from a CT, with or without labels", case_new_footer,
      [&context](CLI::App& command) {
        const auto options = std::make_shared<CaseNewOptions>();
        add_new_case_options(command, options->common);
        add_text(command, "--ct", options->ct, "CT: DICOM folder, NIfTI, NRRD or MetaImage").required();
        add_text(command, "--labels", options->labels,
                 "Segmentation of this CT, in any of the same formats, or a DICOM segmentation or structure set");
        add_text(
            command, "--scheme", options->scheme,
            "What the labels mean: totalsegmentator, totalsegmentator_v1, tptbox, or a CSV file with the columns "
            "label,name,tissue,critical (default: the names in the file, else totalsegmentator)");
        add_text(
            command, "--tissues", options->tissues,
            "Tissue library of the case, XML, with Bodkin's own tissues and yours (default: the one that comes with "
            "Bodkin)");
        add_text(command, "--level", options->level,
                 "Interspace to plan the puncture at, such as L4_L5 (default: L3_L4, L4_L5 or L2_L3, never higher "
                 "unless named here)");
        add_text(command, "--lowest-vertebra", options->lowest_vertebra,
                 "Vertebra above the lowest interspace in the CT, such as L5, for a CT in which the levels cannot be "
                 "determined");
        add_text(
            command, "--conus", options->conus,
            "Where the spinal cord ends: a vertebra (at its middle) or an interspace (default: lower third of L1)");
        add_number(command, "--age", options->age, 0.0, 120.0, "Years, 0 to 120: below 2 the spinal cord ends lower")
            .without_default();
        add_whole_number(command, "--series", options->series, 1, 100000,
                         "Number of the series in a DICOM folder, from 1, in the order of the list")
            .without_default();
        add_switch(command, "--resample-labels", options->resample_labels,
                   "Take the nearest label at each CT voxel when the labels lie on other voxels");
        add_switch(command, "--fill-missing", options->fill_missing, "Interpolate missing slices");
        add_switch(command, "--assume-hu", options->assume_hu,
                   "Take the values as HU even if they do not look like it");
        on_run(command, [options, &context] { run_case_new(*options, context); });
      });
}

}  // namespace bodkin::cli
