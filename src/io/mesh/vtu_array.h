#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::io {

// The storage format of the arrays of a VTK XML file.
struct VtuStorage {
  bool big_endian = false;
  bool long_headers = false;  // sizes before binary data have 8 bytes rather than 4
  bool packed = false;        // by zlib
};

// One array, as described by its element.
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
  bool raw = false;  // otherwise base64
};

// The values of an array; at most `most` are read, and there must be `expected` (any number when it is 0). `where` is
// the prefix of every message. Throws InputError.
std::vector<double> vtu_numbers(const VtuArray& array, const VtuStorage& storage, const VtuAppended& appended,
                                std::size_t expected, std::size_t most, const std::string& where);
// As vtu_numbers(), for an array of a whole-number type.
std::vector<std::int64_t> vtu_wholes(const VtuArray& array, const VtuStorage& storage, const VtuAppended& appended,
                                     std::size_t expected, std::size_t most, const std::string& where);

bool is_whole_type(std::string_view type);

}  // namespace bodkin::io
