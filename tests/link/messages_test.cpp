// Every message byte for byte against the OpenIGTLink library, and defects of foreign ones.
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <random>

#include "igtlImageMessage.h"
#include "igtlNDArrayMessage.h"
#include "igtlPointMessage.h"
#include "igtlPolyDataMessage.h"
#include "igtlSensorMessage.h"
#include "igtlStatusMessage.h"
#include "igtlStringMessage.h"
#include "igtlTrackingDataMessage.h"
#include "igtlTransformMessage.h"
#include "link/command.h"
#include "link/contents.h"
#include "link/message.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

#ifdef BODKIN_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace bodkin::link {
namespace {

using ::testing::HasSubstr;

constexpr double stamp = 1700000000.0;  // s

template <typename M>
Bytes packed_by_library(const M& message, const char* device) {
  message->SetDeviceName(device);
  igtl::TimeStamp::Pointer time = igtl::TimeStamp::New();
  time->SetTime(1700000000U, 0U);
  message->SetTimeStamp(time);
  message->Pack();
  const auto* const first = static_cast<const std::uint8_t*>(message->GetPackPointer());
  return {first, first + message->GetPackSize()};
}

Bytes ours(const std::string& type, const std::string& device, Bytes content) {
  return pack({type, device, stamp, std::move(content)});
}

// A pose that looks different in every number, and its matrix in RAS.
Pose some_pose() {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  pose.translation() = Vec3(12.5, -80.25, 311.0);
  return pose;
}

// The patient's axes are turned, the tool keeps its own: a probe's x is its marked side in RAS too.
void fill(igtl::Matrix4x4& matrix, const Pose& lps) {
  const double sign[4] = {-1.0, -1.0, 1.0, 1.0};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      matrix[row][column] = static_cast<float>(sign[row] * lps.matrix()(row, column));
  }
}

