#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "io/images/image_file.h"
#include "io/images/image_format.h"
#include "io/images/inflated_size.h"
#include "io/text_encoding.h"

// NRRD (teem.sourceforge.net/nrrd/format.html) and MetaImage both start with lines of text, "key: value" and "Key =
// Value". Only unsafe or ambiguous contents are checked here; ITK reads the rest.

namespace bodkin::io {
namespace {

constexpr std::size_t longest_header = 16U << 20U;  // bytes; tracked ultrasound sequences carry long ones
constexpr std::size_t longest_line = 1U << 20U;
constexpr double text_limit = 4.0;  // written as text a voxel takes at least two bytes, in memory at most eight

struct TextHeader {
  std::map<std::string, std::string> fields;
  std::uintmax_t bytes = 0;  // length of the header, up to the first voxel byte

  const std::string* find(const std::string& key) const {
    const auto found = fields.find(key);
    return found == fields.end() ? nullptr : &found->second;
  }
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string lower(std::string text) {
  for (char& letter : text) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return text;
}

// Reads lines until `last` (a key after which voxels follow) or an empty line, depending on the format.
TextHeader read_text_header(const std::filesystem::path& file, const std::string& separator,
                            const std::string& last) {
  std::ifstream stream(file, std::ios::binary);
  TextHeader header;
  std::string line;
  while (std::getline(stream, line) && line.size() < longest_line) {
    header.bytes += line.size() + 1;
    if (header.bytes > longest_header) break;
    if (last.empty() && trimmed(line).empty()) return header;
    const auto place = line.find(separator);
    if (place == std::string::npos || line.starts_with('#')) continue;
    const std::string key = lower(trimmed(line.substr(0, place)));
    header.fields[key] = trimmed(line.substr(place + separator.size()));
    if (!last.empty() && key == last) return header;
  }
  return header;  // a detached header may simply end
}

std::vector<double> numbers_in(const std::string& text) {
  std::string clean = text;
  for (char& letter : clean) {
    if (letter == '(' || letter == ')' || letter == ',') letter = ' ';
  }
  std::istringstream words(clean);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    if (word == "none") continue;
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    numbers.push_back(end == word.c_str() ? std::nan("") : value);
  }
  return numbers;
}

void require_finite(const TextHeader& header, const std::string& key, const std::string& name) {
  const std::string* text = header.find(key);
  if (text == nullptr) return;
  for (const double value : numbers_in(*text)) {
    if (!std::isfinite(value)) {
      throw InputError(fmt::format("{}: '{}' is '{}'; expected finite numbers", name, key, printable(*text)));
    }
  }
}

void require_lengths(const TextHeader& header, const std::string& key, const std::string& name) {
  const std::string* text = header.find(key);
  if (text == nullptr) return;
  for (const double value : numbers_in(*text)) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw InputError(fmt::format("{}: the voxel spacing '{}' is '{}'; expected lengths above zero", name, key,
                                   printable(*text)));
    }
  }
}

void require_sizes(const TextHeader& header, const std::string& key, const std::string& name) {
  const std::string* text = header.find(key);
  if (text == nullptr) throw InputError(fmt::format("{}: the header has no '{}'; the file is damaged", name, key));
  for (const double value : numbers_in(*text)) {
    if (!(value >= 1.0) || value > 1e6) {
      throw InputError(fmt::format("{}: the header declares '{}: {}'; expected 1 to 1000000 voxels along each axis",
                                   name, key, printable(*text)));
    }
  }
}

void require_number_type(const TextHeader& header, const std::string& name) {
  const std::string* type = header.find("elementtype");
  const std::string word = type == nullptr ? "" : lower(*type);
  for (const char* known : {"char", "uchar", "short", "ushort", "int", "uint", "long", "ulong", "long_long",
                            "ulong_long", "float", "double"}) {
    if (word == std::string("met_") + known) return;
  }
  throw InputError(fmt::format("{}: 'ElementType' is '{}'; expected one number a voxel, MET_SHORT for example", name,
                               type == nullptr ? "" : printable(*type)));
}

