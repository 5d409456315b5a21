// A tracked sequence, read back by a parser independent of the writer.
#include "imaging/ultrasound_screen/sequence_file.h"

#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::imaging;
namespace {

struct Parsed {
  std::map<std::string, std::string> fields;
  std::vector<std::string> order;
  std::string data;
};

Parsed parsed(const std::string& bytes) {
  Parsed file;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string::npos) return file;
    const std::string line = bytes.substr(begin, end - begin);
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos) {
      ADD_FAILURE() << line;
      return file;
    }
    file.order.push_back(line.substr(0, equals));
    file.fields[file.order.back()] = line.substr(equals + 3);
    begin = end + 1;
    if (file.order.back() == "ElementDataFile") break;
  }
  file.data = bytes.substr(begin);
  return file;
}

Eigen::Matrix4d matrix_of(const std::string& text) {
  std::istringstream stream(text);
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) stream >> matrix(row, column);
  }
  EXPECT_TRUE(stream) << text;
  return matrix;
}

TrackedSequence a_sequence() {
  TrackedSequence sequence;
  sequence.width = 4;
  sequence.height = 3;
  sequence.pixel = 0.5;
  sequence.corner = Vec3(-0.75, 1.0, 0.0);
  sequence.probe = "C5-2";
  sequence.depth = 120.0;
  for (int i = 0; i < 3; ++i) {
    TrackedFrame frame;
    frame.time = 0.04 * i;
    frame.probe.translation() = Vec3(10.0 + i, 20.0, 30.0);
    frame.probe.rotate(Eigen::AngleAxisd(0.3 * i, Vec3(1, 2, 2).normalized()));
    for (int pixel = 0; pixel < 12; ++pixel) frame.pixels.push_back(static_cast<std::uint8_t>(20 * i + pixel));
    sequence.frames.push_back(frame);
  }
  sequence.frames[2].needle = Pose(Eigen::Translation3d(1.0, 2.0, 3.0));
  return sequence;
}

TEST(SequenceFile, has_the_header_that_plus_and_slicer_read) {
  const Parsed file = parsed(sequence_bytes(a_sequence(), false));
  EXPECT_EQ(file.order.front(), "ObjectType");
  EXPECT_EQ(file.order.back(), "ElementDataFile");
  for (const auto& [name, value] :
       std::map<std::string, std::string>{{"ObjectType", "Image"},
                                          {"NDims", "3"},
                                          {"DimSize", "4 3 3"},
                                          {"ElementType", "MET_UCHAR"},
                                          {"ElementSpacing", "1 1 1"},
                                          {"Offset", "0 0 0"},
                                          {"Kinds", "domain domain list"},
                                          {"UltrasoundImageOrientation", "MF"},
                                          {"UltrasoundImageType", "BRIGHTNESS"},
                                          {"CompressedData", "False"},
                                          {"Seq_Frame0001_Timestamp", "0.040000"},
                                          {"Seq_Frame0002_ImageStatus", "OK"},
                                          {"Seq_Frame0002_ProbeToReferenceTransformStatus", "OK"},
                                          {"ElementDataFile", "LOCAL"}}) {
    ASSERT_TRUE(file.fields.contains(name)) << name;
    EXPECT_EQ(file.fields.at(name), value) << name;
  }
  ASSERT_EQ(file.data.size(), 36U);
  EXPECT_EQ(file.data[13], 21);
  EXPECT_FALSE(file.fields.contains("Seq_Frame0001_NeedleTipToReferenceTransform"));
}

TEST(SequenceFile, a_pixel_lands_where_it_is_in_the_patient_in_ras) {
  const TrackedSequence sequence = a_sequence();
  const Parsed file = parsed(sequence_bytes(sequence, false));
  const Eigen::Vector4d pixel(3.0, 2.0, 0.0, 1.0);
  const Vec3 lps = sequence.frames[1].probe * (sequence.corner + 0.5 * Vec3(3.0, 2.0, 0.0));
  const Eigen::Vector4d ras = matrix_of(file.fields.at("Seq_Frame0001_ImageToReferenceTransform")) * pixel;
  EXPECT_NEAR(ras.x(), -lps.x(), 1e-6);
  EXPECT_NEAR(ras.y(), -lps.y(), 1e-6);
  EXPECT_NEAR(ras.z(), lps.z(), 1e-6);
  // The way over the probe is the same.
  const Eigen::Vector4d over = matrix_of(file.fields.at("Seq_Frame0001_ProbeToReferenceTransform")) *
                               matrix_of(file.fields.at("Seq_Frame0001_ImageToProbeTransform")) * pixel;
  EXPECT_NEAR((over - ras).norm(), 0.0, 1e-6);
  // A turn, no mirror: the probe's axes stay right-handed in RAS.
  const Eigen::Matrix4d probe = matrix_of(file.fields.at("Seq_Frame0001_ProbeToReferenceTransform"));
  EXPECT_NEAR((probe.topLeftCorner<3, 3>().determinant()), 1.0, 1e-6);
  const Eigen::Matrix4d needle = matrix_of(file.fields.at("Seq_Frame0002_NeedleTipToReferenceTransform"));
  EXPECT_NEAR((needle.topRightCorner<3, 1>() - Vec3(-1.0, -2.0, 3.0)).norm(), 0.0, 1e-9);
}

TEST(SequenceFile, compressed_data_are_the_same_and_as_long_as_said) {
  TrackedSequence sequence = a_sequence();
  const Parsed plain = parsed(sequence_bytes(sequence, false)), packed = parsed(sequence_bytes(sequence, true));
  EXPECT_EQ(packed.fields.at("CompressedData"), "True");
  EXPECT_EQ(std::stoul(packed.fields.at("CompressedDataSize")), packed.data.size());
  std::string bytes(plain.data.size(), '\0');
  uLongf size = bytes.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data.data()), packed.data.size()),
            Z_OK);
  EXPECT_EQ(size, plain.data.size());
  EXPECT_EQ(bytes, plain.data);
}

TEST(SequenceFile, an_unknown_pose_is_invalid_and_frames_that_do_not_fit_are_refused) {
  TrackedSequence sequence = a_sequence();
  sequence.frames[0].valid = false;
  sequence.frames[0].probe.translation().setConstant(std::nan(""));
  const Parsed file = parsed(sequence_bytes(sequence, false));
  EXPECT_EQ(file.fields.at("Seq_Frame0000_ProbeToReferenceTransformStatus"), "INVALID");
  EXPECT_TRUE(matrix_of(file.fields.at("Seq_Frame0000_ImageToReferenceTransform")).isIdentity());
  sequence.frames[1].pixels.pop_back();
  EXPECT_THROW(sequence_bytes(sequence, true), InputError);
  sequence.frames.clear();
  EXPECT_THROW(sequence_bytes(sequence, true), InputError);
}

}  // namespace
}  // namespace bodkin
