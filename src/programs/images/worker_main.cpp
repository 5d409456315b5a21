// bodkin-images: the image worker (see io/image_worker.h). `bodkin-images VERB` reads one JSON object from standard
// input and writes one JSON object per line to standard output: {"progress", "fraction"}, {"note"}, {"error",
// "kind"}, {"result"}. Bodkin starts it; it is not for users.

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "patient/from_ct/case_builder.h"
#include "patient/from_ct/label_filters.h"
#include "patient/from_ct/relabel.h"
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"
#include "io/force_choice.h"
#include "io/images/image_source.h"

namespace bodkin::programs {
namespace {

using nlohmann::json;

constexpr int voxel_descriptor = 3;  // inherited shared memory that takes the voxels of `read`

void send_message(const json& message) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  std::cout << message.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
}

void report_progress(std::string_view stage, double fraction) {
  send_message({{"progress", std::string(stage)}, {"fraction", fraction}});
}

json point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// Doubles survive JSON to the bit: nlohmann writes the shortest text that does so.
json grid_json(const anatomy::Grid& grid) {
  std::vector<double> numbers(grid.spacing.data(), grid.spacing.data() + 3);
  numbers.insert(numbers.end(), grid.direction.data(), grid.direction.data() + 9);
  numbers.insert(numbers.end(), grid.origin.data(), grid.origin.data() + 3);
  return {{"size", grid.size}, {"numbers", numbers}};
}

template <typename Voxel>
void hand_over(const anatomy::Volume<Voxel>& volume) {
  const char* bytes = reinterpret_cast<const char*>(volume.voxels.data());
  std::size_t left = volume.voxels.size() * sizeof(Voxel);
  while (left > 0) {
    const ssize_t count = write(voxel_descriptor, bytes, left);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw SystemError("the voxels cannot be handed over: no memory");
    bytes += count;
    left -= static_cast<std::size_t>(count);
  }
  send_message({{"result", grid_json(volume.grid)}});
}

void read_image(const json& request) {
  const std::filesystem::path path = request.at("path").get<std::string>();
  const std::string kind = request.at("kind");
  if (kind == "ct") {
    const io::CtImage image = io::read_ct(path, {}, report_progress);
    for (const std::string& note : image.notes) send_message({{"note", note}});
    hand_over(image.ct);
  } else if (kind == "labels") {
    hand_over(io::read_labels(path, report_progress));
  } else {
    hand_over(io::read_tissues(path));
  }
}

Vec3 point_from(const json& value) {
  const auto numbers = value.get<std::array<double, 3>>();
  return {numbers[0], numbers[1], numbers[2]};
}

patient::NewCase new_case(const json& request) {
  patient::NewCase wanted;
  wanted.folder = request.at("folder").get<std::string>();
  wanted.overwrite = request.value("overwrite", false);
  wanted.name = request.value("name", "");
  wanted.needle_gauge = request.value("needle_gauge", wanted.needle_gauge);
  wanted.needle = request.value("needle", "");
  if (const std::string mechanics = request.value("mechanics", ""); !mechanics.empty())
    parse_value(mechanics, wanted.mechanics);
  if (request.contains("parts"))
    wanted.parts = io::parse_parts(request["parts"].get<std::vector<std::string>>(), "--part");
  parse_value(request.value("force_in_organs", "felt"), wanted.force_in_organs);
  wanted.procedure = request.value("procedure", "");
  wanted.target_tissue = request.value("target_tissue", "");
  wanted.target_structure = request.value("target_structure", "");
  for (const json& each : request.value("avoid", json::array())) {
    wanted.rules.avoid.push_back({each.value("tissue", ""), each.value("structure", ""), each.value("title", ""),
                                  each.value("margin_mm", 0.0)});
  }
  wanted.rules.levels = request.value("levels", std::vector<std::string>());
  if (request.contains("target") && !request.contains("entry")) wanted.target = point_from(request.at("target"));
  if (request.contains("entry")) {
    wanted.path = anatomy::NeedlePath{point_from(request.at("entry")), point_from(request.at("target"))};
  }
  return wanted;
}

json summary_json(const patient::CaseSummary& summary) {
  json tissues = json::array();
  for (const patient::TissueAmount& amount : summary.amounts) {
    tissues.push_back({{"tissue", amount.title}, {"volume_ml", amount.millilitres}});
  }
  json landmarks = json::array();
  for (const anatomy::Landmark& landmark : summary.description.landmarks) {
    landmarks.push_back({{"name", landmark.name}, {"position_mm", point(landmark.position)}});
  }
  json result = {{"name", summary.description.name},
                 {"size", summary.ct.size},
                 {"spacing_mm", point(summary.ct.spacing)},
                 {"axes", summary.ct.axes()},
                 {"origin_mm", point(summary.ct.origin)},
                 {"tissue_spacing_mm", point(summary.tissues.spacing)},
                 {"structures", summary.description.structures.size()},
                 {"tissues", tissues},
                 {"landmarks", landmarks},
                 {"notes", summary.description.notes}};
  if (const auto& path = summary.description.procedure.path) {
    result["path"] = {
        {"entry_mm", point(path->entry)}, {"target_mm", point(path->target)}, {"length_mm", path->length()}};
  }
  return result;
}

void finish_case(const patient::CaseSummary& summary) {
  for (const std::string& note : summary.description.notes) send_message({{"note", note}});
  send_message({{"result", summary_json(summary)}});
}

void make_imported_case(const json& request) {
  patient::ImportOptions options;
  options.ct = request.at("ct").get<std::string>();
  options.labels = request.value("labels", "");
  options.scheme = request.value("scheme", options.scheme);
  options.tissues = request.value("tissues", "");
  if (request.contains("series")) options.series = request.at("series").get<int>();
  options.resample_labels = request.value("resample_labels", false);
  options.fill_missing = request.value("fill_missing", false);
  options.assume_hounsfield = request.value("assume_hu", false);
  options.level = request.value("level", "");
  options.lowest_vertebra = request.value("lowest_vertebra", "");
  options.conus = request.value("conus", "");
  if (request.contains("age")) options.age = request.at("age").get<double>();
  finish_case(patient::build_imported_case(new_case(request), options, report_progress));
}

void make_synthetic_case(const json& request) {
  patient::LumbarParameters parameters;
  parameters.seed = request.value("seed", parameters.seed);
  parameters.age = request.value("age", parameters.age);
  parameters.height = request.value("height", parameters.height);
  parameters.weight = request.value("weight", parameters.weight);
  parameters.flexion = request.value("flexion", parameters.flexion);
  parameters.scoliosis = request.value("scoliosis", parameters.scoliosis);
  parameters.calcification = request.value("calcification", parameters.calcification);
  parameters.lesion = request.value("lesion", parameters.lesion);
  parameters.spacing = request.value("spacing", parameters.spacing);
  finish_case(patient::build_synthetic_case(new_case(request), parameters, report_progress));
}

void list_series(const json& request) {
  const io::DicomFolder folder = io::scan_dicom(request.at("path").get<std::string>(), report_progress);
  json series = json::array();
  for (const io::DicomSeries& one : folder.series) {
    series.push_back({{"number", one.number},
                      {"description", one.description},
                      {"modality", one.modality},
                      {"slices", one.slices.size()},
                      {"columns", one.columns},
                      {"rows", one.rows},
                      {"folder", one.slices.front().file.parent_path().string()}});
  }
  send_message({{"result", {{"series", series}, {"other_objects", folder.other_objects.size()}}}});
}

template <typename Voxel>
void take_over(anatomy::Volume<Voxel>& volume, off_t offset) {
  char* bytes = reinterpret_cast<char*>(volume.voxels.data());
  std::size_t left = volume.voxels.size() * sizeof(Voxel);
  while (left > 0) {
    const ssize_t count = pread(voxel_descriptor, bytes, left, offset);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw SystemError("the voxels did not arrive");
    bytes += count;
    offset += count;
    left -= static_cast<std::size_t>(count);
  }
}

anatomy::Grid grid_from(const json& request) {
  anatomy::Grid grid;
  grid.size = request.at("size").get<std::array<int, 3>>();
  const auto numbers = request.at("numbers").get<std::array<double, 15>>();
  std::copy_n(numbers.begin(), 3, grid.spacing.data());
  std::copy_n(numbers.begin() + 3, 9, grid.direction.data());
  std::copy_n(numbers.begin() + 12, 3, grid.origin.data());
  return grid;
}

// The shared memory holds the CT, then the mask; afterwards only the new mask.
void filter_segment(const json& request) {
  anatomy::CtVolume ct(grid_from(request));
  patient::MaskVolume mask(ct.grid);
  take_over(ct, 0);
  take_over(mask, static_cast<off_t>(ct.voxels.size() * sizeof(std::int16_t)));
  const std::string filter = request.at("filter");
  const int low = request.at("low"), high = request.at("high");
  const patient::SegmentReach within = {request.at("seed").get<std::array<int, 3>>(), request.at("reach_mm")};
  if (filter == "threshold") {
    mask = patient::threshold_region(ct, low, high, within);
  } else if (filter == "grow") {
    mask = patient::grown_region(ct, low, high, within);
  } else if (filter == "fill") {
    mask = patient::filled_between_slices(mask, request.at("axis"));
  } else if (filter == "smooth") {
    mask = patient::smoothed(mask, request.at("radius_mm"));
  } else {
    throw SystemError("bodkin-images knows no filter '" + filter + "'");
  }
  if (ftruncate(voxel_descriptor, 0) != 0 || lseek(voxel_descriptor, 0, SEEK_SET) != 0)
    throw SystemError("the voxels cannot be handed over");
  hand_over(mask);
}

void relabel(const json& request) {
  patient::Relabelling wanted;
  wanted.folder = request.at("folder").get<std::string>();
  wanted.labels = request.at("labels").get<std::string>();
  for (const json& each : request.at("structures")) {
    wanted.table.push_back({each.at("label"), each.at("name"), each.at("tissue"), each.at("critical")});
  }
  const json& rules = request.at("rules");
  for (const json& each : rules.at("avoid")) {
    wanted.rules.avoid.push_back({each.value("tissue", ""), each.value("structure", ""), each.value("title", ""),
                                  each.value("margin_mm", 0.0)});
  }
  wanted.rules.levels = rules.at("levels").get<std::vector<std::string>>();
  wanted.rules.bone_margin = rules.at("bone_margin_mm");
  wanted.rules.margin = rules.at("margin_mm");
  wanted.rules.cord_margin = rules.at("cord_margin_mm");
  const patient::RelabelledCase saved = patient::relabel_case(wanted, report_progress);
  for (const std::string& note : saved.notes) send_message({{"note", note}});
  send_message({{"result", {{"changed_tissue_voxels", saved.changed_tissue_voxels}}}});
}

int run(const std::string& verb) {
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const json request = json::parse(text);
  if (verb == "read") {
    read_image(request);
  } else if (verb == "case-new") {
    make_imported_case(request);
  } else if (verb == "case-synthesize") {
    make_synthetic_case(request);
  } else if (verb == "case-relabel") {
    relabel(request);
  } else if (verb == "segment") {
    filter_segment(request);
  } else if (verb == "list-series") {
    list_series(request);
  } else {
    throw SystemError("bodkin-images does not know '" + verb +
                      "'; it is another version than the program that called it");
  }
  return 0;
}

int fail(const std::string& sentence, const char* kind) {
  send_message({{"error", sentence}, {"kind", kind}});
  return kind == std::string("system") ? 1 : 2;
}

}  // namespace
}  // namespace bodkin::programs

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("bodkin-images is started by bodkin; run 'bodkin case new --help'\n", stderr);
    return 1;
  }
  try {
    return bodkin::programs::run(argv[1]);
  } catch (const bodkin::InputError& error) {
    return bodkin::programs::fail(error.what(), "input");
  } catch (const bodkin::SystemError& error) {
    return bodkin::programs::fail(error.what(), "system");
  } catch (const std::bad_alloc&) {
    return bodkin::programs::fail("out of memory", "memory");
  } catch (const std::length_error&) {
    return bodkin::programs::fail("out of memory", "memory");
  } catch (const std::exception& error) {
    return bodkin::programs::fail(error.what(), "system");
  }
}
