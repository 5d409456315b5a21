#include "io/sequence_header.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::io;
namespace {

// Of pixels 0.08 x 0.1 mm, turned in the patient, as a transform has them.
constexpr const char* calibration = "0 -0.1 0 3 0.08 0 0 -2 0 0 0.08 1 0 0 0 1";

TEST(SequenceHeader, knows_orientation_and_pixels_of_a_frame) {
  const std::string text = std::string("ObjectType = Image\nUltrasoundImageOrientation = UN\r\n") +
                           "Seq_Frame0000_ImageToProbeTransform = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n" +
                           "Seq_Frame0002_ImageToReferenceTransform = " + calibration +
                           "\nSeq_Frame0002_ProbeToReferenceTransform = 9 0 0 0 0 9 0 0 0 0 9 0 0 0 0 1\n" +
                           "Seq_Frame0002_ImageToReferenceTransformStatus = OK\nElementDataFile = LOCAL\n" +
                           "UltrasoundImageOrientation = MF\n";
  const SequenceHeader header = parse_sequence_header(text, 2);
  EXPECT_EQ(header.orientation, "UN") << "what follows the header is pixels";
  EXPECT_DOUBLE_EQ(header.across, 0.08);
  EXPECT_DOUBLE_EQ(header.down, 0.1);
  EXPECT_DOUBLE_EQ(parse_sequence_header(text, 0).across, 1.0);
  EXPECT_FALSE(parse_sequence_header(text, 1).calibrated());
  const SequenceHeader whole = parse_sequence_header(std::string("ImageToTransducerTransform = ") + calibration, 17);
  EXPECT_DOUBLE_EQ(whole.down, 0.1) << "the file's own";
}

TEST(SequenceHeader, what_is_no_sound_calibration_is_not_told) {
  for (const std::string value : {"", "1 2 3", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1", "nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
                                  "inf 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "1e300 0 0 0 1e300 1 0 0 0 0 1 0 0 0 0 1",
                                  "1e-9 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "one 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"}) {
    EXPECT_FALSE(parse_sequence_header("Seq_Frame0000_ImageToProbeTransform = " + value, 0).calibrated()) << value;
  }
  EXPECT_TRUE(parse_sequence_header("UltrasoundImageOrientation = much too long", 0).orientation.empty());
  EXPECT_FALSE(parse_sequence_header("", 0).calibrated());
}

TEST(SequenceHeader, any_bytes_give_a_header) {
  const std::string sound = std::string("UltrasoundImageOrientation = MFA\nSeq_Frame0000_ImageToProbeTransform = ") +
                            calibration + "\nElementDataFile = LOCAL\n";
  Random random(21);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes = sound.substr(0, random.next() % (sound.size() + 1));
    for (int change = 0; change < 4 && !bytes.empty(); ++change) {
      bytes[random.next() % bytes.size()] = static_cast<char>(random.next());
    }
    const SequenceHeader header = parse_sequence_header(bytes, random.next() % 3);
    EXPECT_LE(header.orientation.size(), 3U);
    if (header.calibrated()) {
      EXPECT_TRUE(header.across <= 100.0 && header.down <= 100.0 && header.across >= 1e-4 && header.down >= 1e-4);
    }
  }
}

TEST(SequenceHeader, a_file_that_is_not_there_is_one_sentence) {
  EXPECT_THROW(read_sequence_header("no/such/file.mha", 0), InputError);
}

}  // namespace
}  // namespace bodkin
