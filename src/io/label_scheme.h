#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::io {

// The meaning of a segmentation's labels. The tissue of a structure is the name of a tissue of the library, or one of
// these words, which the construction of the patient resolves voxel by voxel:
//   "bone"          cortical or cancellous, by HU and depth below the bone's surface
//   "spinal_canal"  dura, cerebrospinal fluid, cauda equina and epidural space are constructed inside
//   ""              decided only by HU
//
// `scheme` is "totalsegmentator" (version 2), "totalsegmentator_v1" (the older numbers), "tptbox", or the path of a
// CSV file with the columns label,name,tissue,critical, or id,name with the names of TotalSegmentator, which then
// determine tissue and critical. Throws InputError naming file, line, column, what was found and what was expected.
std::vector<anatomy::Structure> read_label_scheme(const std::string& scheme);

// As above, with another tissue library, whose tissues the scheme may use.
std::vector<anatomy::Structure> read_label_scheme(const std::string& scheme, const anatomy::TissueLibrary& library);

// As above, from text in memory; `origin` names it in messages, `library` has the allowed tissues.
std::vector<anatomy::Structure> parse_label_scheme(const std::string& text, const std::string& origin,
                                                   const anatomy::TissueLibrary& library);

// As above, with the library that comes with Bodkin.
std::vector<anatomy::Structure> parse_label_scheme(const std::string& text, const std::string& origin);

// Whether `tissue` is one of the words above rather than the name of a tissue.
bool is_resolved_by_construction(std::string_view tissue) noexcept;

}  // namespace bodkin::io