TEST(LinkMessage, a_transform_is_the_librarys) {
  igtl::TransformMessage::Pointer theirs = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  fill(matrix, some_pose());
  theirs->SetMatrix(matrix);
  const Bytes expected = packed_by_library(theirs, "NeedleTipToReference");
  const Bytes found = ours("TRANSFORM", "NeedleTipToReference", transform_content(some_pose()));
  EXPECT_EQ(found, expected);
  const MessageHeader header = read_header(std::span(found).first(header_size));
  const Message back = unpack(header, std::span(found).subspan(header_size));
  EXPECT_EQ(back.device, "NeedleTipToReference");
  EXPECT_DOUBLE_EQ(back.time, stamp);
  EXPECT_LT((read_transform(back.content).matrix() - some_pose().matrix()).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(LinkMessage, a_string_and_a_status_are_the_librarys) {
  igtl::StringMessage::Pointer text = igtl::StringMessage::New();
  text->SetString("the needle is held");
  EXPECT_EQ(ours("STRING", "Event", string_content("the needle is held")), packed_by_library(text, "Event"));
  EXPECT_EQ(read_string(string_content("abc")), "abc");
  igtl::StatusMessage::Pointer status = igtl::StatusMessage::New();
  status->SetCode(igtl::StatusMessage::STATUS_OK);
  status->SetSubCode(0);
  status->SetErrorName("none");
  status->SetStatusString("ready");
  EXPECT_EQ(ours("STATUS", "Bodkin", status_content(1, "none", "ready")), packed_by_library(status, "Bodkin"));
}

TEST(LinkMessage, a_status_is_read_and_one_that_is_cut_off_is_refused) {
  const StatusText status = read_status(status_content(status_busy, "Full", "all 8 places are taken"));
  EXPECT_EQ(status.code, status_busy);
  EXPECT_EQ(status.message, "all 8 places are taken");
  EXPECT_EQ(read_status(status_content(1, "", "")).message, "");
  Bytes short_one = status_content(1, "", "");
  short_one.resize(29);
  EXPECT_THROW(read_status(short_one), InputError);
}

TEST(LinkMessage, a_sensor_is_the_librarys_with_its_unit) {
  std::array<double, 3> force = {0.5, -1.25, 3.0};
  const auto theirs = [&](std::span<double> values, int prefix, int unit) {
    igtl::Unit::Pointer of = igtl::Unit::New();
    of->SetPrefix(static_cast<igtlUint8>(prefix));
    of->Append(static_cast<igtlUint8>(unit), 1);
    igtl::SensorMessage::Pointer message = igtl::SensorMessage::New();
    message->SetLength(static_cast<unsigned>(values.size()));
    message->SetUnit(of);
    message->SetValue(values.data());
    return packed_by_library(message, "ForceOnHand");
  };
  EXPECT_EQ(ours("SENSOR", "ForceOnHand", sensor_content(force, SensorUnit::newton)),
            theirs(force, igtl::Unit::SI_PREFIX_NONE, igtl::Unit::SI_DERIVED_NEWTON));
  EXPECT_EQ(ours("SENSOR", "ForceOnHand", sensor_content(std::span(force).first(1), SensorUnit::millijoule)),
            theirs(std::span(force).first(1), igtl::Unit::SI_PREFIX_MILLI, igtl::Unit::SI_DERIVED_JOULE));
  EXPECT_THROW(sensor_content(std::vector<double>(256), SensorUnit::newton), InputError);
}

TEST(LinkMessage, an_array_is_the_librarys) {
#ifdef BODKIN_ADDRESS_SANITIZER
  const __lsan::ScopedDisabler leaks;  // of the library, and of the array that it cannot free
#endif
  const std::array<double, 6> numbers = {1.5, -2.25, 1e-7, 4e9, 0.0, -1.0};
  // The library frees the numbers of an array by the wrong operator: it is never freed.
  auto* const array = std::make_unique<igtl::Array<igtlFloat64>>().release();
  const igtl::ArrayBase::IndexType size = {3, 2};
  array->SetSize(size);
  std::array<double, 6> copy = numbers;
  array->SetArray(copy.data());
  igtl::NDArrayMessage::Pointer theirs = igtl::NDArrayMessage::New();
  theirs->SetArray(igtl::NDArrayMessage::TYPE_FLOAT64, array);
  EXPECT_EQ(ours("NDARRAY", "Force", array_content(numbers, 2)), packed_by_library(theirs, "Force"));
  const NumberArray back = read_array(array_content(numbers, 2));
  EXPECT_EQ(back.size, (std::vector<std::uint16_t>{3, 2}));
  EXPECT_EQ(back.values, std::vector<double>(numbers.begin(), numbers.end()));
  EXPECT_THROW(array_content(numbers, 4), InputError);
}

TEST(LinkMessage, points_are_the_librarys) {
  igtl::PointMessage::Pointer theirs = igtl::PointMessage::New();
  igtl::PointElement::Pointer point = igtl::PointElement::New();
  point->SetName("target");
  point->SetGroupName("plan");
  point->SetRGBA(46, 230, 197, 255);
  point->SetPosition(-1.5F, 2.5F, 30.0F);  // RAS
  point->SetRadius(2.0F);
  point->SetOwner("CT");
  theirs->AddPointElement(point);
  const std::array<NamedPoint, 1> mine = {{{.name = "target",
                                            .group = "plan",
                                            .colour = {46, 230, 197, 255},
                                            .place = Vec3(1.5, -2.5, 30.0),
                                            .radius = 2.0,
                                            .owner = "CT"}}};
  EXPECT_EQ(ours("POINT", "Plan", points_content(mine)), packed_by_library(theirs, "Plan"));
}

TEST(LinkMessage, a_surface_with_a_line_is_the_librarys) {
  const std::array<Vec3, 4> points = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 5, 0), Vec3(1, 2, 3)};
  const std::array<std::array<int, 3>, 2> triangles = {{{0, 1, 2}, {0, 2, 3}}};
  const std::array<int, 2> line = {0, 3};
  igtl::PolyDataMessage::Pointer theirs = igtl::PolyDataMessage::New();
  igtl::PolyDataPointArray::Pointer their_points = igtl::PolyDataPointArray::New();
  for (const Vec3& point : points) {
    their_points->AddPoint(static_cast<float>(-point.x()), static_cast<float>(-point.y()),
                           static_cast<float>(point.z()));
  }
  theirs->SetPoints(their_points);
  igtl::PolyDataCellArray::Pointer lines = igtl::PolyDataCellArray::New(), polygons = igtl::PolyDataCellArray::New();
  igtlUint32 their_line[2] = {0, 3}, first[3] = {0, 1, 2}, second[3] = {0, 2, 3};
  lines->AddCell(2, their_line);
  polygons->AddCell(3, first);
  polygons->AddCell(3, second);
  theirs->SetLines(lines);
  theirs->SetPolygons(polygons);
  EXPECT_EQ(ours("POLYDATA", "Skin", surface_content(points, triangles, line)), packed_by_library(theirs, "Skin"));
}

