// The CT as the OpenIGTLink library reads it.
#include "link/ct_message.h"

#include <cstring>

#include "igtlImageMessage.h"
#include "igtlImageMetaMessage.h"
#include "link/contents.h"
#include <gtest/gtest.h>

namespace bodkin::link {
namespace {

TEST(CtMessage, is_read_by_the_library_with_its_place_and_every_voxel) {
  anatomy::Grid grid;
  grid.size = {90, 80, 75};  // more than one piece
  grid.spacing = Vec3(0.5, 0.75, 2.0);
  grid.direction << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0;  // columns: i to S, j to L, k to P
  grid.origin = Vec3(10.0, -20.0, 30.0);
  anatomy::CtVolume ct(grid);
  for (std::size_t i = 0; i < ct.voxels.size(); ++i) ct.voxels[i] = static_cast<std::int16_t>(i % 4096 - 1024);
  CtMessage message(ct);
  EXPECT_FALSE(message.proceed());
  EXPECT_EQ(message.packed(), nullptr) << "nobody gets half of it";
  while (!message.proceed()) continue;
  const Bytes& bytes = *message.packed();

  igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
  header->InitPack();
  std::memcpy(header->GetPackPointer(), bytes.data(), header_size);
  header->Unpack();
  EXPECT_STREQ(header->GetDeviceName(), "CT");
  EXPECT_STREQ(header->GetDeviceType(), "IMAGE");
  igtl::ImageMessage::Pointer image = igtl::ImageMessage::New();
  image->SetMessageHeader(header);
  image->AllocatePack();
  ASSERT_EQ(static_cast<std::size_t>(image->GetPackBodySize()), bytes.size() - header_size);
  std::memcpy(image->GetPackBodyPointer(), bytes.data() + header_size, bytes.size() - header_size);
  ASSERT_NE(image->Unpack(1) & igtl::MessageHeader::UNPACK_BODY, 0) << "with its check sum";
  int size[3] = {};
  image->GetDimensions(size);
  EXPECT_EQ((std::array<int, 3>{size[0], size[1], size[2]}), grid.size);
  EXPECT_EQ(image->GetScalarType(), igtl::ImageMessage::TYPE_INT16);
  EXPECT_EQ(image->GetCoordinateSystem(), igtl::ImageMessage::COORDINATE_RAS);
  float spacing[3] = {};
  image->GetSpacing(spacing);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(spacing[axis], grid.spacing[axis], 1e-5);
  igtl::Matrix4x4 matrix;
  image->GetMatrix(matrix);
  // The last voxel by the library's numbers, from the middle of the image, is where the grid has it.
  const Vec3 last = grid.to_patient(Vec3(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1));
  const double lps_to_ras[3] = {-1.0, -1.0, 1.0};
  for (int row = 0; row < 3; ++row) {
    auto place = static_cast<double>(matrix[row][3]);
    for (int axis = 0; axis < 3; ++axis)
      place += static_cast<double>(matrix[row][axis] * spacing[axis]) * 0.5 * (size[axis] - 1);
    EXPECT_NEAR(place, lps_to_ras[row] * last[row], 1e-3);
  }
  EXPECT_EQ(image->GetEndian(), igtl::ImageMessage::ENDIAN_LITTLE);
  EXPECT_EQ(std::memcmp(image->GetScalarPointer(), ct.voxels.data(), 2 * ct.voxels.size()), 0)
      << "this machine has the lowest byte first, as the message";
}

TEST(CtMessage, the_list_of_images_is_the_librarys) {
  igtl::ImageMetaMessage::Pointer theirs = igtl::ImageMetaMessage::New();
  igtl::ImageMetaElement::Pointer element = igtl::ImageMetaElement::New();
  element->SetName("Back");
  element->SetDeviceName("CT");
  element->SetModality("CT");
  element->SetPatientName("");
  element->SetPatientID("");
  igtl::TimeStamp::Pointer time = igtl::TimeStamp::New();
  time->SetTime(0U, 0U);
  element->SetTimeStamp(time);
  element->SetSize(512, 400, 33);
  element->SetScalarType(4);
  theirs->AddImageMetaElement(element);
  theirs->Pack();
  const ListedImage listed{.name = "Back", .device = "CT", .modality = "CT", .size = {512, 400, 33}};
  const Bytes ours = image_list_content({&listed, 1});
  ASSERT_EQ(static_cast<std::size_t>(theirs->GetPackBodySize()), ours.size());
  const auto* const body = static_cast<const std::uint8_t*>(theirs->GetPackBodyPointer());
  Bytes expected(body, body + ours.size());
  expected.back() = 0;  // reserved; the library leaves it as memory was
  EXPECT_EQ(ours, expected);
}

}  // namespace
}  // namespace bodkin::link
