#pragma once

#include <filesystem>
#include <string>

namespace bodkin::io {

// A file that comes with Bodkin, such as "tissues.xml" or "label_schemes/tptbox.csv". Searched in the folder named by
// the environment variable BODKIN_SHARE, next to the running program (../share/bodkin), in the source tree, and where
// Bodkin was installed, in this order. Throws SystemError when it is in none of them.
std::filesystem::path shared_file(const std::string& name);

// The bytes of a text file. Throws InputError when it cannot be read, is not a plain file or is larger than `limit`
// bytes.
std::string read_text_file(const std::filesystem::path& file, std::size_t limit);

// The plain file `name` inside `folder`. Throws InputError, prefixed by `what` ("case.xml: the CT"), when the name is
// empty, absolute or has "..", when a link leads out of the folder, or when there is no such file.
std::filesystem::path file_inside(const std::filesystem::path& folder, const std::string& name,
                                  const std::string& what);

// Whether `name` is a relative file name that, judging by its text, stays in its folder.
bool is_inside_name(const std::string& name);

}  // namespace bodkin::io