TEST(LinkMessage, a_picture_is_the_librarys) {
  constexpr int columns = 5, rows = 3;
  std::vector<std::uint8_t> pixels(columns * rows);
  std::iota(pixels.begin(), pixels.end(), std::uint8_t{7});
  constexpr double pixel = 0.5;
  const Pose pose = some_pose();
  igtl::ImageMessage::Pointer theirs = igtl::ImageMessage::New();
  theirs->SetDimensions(columns, rows, 1);
  theirs->SetSpacing(0.5F, 0.5F, 0.5F);
  theirs->SetScalarType(igtl::ImageMessage::TYPE_UINT8);
  theirs->SetEndian(igtl::ImageMessage::ENDIAN_LITTLE);
  theirs->SetCoordinateSystem(igtl::ImageMessage::COORDINATE_RAS);
  theirs->AllocateScalars();
  std::memcpy(theirs->GetScalarPointer(), pixels.data(), pixels.size());
  Pose centre = pose;  // of the picture
  centre.translation() = pose * Vec3(0.5 * (columns - 1) * pixel, 0.5 * (rows - 1) * pixel, 0.0);
  igtl::Matrix4x4 matrix;
  for (int row = 0; row < 4; ++row) {
    const double sign = row < 2 ? -1.0 : 1.0;
    for (int column = 0; column < 4; ++column)
      matrix[row][column] = static_cast<float>(sign * centre.matrix()(row, column));
  }
  theirs->SetMatrix(matrix);
  const Bytes expected = packed_by_library(theirs, "Image_Reference");
  const Bytes found = ours("IMAGE", "Image_Reference", image_content(pixels, columns, rows, pixel, pose));
  ASSERT_EQ(found.size(), expected.size());
  // Numbers in single precision may differ in their last bit; the library reads ours back.
  igtl::ImageMessage::Pointer back = igtl::ImageMessage::New();
  back->AllocatePack();
  igtl::MessageBase::Pointer header = igtl::MessageBase::New();
  header->InitPack();
  std::memcpy(header->GetPackPointer(), found.data(), header_size);
  header->Unpack();
  back->SetMessageHeader(header);
  back->AllocatePack();
  std::memcpy(back->GetPackBodyPointer(), found.data() + header_size, found.size() - header_size);
  ASSERT_NE(back->Unpack(1) & igtl::MessageHeader::UNPACK_BODY, 0) << "with its check sum";
  int size[3] = {};
  back->GetDimensions(size);
  EXPECT_EQ(size[0], columns);
  EXPECT_EQ(size[1], rows);
  igtl::Matrix4x4 their_matrix;
  back->GetMatrix(their_matrix);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) EXPECT_NEAR(their_matrix[row][column], matrix[row][column], 1e-4);
  }
  EXPECT_EQ(std::memcmp(back->GetScalarPointer(), pixels.data(), pixels.size()), 0);
  const GreyImage read = read_image(image_content(pixels, columns, rows, pixel, pose));
  EXPECT_EQ(read.pixels, pixels);
  EXPECT_NEAR(read.pixel, pixel, 1e-6);
  EXPECT_TRUE(read.pose.matrix().isApprox(pose.matrix(), 1e-5)) << read.pose.matrix();
}

