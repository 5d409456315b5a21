#include "io/image_worker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/deferred_termination.h"
#include "io/partial_folder.h"
#include "io/shared_memory.h"
#include "io/temporary_folder.h"
#include "io/text_encoding.h"
#include "io/worker_program.h"

namespace bodkin::io {
namespace {

using nlohmann::json;

const WorkerProgram image_program{"bodkin-images", "BODKIN_IMAGES_WORKER", "BODKIN_IMAGES"};

// For the worker. The largest import (a 512-million-voxel CT) needs less address space; the limit justified by a
// file's size is checked inside, before memory is allocated.
ChildLimits limits() {
  ChildLimits result;
#ifndef BODKIN_ADDRESS_SANITIZER  // its shadow memory alone is larger
  result.memory = 6ULL << 30U;
#endif
  return result;
}

// The message for a worker that ended without one.
std::string child_failure(const ChildResult& child, const std::string& subject) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(subject, ignored);
  switch (child.end) {
    case ChildEnd::out_of_time:
      return fmt::format("{}: reading this took too long and was given up; it is damaged or far too large", subject);
    case ChildEnd::killed:
      return fmt::format("{}: the imaging library crashed on {} ({}); it is damaged, or not what its name says",
                         subject, is_folder ? "a file in this folder" : "this", strsignal(child.signal));
    case ChildEnd::interrupted:
    case ChildEnd::exited:
      break;
  }
  return fmt::format("{}: the imaging library ended on this without a message (exit code {}); it is damaged", subject,
                     child.exit_code);
}

// The incomplete output of a dead worker is useless.
void clear_away(const json& request, pid_t worker) {
  if (!request.contains("folder")) return;
  std::error_code ignored;
  std::filesystem::remove_all(partial_name(request.value("folder", ""), worker), ignored);
}

WorkerReport run_reader(const std::string& verb, const std::string& arguments, const std::string& subject,
                        const Progress& progress, int inherited) {
  const DeferredTermination deferred;  // ends this process, if a signal asked for it, once everything is removed
  const WorkerOutput output = run_worker(image_program, verb, arguments, inherited, limits(), progress);
  if (output.succeeded()) return {output.notes, output.result};
  clear_away(json::parse(arguments, nullptr, false), output.child.pid);
  remove_temporary_folders(output.child.pid);
  if (output.child.end == ChildEnd::interrupted) throw SystemError("interrupted; nothing was made");
  if (output.error.empty()) throw InputError(child_failure(output.child, subject));
  if (output.kind == "memory") {
    throw InputError(
        fmt::format("{}: this needs more memory than Bodkin gives to reading an image; it is damaged, or so "
                    "large that it must be cropped first",
                    subject));
  }
  if (output.kind == "system") throw SystemError(output.error);
  throw InputError(output.error);
}

// The worker read a foreign file: its statements about the grid are checked like the file itself.
std::optional<anatomy::Grid> grid_from(const json& value) {
  anatomy::Grid grid;
  const std::vector<double> numbers = value.value("numbers", std::vector<double>{});
  const std::vector<int> size = value.value("size", std::vector<int>{});
  if (numbers.size() != 15 || size.size() != 3) return std::nullopt;
  if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
    return std::nullopt;
  if (!std::all_of(size.begin(), size.end(), [](int count) { return count > 0; })) return std::nullopt;
  std::copy(size.begin(), size.end(), grid.size.begin());
  std::copy_n(numbers.begin(), 3, grid.spacing.data());
  std::copy_n(numbers.begin() + 3, 9, grid.direction.data());  // column by column, as the worker writes them
  std::copy_n(numbers.begin() + 12, 3, grid.origin.data());
  return grid;
}

template <typename Voxel>
anatomy::Volume<Voxel> read_isolated(const std::filesystem::path& path, const char* kind, const Progress& progress) {
  const SharedMemory memory("bodkin-voxels");
  const json request = {{"path", path_text(path)}, {"kind", kind}};
  const WorkerReport report = run_reader("read", request.dump(), path.string(), progress, memory.descriptor());
  const std::optional<anatomy::Grid> grid = grid_from(json::parse(report.result, nullptr, false));
  if (!grid || memory.size() != grid->voxel_count() * sizeof(Voxel)) {
    throw InputError(
        fmt::format("{}: the imaging library returned an invalid image; the file is damaged", path.string()));
  }
  anatomy::Volume<Voxel> volume(*grid);
  memory.copy_to(volume.voxels.data(), memory.size());
  return volume;
}

}  // namespace

std::string path_text(const std::filesystem::path& path) {
  std::string text = path.string();
  if (valid_text(text) != text) {
    throw InputError(fmt::format("{}: the file name is not UTF-8 text; rename it", valid_text(text)));
  }
  return text;
}

WorkerReport run_image_worker(const std::string& verb, const std::string& arguments, const std::string& subject,
                              const Progress& progress) {
  return run_reader(verb, arguments, subject, progress, -1);
}

WorkerReport run_image_worker_on(const SharedMemory& memory, const std::string& verb, const std::string& arguments,
                                 const std::string& subject, const Progress& progress) {
  return run_reader(verb, arguments, subject, progress, memory.descriptor());
}

anatomy::CtVolume read_ct_isolated(const std::filesystem::path& path, const Progress& progress) {
  return read_isolated<std::int16_t>(path, "ct", progress);
}

anatomy::LabelVolume read_labels_isolated(const std::filesystem::path& path, const Progress& progress) {
  return read_isolated<std::uint16_t>(path, "labels", progress);
}

anatomy::TissueVolume read_tissues_isolated(const std::filesystem::path& path, const Progress& progress) {
  return read_isolated<std::uint8_t>(path, "tissues", progress);
}

}  // namespace bodkin::io
