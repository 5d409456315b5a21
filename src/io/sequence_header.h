#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace bodkin::io {

// The header data of an ultrasound sequence of PLUS (.igs.mha) about one of its images, in addition to those of every
// MetaImage.
struct SequenceHeader {
  std::string orientation;  // "MF": columns towards the orientation marker, rows into the depth; empty: not given
  double across = 0.0, down = 0.0;  // mm between columns, rows, from the image's calibration; 0: not given
  bool calibrated() const { return across > 0.0 && down > 0.0; }
};

// Reads "Key = Value" lines up to the pixels. Anything else, and any invalid matrix, counts as not given: any bytes
// give a header. `frame` is counted from 0. The calibration is a transform from "Image" to something in mm, the
// frame's own or the file's.
SequenceHeader parse_sequence_header(std::string_view bytes, std::size_t frame);

// As above, from a file, of which at most 16 MB are read. Throws InputError when it cannot be opened.
SequenceHeader read_sequence_header(const std::filesystem::path& file, std::size_t frame);

}  // namespace bodkin::io
