#include "io/image_worker.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "io/child_process.h"
#include "io/partial_folder.h"
#include "io/text_encoding.h"

namespace bodkin {
namespace {

using nlohmann::json;

constexpr const char* worker_name = "bodkin-images";

// Of the worker. The largest import (a 512-million-voxel CT) needs less address space; what a file's own bytes
// justify is checked inside, before memory is taken.
ChildLimits limits() {
  ChildLimits result;
#ifndef BODKIN_ADDRESS_SANITIZER  // its shadow memory alone is larger
  result.memory = 6ULL << 30U;
#endif
  return result;
}

std::filesystem::path find_worker() {
  if (const char* named = std::getenv("BODKIN_IMAGES_WORKER")) return named;
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path beside = self.parent_path() / worker_name;
  const std::filesystem::path installed = std::filesystem::path(BODKIN_INSTALLED_LIBEXEC) / worker_name;
  const std::filesystem::path relocated = self.parent_path().parent_path() / "libexec" / "bodkin" / worker_name;
  for (const std::filesystem::path& place : {beside, relocated, installed}) {
    if (std::filesystem::exists(place, error)) return place;
  }
  throw SystemError(
      fmt::format("{} is missing: it is neither beside the program ({}) nor in {}; build Bodkin with "
                  "BODKIN_IMAGES=ON or name it in BODKIN_IMAGES_WORKER",
                  worker_name, beside.string(), installed.string()));
}

// What the worker has said so far.
struct Said {
  WorkerReport report;
  std::string error, kind;
  bool finished = false;
};

void hear(std::string_view line, Said& said, const Progress& progress) {
  const json message = json::parse(line, nullptr, false);
  if (!message.is_object()) return;  // a library that talks to standard output
  if (message.contains("progress") && progress) {
    progress(message.value("progress", ""), std::clamp(message.value("fraction", 0.0), 0.0, 1.0));
  }
  if (message.contains("note")) said.report.notes.push_back(message.value("note", ""));
  if (message.contains("error")) {
    said.error = message.value("error", "");
    said.kind = message.value("kind", "input");
  }
  if (message.contains("result")) {
    said.report.result = message["result"].dump();
    said.finished = true;
  }
}

// The sentence for a worker that ended without one of its own.
std::string obituary(const ChildResult& child, const std::string& subject) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(subject, ignored);
  switch (child.end) {
    case ChildEnd::out_of_time:
      return fmt::format("{}: reading this took too long and was given up; it is damaged or far too large", subject);
    case ChildEnd::killed:
      return fmt::format("{}: the imaging library crashed on {} ({}); it is damaged, or not what its name says",
                         subject, is_folder ? "a file in this folder" : "this", strsignal(child.signal));
    case ChildEnd::exited:
      break;
  }
  return fmt::format("{}: the imaging library gave up on this without a word (exit code {}); it is damaged", subject,
                     child.exit_code);
}

// What a worker that died was building is no use to anyone.
void clear_away(const json& request, pid_t worker) {
  if (!request.contains("folder")) return;
  std::error_code ignored;
  std::filesystem::remove_all(partial_name(request.value("folder", ""), worker), ignored);
}

WorkerReport run_worker(const std::string& verb, const std::string& arguments, const std::string& subject,
                        const Progress& progress, int inherited) {
  Said said;
  const ChildResult child = run_child(find_worker(), {verb}, arguments, inherited, limits(),
                                      [&](std::string_view line) { hear(line, said, progress); });
  const bool succeeded = child.end == ChildEnd::exited && child.exit_code == 0 && said.finished;
  if (succeeded) return said.report;
  clear_away(json::parse(arguments, nullptr, false), child.pid);
  if (said.error.empty()) throw InputError(obituary(child, subject));
  if (said.kind == "memory") {
    throw InputError(
        fmt::format("{}: this needs more memory than Bodkin gives to reading an image; it is damaged, or so "
                    "large that it must be cropped first",
                    subject));
  }
  if (said.kind == "system") throw SystemError(said.error);
  throw InputError(said.error);
}

// Anonymous memory that the worker fills with voxels.
class SharedMemory {
 public:
  SharedMemory() : descriptor_(memfd_create("bodkin-voxels", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw SystemError(fmt::format("no shared memory: {}", std::strerror(errno)));
  }
  ~SharedMemory() { close(descriptor_); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  int descriptor() const { return descriptor_; }

  std::size_t size() const {
    struct stat status {};
    return fstat(descriptor_, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
  }
  void copy_to(void* target, std::size_t size) const {
    void* mapped = mmap(nullptr, size, PROT_READ, MAP_SHARED, descriptor_, 0);
    if (mapped == MAP_FAILED) throw SystemError(fmt::format("no memory for an image: {}", std::strerror(errno)));
    std::memcpy(target, mapped, size);
    munmap(mapped, size);
  }

 private:
  int descriptor_;
};

// The worker read a foreign file: what it says of the grid is checked like the file itself.
std::optional<Grid> grid_from(const json& value) {
  Grid grid;
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
Volume<Voxel> read_isolated(const std::filesystem::path& path, const char* kind, const Progress& progress) {
  const SharedMemory memory;
  const json request = {{"path", path_text(path)}, {"kind", kind}};
  const WorkerReport report = run_worker("read", request.dump(), path.string(), progress, memory.descriptor());
  const std::optional<Grid> grid = grid_from(json::parse(report.result, nullptr, false));
  if (!grid || memory.size() != grid->voxel_count() * sizeof(Voxel)) {
    throw InputError(
        fmt::format("{}: the imaging library returned no sound image; the file is damaged", path.string()));
  }
  Volume<Voxel> volume(*grid);
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
  return run_worker(verb, arguments, subject, progress, -1);
}

CtVolume read_ct_isolated(const std::filesystem::path& path, const Progress& progress) {
  return read_isolated<std::int16_t>(path, "ct", progress);
}

LabelVolume read_labels_isolated(const std::filesystem::path& path, const Progress& progress) {
  return read_isolated<std::uint16_t>(path, "labels", progress);
}

TissueVolume read_tissues_isolated(const std::filesystem::path& path, const Progress& progress) {
  return read_isolated<std::uint8_t>(path, "tissues", progress);
}

}  // namespace bodkin