// The voxel file of a detached header: a plain file in the same folder, never elsewhere.
std::filesystem::path data_beside(const std::filesystem::path& file, const std::string& value) {
  const std::filesystem::path data = value;
  const bool plain = !value.empty() && data == data.filename() && value != ".." && value != "." &&
                     value.find_first_of("%*? \\") == std::string::npos && lower(value) != "list";
  if (!plain) {
    throw InputError(
        fmt::format("{}: the voxels are said to be in '{}'; only one file in the same folder is read, so "
                    "store header and voxels in one file",
                    file.string(), printable(value)));
  }
  std::filesystem::path full = file.parent_path() / data;
  if (!std::filesystem::is_regular_file(full)) {
    throw InputError(
        fmt::format("{}: the voxels are said to be in '{}', which is not there", file.string(), printable(value)));
  }
  return full;
}

// Voxel bytes from `offset` on, decompressed if necessary.
double voxel_bytes(const std::filesystem::path& file, std::uintmax_t offset, bool packed, const std::string& name) {
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (!packed) return static_cast<double>(size - std::min(size, offset));
  const std::optional<std::uintmax_t> unpacked = inflated_size(file, offset, most_voxels * 8);
  if (!unpacked)
    throw InputError(fmt::format("{}: the packed voxels are truncated or damaged; copy the file again", name));
  return static_cast<double>(*unpacked);
}

}  // namespace

Payload inspect_nrrd(const std::filesystem::path& file) {
  const std::string name = file.string();
  const TextHeader header = read_text_header(file, ":", "");
  require_sizes(header, "sizes", name);
  const std::string* space = header.find("space");
  const std::string frame = space == nullptr ? "" : lower(*space);
  bool known = false;
  for (const char* word :
       {"left-posterior-superior", "lps", "right-anterior-superior", "ras", "left-anterior-superior", "las"}) {
    known = known || frame == word;
  }
  if (!known || header.find("space directions") == nullptr || header.find("space origin") == nullptr) {
    throw InputError(
        fmt::format("{}: the header does not say where the image lies in the patient; expected 'space: "
                    "left-posterior-superior' (or RAS, LAS) with 'space directions' and 'space origin'",
                    name));
  }
  require_finite(header, "space directions", name);
  require_finite(header, "space origin", name);

  Payload payload;
  const std::string* data = header.find("data file");
  if (data == nullptr) data = header.find("datafile");
  const std::string encoding = header.find("encoding") == nullptr ? "" : lower(*header.find("encoding"));
  const bool packed = encoding == "gzip" || encoding == "gz";
  const bool text = encoding == "ascii" || encoding == "text" || encoding == "txt" || encoding == "hex";
  if (!packed && !text && encoding != "raw") {
    throw InputError(
        fmt::format("{}: the encoding is '{}'; expected raw, gzip, ascii or hex", name, printable(encoding)));
  }
  payload.voxel_bytes = data == nullptr ? voxel_bytes(file, header.bytes, packed, name)
                                        : voxel_bytes(data_beside(file, *data), 0, packed, name);
  if (text) payload.voxel_bytes *= text_limit;
  return payload;
}

Payload inspect_meta_image(const std::filesystem::path& file) {
  const std::string name = file.string();
  const TextHeader header = read_text_header(file, "=", "elementdatafile");
  const std::string* data = header.find("elementdatafile");
  if (data == nullptr) {
    throw InputError(fmt::format("{}: the MetaImage header has no 'ElementDataFile'; the file is damaged", name));
  }
  require_sizes(header, "dimsize", name);
  if (header.find("elementspacing") == nullptr && header.find("elementsize") == nullptr) {
    throw InputError(
        fmt::format("{}: the header does not say how large a voxel is; expected 'ElementSpacing'", name));
  }
  require_lengths(header, "elementspacing", name);
  require_lengths(header, "elementsize", name);
  require_number_type(header, name);
  for (const char* key : {"transformmatrix", "rotation", "orientation", "offset", "position", "origin"}) {
    require_finite(header, key, name);
  }
  const auto says = [&](const char* key, const char* value) {
    return header.find(key) != nullptr && lower(*header.find(key)) == value;
  };
  const bool local = lower(*data) == "local", packed = says("compresseddata", "true");
  Payload payload;
  payload.voxel_bytes =
      local ? voxel_bytes(file, header.bytes, packed, name) : voxel_bytes(data_beside(file, *data), 0, packed, name);
  if (says("binarydata", "false")) payload.voxel_bytes *= text_limit;
  return payload;
}

}  // namespace bodkin::io
