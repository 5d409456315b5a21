#include "patient/segmentation/segment_filter.h"

#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"
#include "io/image_worker.h"
#include "io/nrrd_writer.h"
#include "io/shared_memory.h"

namespace bodkin::patient {

namespace {

using nlohmann::json;

const char* name_of(SegmentFilter::Kind kind) {
  switch (kind) {
    case SegmentFilter::Kind::threshold:
      return "threshold";
    case SegmentFilter::Kind::grow:
      return "grow";
    case SegmentFilter::Kind::fill:
      return "fill";
    case SegmentFilter::Kind::smooth:
      return "smooth";
  }
  return "";
}

json numbers_of(const anatomy::Grid& grid) {
  std::vector<double> numbers(grid.spacing.data(), grid.spacing.data() + 3);
  numbers.insert(numbers.end(), grid.direction.data(), grid.direction.data() + 9);
  numbers.insert(numbers.end(), grid.origin.data(), grid.origin.data() + 3);
  return numbers;
}

json rules_json(const PlanningRules& rules) {
  json avoid = json::array();
  for (const AvoidRule& each : rules.avoid) {
    avoid.push_back(
        {{"tissue", each.tissue}, {"structure", each.structure}, {"title", each.title}, {"margin_mm", each.margin}});
  }
  return {{"avoid", avoid},
          {"levels", rules.levels},
          {"bone_margin_mm", rules.bone_margin},
          {"margin_mm", rules.margin},
          {"cord_margin_mm", rules.cord_margin}};
}

// Labels on their way to the worker, removed when read.
class TemporaryLabelFile {
 public:
  TemporaryLabelFile(const anatomy::LabelVolume& labels, const std::filesystem::path& folder)
      : file_(folder.parent_path() / fmt::format(".{}-labels-{}.nrrd", folder.filename().string(), getpid())) {
    io::write_nrrd(labels, file_);
  }
  ~TemporaryLabelFile() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  TemporaryLabelFile(const TemporaryLabelFile&) = delete;
  TemporaryLabelFile& operator=(const TemporaryLabelFile&) = delete;
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

}  // namespace

SegmentMask run_segment_filter(const anatomy::CtVolume& ct, const SegmentMask& mask, const SegmentFilter& filter,
                               const Progress& progress) {
  if (mask.grid.size != ct.grid.size) throw std::invalid_argument("a mask of another size than the CT");
  io::SharedMemory memory("bodkin-segment");
  memory.append(ct.voxels.data(), ct.voxels.size() * sizeof(std::int16_t));
  memory.append(mask.voxels.data(), mask.voxels.size());
  const json request = {{"filter", name_of(filter.kind)},
                        {"size", ct.grid.size},
                        {"numbers", numbers_of(ct.grid)},
                        {"low", filter.low},
                        {"high", filter.high},
                        {"seed", filter.seed},
                        {"reach_mm", filter.reach},
                        {"axis", filter.axis},
                        {"radius_mm", filter.radius}};
  io::run_image_worker_on(memory, "segment", request.dump(), "the segmentation", progress);
  SegmentMask result(mask.grid);
  if (memory.size() != result.voxels.size()) throw SystemError("the segmentation filter returned another size");
  memory.copy_to(result.voxels.data(), result.voxels.size());
  return result;
}

CorrectedCase save_corrected_labels(const std::filesystem::path& folder, const anatomy::LabelVolume& labels,
                                    const std::vector<anatomy::Structure>& table, const PlanningRules& rules,
                                    const Progress& progress) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  const std::filesystem::path place = whole.has_filename() ? whole : whole.parent_path();
  const TemporaryLabelFile written(labels, place);
  json structures = json::array();
  for (const anatomy::Structure& each : table) {
    structures.push_back(
        {{"label", each.label}, {"name", each.name}, {"tissue", each.tissue}, {"critical", each.critical}});
  }
  json request = {{"folder", io::path_text(place)},
                  {"labels", io::path_text(written.file())},
                  {"structures", structures},
                  {"rules", rules_json(rules)}};
  const io::WorkerReport report = io::run_image_worker("case-relabel", request.dump(), place.string(), progress);
  CorrectedCase saved;
  saved.notes = report.notes;
  const json result = json::parse(report.result, nullptr, false);
  if (result.is_object()) saved.changed_tissue_voxels = result.value("changed_tissue_voxels", std::size_t{0});
  return saved;
}

}  // namespace bodkin::patient
