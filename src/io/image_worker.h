#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/volume.h"
#include "core/progress.h"
#include "io/shared_memory.h"

// The image worker is a program of its own (bodkin-images) that holds the imaging libraries. Foreign image files are
// read there, so that nothing in them can crash this process or make it allocate more than they justify, and the
// imaging libraries load only when an image is read.

namespace bodkin::io {

// What the worker says of a finished piece of work.
struct WorkerReport {
  std::vector<std::string> notes;  // what was repaired or assumed, one sentence each
  std::string result;              // JSON, its shape depends on the verb
};

// A path as text for `arguments`. Throws InputError when its name is not UTF-8.
std::string path_text(const std::filesystem::path& path);

// Runs `bodkin-images VERB` with `arguments` (a JSON object) and waits for it. Progress is passed on. Throws
// InputError with the worker's sentence when the input is at fault (also when the worker crashed or ran out of its
// memory limit on it: the sentence then names `subject`, the file being read), SystemError when the worker is
// missing. What a failed worker was building under "folder" is removed.
WorkerReport run_image_worker(const std::string& verb, const std::string& arguments, const std::string& subject,
                              const Progress& progress);

// The same with voxels that both see: `memory` is descriptor 3 of the worker, which may replace what is in it.
WorkerReport run_image_worker_on(const SharedMemory& memory, const std::string& verb, const std::string& arguments,
                                 const std::string& subject, const Progress& progress);

// Reads one image file (NRRD, NIfTI, MetaImage) or DICOM folder as HU, labels or tissue ids. Throws InputError.
anatomy::CtVolume read_ct_isolated(const std::filesystem::path& path, const Progress& progress = {});
anatomy::LabelVolume read_labels_isolated(const std::filesystem::path& path, const Progress& progress = {});
anatomy::TissueVolume read_tissues_isolated(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace bodkin::io
