#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/volume.h"
#include "core/progress.h"
#include "io/shared_memory.h"

// The image worker is a separate program (bodkin-images) that contains the imaging libraries. Foreign image files are
// read there, so that nothing in them can crash this process or make it allocate excessively, and the imaging
// libraries load only when an image is read.

namespace bodkin::io {

// The worker's report of a completed task.
struct WorkerReport {
  std::vector<std::string> notes;  // repairs and assumptions, one sentence each
  std::string result;              // JSON, its form depends on the verb
};

// A path as text for `arguments`. Throws InputError when its name is not UTF-8.
std::string path_text(const std::filesystem::path& path);

// Runs `bodkin-images VERB` with `arguments` (a JSON object) and waits for it. Progress is passed on. Throws
// InputError with the worker's sentence for invalid input (also when the worker crashed or ran out of its memory
// limit on it: the sentence then names `subject`, the file being read), SystemError when the worker is missing. The
// incomplete output of a failed worker under "folder" is removed.
WorkerReport run_image_worker(const std::string& verb, const std::string& arguments, const std::string& subject,
                              const Progress& progress);

// As above, with shared voxels: `memory` is descriptor 3 of the worker, which may replace its content.
WorkerReport run_image_worker_on(const SharedMemory& memory, const std::string& verb, const std::string& arguments,
                                 const std::string& subject, const Progress& progress);

// Reads one image file (NRRD, NIfTI, MetaImage) or DICOM folder as HU, labels or tissue ids. Throws InputError.
anatomy::CtVolume read_ct_isolated(const std::filesystem::path& path, const Progress& progress = {});
anatomy::LabelVolume read_labels_isolated(const std::filesystem::path& path, const Progress& progress = {});
anatomy::TissueVolume read_tissues_isolated(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace bodkin::io
