#include "imaging/ultrasound_screen/sequence_file.h"

#include <iterator>

#include <fmt/format.h>
#include <zlib.h>

#include "core/error.h"

namespace bodkin::imaging {

namespace {

using Matrix4 = Eigen::Matrix4d;

// LPS to RAS.
Matrix4 to_ras(const Matrix4& patient) {
  Matrix4 turned = patient;
  turned.topRows<2>() *= -1.0;
  return turned;
}

// 16 numbers row by row.
std::string numbers(const Matrix4& matrix) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double value = matrix(row, column);
      fmt::format_to(std::back_inserter(text), "{}{:.9g}", text.empty() ? "" : " ", value == 0.0 ? 0.0 : value);
    }
  }
  return text;
}

// Of all frames in turn, without one copy of them all.
std::string deflated(const TrackedSequence& sequence) {
  z_stream stream{};
  if (deflateInit(&stream, Z_DEFAULT_COMPRESSION) != Z_OK) throw SystemError("memory is short for compressing");
  std::string bytes;
  std::vector<char> block(1U << 18U);
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    std::vector<std::uint8_t> pixels = sequence.frames[i].pixels;  // zlib's input is not const
    stream.next_in = pixels.data();
    stream.avail_in = static_cast<uInt>(pixels.size());
    const int flush = i + 1 == sequence.frames.size() ? Z_FINISH : Z_NO_FLUSH;
    do {
      stream.next_out = reinterpret_cast<Bytef*>(block.data());
      stream.avail_out = static_cast<uInt>(block.size());
      deflate(&stream, flush);  // cannot fail: the stream is sound and there is room
      bytes.append(block.data(), block.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  deflateEnd(&stream);
  return bytes;
}

void check_sequence(const TrackedSequence& sequence) {
  if (sequence.frames.empty()) throw InputError("the sequence has no frame to write");
  const std::size_t pixels = static_cast<std::size_t>(sequence.width) * static_cast<std::size_t>(sequence.height);
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    if (sequence.frames[i].pixels.size() == pixels && pixels > 0) continue;
    throw InputError(fmt::format("frame {} of the sequence has {} pixels, expected {} x {}", i,
                                 sequence.frames[i].pixels.size(), sequence.width, sequence.height));
  }
}

}  // namespace

std::string sequence_bytes(const TrackedSequence& sequence, bool compressed) {
  check_sequence(sequence);
  const std::string packed = compressed ? deflated(sequence) : std::string();
  Matrix4 image_to_probe = Matrix4::Identity();
  image_to_probe.topLeftCorner<3, 3>() *= sequence.pixel;
  image_to_probe.topRightCorner<3, 1>() = sequence.corner;

  std::string text;
  const auto line = [&](const std::string& name, const std::string& value) { text += name + " = " + value + "\n"; };
  line("ObjectType", "Image");
  line("NDims", "3");
  line("AnatomicalOrientation", "RAI");
  line("BinaryData", "True");
  line("BinaryDataByteOrderMSB", "False");
  line("CenterOfRotation", "0 0 0");
  line("CompressedData", compressed ? "True" : "False");
  if (compressed) line("CompressedDataSize", std::to_string(packed.size()));
  line("DimSize", fmt::format("{} {} {}", sequence.width, sequence.height, sequence.frames.size()));
  line("Kinds", "domain domain list");
  line("ElementSpacing", "1 1 1");
  line("ElementType", "MET_UCHAR");
  line("Offset", "0 0 0");
  line("TransformMatrix", "1 0 0 0 1 0 0 0 1");
  line("UltrasoundImageOrientation", "MF");
  line("UltrasoundImageType", "BRIGHTNESS");
  line("BodkinProbe", sequence.probe);
  line("BodkinDepthMm", fmt::format("{:g}", sequence.depth));
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    const TrackedFrame& frame = sequence.frames[i];
    const std::string name = fmt::format("Seq_Frame{:04}_", i);
    const auto transform = [&](const char* which, const Matrix4& matrix, bool valid) {
      line(name + which + "Transform", numbers(valid ? matrix : Matrix4::Identity()));
      line(name + which + "TransformStatus", valid ? "OK" : "INVALID");
    };
    const Matrix4 probe = to_ras(frame.probe.matrix());
    transform("ImageToProbe", image_to_probe, true);
    transform("ImageToReference", probe * image_to_probe, frame.valid);
    transform("ProbeToReference", probe, frame.valid);
    if (frame.needle) transform("NeedleTipToReference", to_ras(frame.needle->matrix()), true);
    line(name + "Timestamp", fmt::format("{:.6f}", frame.time));
    line(name + "UnfilteredTimestamp", fmt::format("{:.6f}", frame.time));
    line(name + "FrameNumber", std::to_string(i));
    line(name + "ImageStatus", "OK");
  }
  line("ElementDataFile", "LOCAL");
  if (compressed) return text + packed;
  for (const TrackedFrame& frame : sequence.frames) text.append(frame.pixels.begin(), frame.pixels.end());
  return text;
}

}  // namespace bodkin::imaging