TEST(LinkMessage, tracked_tools_are_the_librarys) {
  igtl::TrackingDataMessage::Pointer theirs = igtl::TrackingDataMessage::New();
  igtl::TrackingDataElement::Pointer tool = igtl::TrackingDataElement::New();
  tool->SetName("NeedleTipToReference");
  tool->SetType(igtl::TrackingDataElement::TYPE_6D);
  igtl::Matrix4x4 matrix;
  fill(matrix, some_pose());
  tool->SetMatrix(matrix);
  theirs->AddTrackingDataElement(tool);
  const std::array<TrackedTool, 1> tools = {{{"NeedleTipToReference", some_pose()}}};
  const Bytes found = tracking_content(tools);
  Bytes expected = packed_by_library(theirs, "Bodkin");
  expected.erase(expected.begin(), expected.begin() + header_size);
  ASSERT_EQ(expected.size(), found.size());
  expected[21] = 0;  // reserved; the library leaves it as memory was
  EXPECT_EQ(found, expected);
}

// By hand: extended header of 12 bytes, the content, a header of metadata and metadata.
TEST(LinkMessage, of_version_two_only_the_content_is_kept) {
  ByteWriter body;
  const std::string text = "key value";
  body.u16(12);
  body.u16(2);
  body.u32(static_cast<std::uint32_t>(text.size()));
  body.u32(77);
  const Bytes content = string_content("hello");
  body.raw(content);
  body.u16(1);
  body.field(text, text.size());
  const Bytes all = body.take();
  const MessageHeader header{2, "STRING", "Text", stamp, all.size(), crc64(all)};
  EXPECT_EQ(read_string(unpack(header, all).content), "hello");
  Bytes greedy = all;
  greedy[4] = 0xFF;  // more metadata than there are bytes
  const MessageHeader damaged{2, "STRING", "Text", stamp, greedy.size(), crc64(greedy)};
  EXPECT_THROW(unpack(damaged, greedy), InputError);
}

