#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace bodkin::io {

// What the header of an ultrasound sequence as PLUS writes it (.igs.mha) says of one of its pictures beyond what
// every MetaImage says.
struct SequenceHeader {
  std::string orientation;          // "MF": columns to the marked side, rows into the depth; empty: not given
  double across = 0.0, down = 0.0;  // mm between columns, rows, by the picture's calibration; 0: not given
  bool calibrated() const { return across > 0.0 && down > 0.0; }
};

// Reads "Key = Value" lines up to the pixels. Anything else, and any invalid matrix, counts as not given: any
// bytes give a header. `frame` is counted from 0. The calibration is a transform from "Image" to something in mm, the
// frame's own or the file's.
SequenceHeader parse_sequence_header(std::string_view bytes, std::size_t frame);

// The same of a file, of which at most 16 MB are looked at. Throws InputError when it cannot be opened.
SequenceHeader read_sequence_header(const std::filesystem::path& file, std::size_t frame);

}  // namespace bodkin::io
