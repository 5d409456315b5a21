#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::io {

// How the arrays of a VTK XML file are stored.
struct VtuStorage {
  bool big_endian = false;
  bool long_headers = false;  // sizes before binary data have 8 bytes rather than 4
  bool packed = false;        // by zlib
};

// One array, as its element gives it.
struct VtuArray {
  std::string name;    // for messages
  std::string type;    // "Float32", "Int64", ...
  std::string format;  // "ascii", "binary", "appended"
  std::size_t components = 1;
  std::string_view text;   // between the tags
  std::size_t offset = 0;  // into the appended data
};

// The appended data behind the underscore.
struct VtuAppended {
  std::string_view bytes;
  bool raw = false;  // else base64
};

// The values of an array; at most `most` are taken, and there must be `expected` (any number when it is 0). `where`
// begins every message. Throws InputError.
std::vector<double> vtu_numbers(const VtuArray& array, const VtuStorage& storage, const VtuAppended& appended,
                                std::size_t expected, std::size_t most, const std::string& where);
// The same for an array whose type is one of whole numbers.
std::vector<std::int64_t> vtu_wholes(const VtuArray& array, const VtuStorage& storage, const VtuAppended& appended,
                                     std::size_t expected, std::size_t most, const std::string& where);

bool is_whole_type(std::string_view type);

}  // namespace bodkin::io