TEST(LinkMessage, a_time_that_the_header_cannot_hold_becomes_the_nearest) {
  const auto sent = [](double time) { return read_header(pack({"STRING", "device", time, {}})).time; };
  const double last = std::nextafter(4294967296.0, 0.0);  // s; a stamp of nothing but ones is, as a double, 2^32
  EXPECT_EQ(sent(stamp + 0.5), stamp + 0.5);
  EXPECT_EQ(sent(last), last);
  EXPECT_EQ(sent(4294967296.0), last);
  EXPECT_EQ(sent(1e300), last);
  EXPECT_EQ(sent(-1.0), 0.0);
  EXPECT_EQ(sent(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(LinkMessage, the_check_sum_is_that_of_ecma_182) {
  const std::string digits = "123456789";
  EXPECT_EQ(crc64(std::span(reinterpret_cast<const std::uint8_t*>(digits.data()), digits.size())),
            0x6C40DF5F0B497347ULL);  // the catalogue's check value
}

TEST(LinkMessage, what_arrives_damaged_or_is_none_is_refused_with_a_sentence) {
  Bytes good = ours("STRING", "Text", string_content("hello"));
  const auto refused = [](const Bytes& bytes) -> std::string {
    try {
      unpack(read_header(std::span(bytes).first(std::min(bytes.size(), header_size))),
             std::span(bytes).subspan(std::min(bytes.size(), header_size)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refused(good), "accepted");
  for (std::size_t at = header_size; at < good.size(); ++at) {
    Bytes flipped = good;
    flipped[at] ^= 0x10;
    EXPECT_THAT(refused(flipped), HasSubstr("arrived damaged"));
  }
  EXPECT_THAT(refused(Bytes(good.begin(), good.begin() + 30)), HasSubstr("bytes too early"));
  const std::string http = "GET / HTTP/1.1\r\nHost: bodkin\r\nUser-Agent: a browser that got lost\r\n\r\n";
  EXPECT_THAT(refused(Bytes(http.begin(), http.end())), HasSubstr("another protocol"));
  EXPECT_THROW(pack({"TRANSFORM", "a name of more than twenty bytes", 0.0, {}}), InputError);
}

TEST(LinkMessage, random_bytes_never_do_more_than_be_refused) {
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes(random() % 200);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const MessageHeader header{
        static_cast<std::uint16_t>(1 + random() % 3), "X", "Y", 0.0, bytes.size(), crc64(bytes)};
    try {
      const Message message = unpack(header, bytes);
      read_array(message.content);
      read_transform(message.content);
      read_string(message.content);
    } catch (const InputError&) {
    }
  }
}

TEST(LinkCommand, is_read_from_a_string_as_plus_sends_it) {
  const Message message{
      "STRING", "CMD_12", stamp,
      string_content(R"(<Command Name="SetUsParameter"><Parameter Name="DepthMm" Value="55"/></Command>)")};
  const std::optional<Command> command = command_of(message);
  ASSERT_TRUE(command);
  EXPECT_EQ(command->name, "SetUsParameter");
  EXPECT_EQ(command->number("DepthMm"), 55.0);
  EXPECT_THROW(command->number("GainDb"), InputError);
  const Message reply = reply_to(message, true, "done & \"well\"", stamp);
  EXPECT_EQ(reply.type, "STRING");
  EXPECT_EQ(reply.device, "ACK_12");
  EXPECT_EQ(read_string(reply.content), R"(<CommandReply Status="SUCCESS" Message="done &amp; &quot;well&quot;"/>)");
  EXPECT_FALSE(command_of({"STRING", "Text", stamp, string_content("hello")}));
  EXPECT_FALSE(command_of({"TRANSFORM", "CMD_1", stamp, {}}));
}

TEST(LinkCommand, is_read_from_a_command_and_answered_with_its_number) {
  ByteWriter writer;
  const std::string text = R"(<Command Name="Freeze" On="true"/>)";
  writer.u32(4711);
  writer.field("Freeze", 128);
  writer.u16(3);
  writer.u32(static_cast<std::uint32_t>(text.size()));
  writer.field(text, text.size());
  const Message message{"COMMAND", "Slicer", stamp, writer.take()};
  const std::optional<Command> command = command_of(message);
  ASSERT_TRUE(command);
  EXPECT_EQ(command->name, "Freeze");
  EXPECT_EQ(command->values.at("On"), "true");
  const Message reply = reply_to(message, false, "no", stamp);
  EXPECT_EQ(reply.type, "RTS_COMMAND");
  ByteReader reader(reply.content);
  EXPECT_EQ(reader.u32(), 4711U);
}

TEST(LinkCommand, that_cannot_be_read_says_why) {
  const auto sentence = [](const std::string& text) -> std::string {
    try {
      command_of({"STRING", "CMD_1", stamp, string_content(text)});
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(sentence("<Command Name='"), HasSubstr("the command"));
  EXPECT_THAT(sentence("<Command/>"), HasSubstr("Name"));
  EXPECT_THAT(sentence("<Other Name='x'/>"), HasSubstr("Other"));
  EXPECT_THAT(sentence("<!DOCTYPE a [<!ENTITY b 'c'>]><Command Name='&b;'/>"), HasSubstr("the command"));
  EXPECT_THAT(sentence("<Command Name='x' More='" + std::string(5000, 'a') + "'/>"), HasSubstr("at most 4096"));
}

}  // namespace
}  // namespace bodkin::link
