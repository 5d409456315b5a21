#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::io {

// Reads case.xml of a case folder, with its schema checked and its tissue library loaded, without the voxels.
// Throws InputError naming file, line, attribute, what was found and what was expected.
anatomy::CaseDescription read_case_description(const std::filesystem::path& folder);

// The tissue library of a case: its own, or the one that comes with Bodkin. Throws InputError.
anatomy::TissueLibrary read_case_library(const std::filesystem::path& folder,
                                         const anatomy::CaseDescription& description);

// Reads a whole case: description, tissue library and volumes. Files written by Bodkin are read in parallel in this
// process (nrrd_reader.h), others through the image worker, which cannot crash this process. Throws InputError when a
// file is missing, damaged, or does not agree with case.xml.
anatomy::Case load_case(const std::filesystem::path& folder, const Progress& progress = {});

// Reads only the tissues, checked as by load_case.
anatomy::TissueVolume load_case_tissues(const std::filesystem::path& folder,
                                        const anatomy::CaseDescription& description, const Progress& progress = {});

// Reads only the segmentation, checked as by load_case; empty if the case has none.
anatomy::LabelVolume load_case_structures(const std::filesystem::path& folder,
                                          const anatomy::CaseDescription& description, const Progress& progress = {});

// Writes case.xml (and nothing else) into `folder`, replacing an older one atomically. Throws SystemError on failure,
// and InputError when read_case_description would reject the result.
void write_case_description(const anatomy::CaseDescription& description, const std::filesystem::path& folder);

// Writes a case in memory into an existing folder: the volumes, except empty ones, and the tissue library, if given,
// under their usual names; names and digests are added to the description, and then case.xml is written as above.
// Throws what write_case_description throws.
void write_case(anatomy::CaseDescription& description, const anatomy::CtVolume& ct,
                const anatomy::TissueVolume& tissues, const anatomy::LabelVolume& structures,
                const anatomy::TissueLibrary* library, const std::filesystem::path& folder);

// All errors in a case folder, one sentence each; empty = valid. Never throws for invalid content.
std::vector<std::string> check_case(const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace bodkin::io
