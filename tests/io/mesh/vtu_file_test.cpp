#include <cstring>
#include <functional>

#include "tests/io/foreign_meshes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "core/error.h"
#include "io/mesh/foreign_mesh.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

using ::testing::HasSubstr;

std::string vtu_refusal(const std::string& text) {
  try {
    parse_vtu(text, "body.vtu");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string vtu_changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string encoded(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = group << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += at + i <= bytes.size() ? letters[group >> (18 - 6 * i) & 63] : '=';
    }
  }
  return text;
}

template <typename Value>
std::string bytes_of(const std::vector<Value>& values) {
  std::string bytes(values.size() * sizeof(Value), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

// How a writer of VTK files stores one array; independent of our reader.
struct VtkWriter {
  bool packed = false, raw = false, appended = false;
  std::string appendix;
  std::size_t block = 100;  // bytes that are packed together

  template <typename Header>
  std::string stored(const std::string& bytes) const {
    if (!packed) {
      const std::string head = bytes_of(std::vector<Header>{static_cast<Header>(bytes.size())});
      return raw ? head + bytes : encoded(head + bytes);
    }
    std::vector<Header> head = {static_cast<Header>((bytes.size() + block - 1) / block), static_cast<Header>(block),
                                static_cast<Header>(bytes.size() % block)};
    std::string data;
    for (std::size_t at = 0; at < bytes.size(); at += block) {
      const std::string piece = bytes.substr(at, block);
      std::string small(piece.size() + 100, '\0');
      uLongf size = small.size();
      compress(reinterpret_cast<Bytef*>(small.data()), &size, reinterpret_cast<const Bytef*>(piece.data()),
               piece.size());
      head.push_back(static_cast<Header>(size));
      data += small.substr(0, size);
    }
    return raw ? bytes_of(head) + data : encoded(bytes_of(head)) + encoded(data);
  }

  template <typename Header>
  std::string array(const std::string& type, const std::string& name, int components, const std::string& bytes) {
    std::string tag =
        fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" ", type, name, components);
    if (appended) {
      tag += fmt::format("format=\"appended\" offset=\"{}\"/>\n", appendix.size());
      appendix += stored<Header>(bytes);
      return tag;
    }
    return tag + "format=\"binary\">\n" + stored<Header>(bytes) + "\n</DataArray>\n";
  }

  template <typename Header>
  std::string file(const TetrahedralMesh& mesh) {
    std::vector<float> points;
    std::vector<std::int32_t> corners;
    std::vector<std::int64_t> offsets;
    for (const Vec3& node : mesh.nodes) {
      for (int axis = 0; axis < 3; ++axis) points.push_back(static_cast<float>(node[axis]));
    }
    for (const auto& element : mesh.elements) {
      for (const std::uint32_t node : element) corners.push_back(static_cast<std::int32_t>(node));
      offsets.push_back(static_cast<std::int64_t>(corners.size()));
    }
    const std::vector<std::uint8_t> types(mesh.elements.size(), 10);
    std::string text = fmt::format(
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"{}\"{}>\n"
        "<UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData/>\n<CellData>\n",
        sizeof(Header) == 8 ? "UInt64" : "UInt32", packed ? " compressor=\"vtkZLibDataCompressor\"" : "",
        mesh.nodes.size(), mesh.elements.size());
    text += array<Header>("Int16", "medit:ref", 1,
                          bytes_of(std::vector<std::int16_t>(mesh.tissues.begin(), mesh.tissues.end())));
    text += "</CellData>\n<Points>" + array<Header>("Float32", "Points", 3, bytes_of(points)) + "</Points>\n<Cells>";
    text += array<Header>("Int32", "connectivity", 1, bytes_of(corners));
    text += array<Header>("Int64", "offsets", 1, bytes_of(offsets));
    text += array<Header>("UInt8", "types", 1, bytes_of(types));
    text += "</Cells>\n</Piece></UnstructuredGrid>\n";
    if (appended) {
      text += fmt::format("<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n", raw ? "raw" : "base64", appendix);
    }
    return text + "</VTKFile>\n";
  }
};

TEST(VtuFile, what_is_written_reads_back_to_the_same_bits) {
  const TetrahedralMesh mesh = block_mesh(3, 1.0 / 7.0);
  const ForeignMesh read = parse_vtu(vtu_text(mesh), "body.vtu");
  EXPECT_EQ(read.nodes, mesh.nodes);
  EXPECT_EQ(read.elements, mesh.elements);
  ASSERT_EQ(read.regions.size(), mesh.tissues.size());
  for (std::size_t e = 0; e < mesh.tissues.size(); ++e) EXPECT_EQ(read.regions[e], mesh.tissues[e]);
  EXPECT_TRUE(read.notes.empty());
}

TEST(VtuFile, every_way_in_which_vtk_stores_arrays_is_read) {
  const TetrahedralMesh mesh = block_mesh(3, 0.5);
  for (const bool packed : {false, true}) {
    for (const int place : {0, 1, 2}) {
      for (const bool wide : {false, true}) {
        VtkWriter writer{.packed = packed, .raw = place == 2, .appended = place > 0, .appendix = {}, .block = 100};
        const std::string text = wide ? writer.file<std::uint64_t>(mesh) : writer.file<std::uint32_t>(mesh);
        const ForeignMesh read = parse_vtu(text, "body.vtu");
        ASSERT_EQ(read.nodes.size(), mesh.nodes.size()) << packed << place << wide;
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) EXPECT_LT((read.nodes[n] - mesh.nodes[n]).norm(), 1e-6);
        EXPECT_EQ(read.elements, mesh.elements);
        for (std::size_t e = 0; e < mesh.tissues.size(); ++e) EXPECT_EQ(read.regions[e], mesh.tissues[e]);
      }
    }
  }
}

TEST(VtuFile, packed_arrays_may_be_smaller_than_the_block_that_their_writer_uses) {
  const TetrahedralMesh mesh = block_mesh(1, 0.5);
  VtkWriter writer{.packed = true, .raw = false, .appended = true, .appendix = {}, .block = 32768};
  EXPECT_EQ(parse_vtu(writer.file<std::uint32_t>(mesh), "body.vtu").elements, mesh.elements);
}

TEST(VtuFile, every_damage_gets_a_sentence) {
  const std::string good = vtu_text(block_mesh(2, 1.0));
  const auto expect = [](const std::string& text, const std::string& sentence) {
    const std::string said = vtu_refusal(text);
    EXPECT_THAT(said, HasSubstr("body.vtu"));
    EXPECT_THAT(said, HasSubstr(sentence));
  };
  expect("", "not well-formed XML");
  expect(good.substr(0, good.size() / 2), "not well-formed XML");
  expect("<VTKFile type=\"ImageData\"/>", "not a VTKFile of type UnstructuredGrid");
  expect("<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile type=\"UnstructuredGrid\"/>", "a document type");
  expect(vtu_changed(good, "NumberOfPoints=\"27\"", "NumberOfPoints=\"28\""), "has 81 values, expected 84");
  expect(vtu_changed(good, "NumberOfPoints=\"27\"", "NumberOfPoints=\"26\""), "more than 78 values");
  expect(vtu_changed(good, "NumberOfPoints=\"27\"", "NumberOfPoints=\"99999999999\""), "expected 1 to 4000000");
  expect(vtu_changed(good, "NumberOfCells=\"40\"", "NumberOfCells=\"0\""), "expected 1 to 24000000");
  expect(vtu_changed(good, "NumberOfCells=\"40\"", "NumberOfCells=\"x\""), "NumberOfCells is 'x'");
  expect(vtu_changed(good, "\n0.1 ", "\nnan "), "node 1 has the coordinate nan");
  expect(vtu_changed(good, "\n0.1 ", "\nabc "), "value 1 is 'abc', expected a number");
  expect(vtu_changed(good, "Name=\"connectivity\"", "Name=\"other\""), "there is no DataArray connectivity");
  expect(vtu_changed(good, "\n0 1 3 9\n", "\n0 1 3 27\n"), "cell 0 has the node 27, expected 0 to 26");
  expect(vtu_changed(good, "\n0 1 3 9\n", "\n0 1 1 9\n"), "cell 0 has one node twice");
  expect(vtu_changed(good, "\n0 1 3 9\n", "\n0 1 3.5 9\n"), "value 3 is '3.5', expected a whole number");
  expect(vtu_changed(good, "\n4\n8\n", "\n4\n3\n"), "cell 1 has the offset 3, expected 4 to 160");
  expect(vtu_changed(good, "\n10\n", "\n24\n"), "cell 0 has the type 24 and 4 nodes, expected tetrahedra of first");
  expect(vtu_changed(good, "Name=\"tissue\" format", "Name=\"tissue\" NumberOfComponents=\"3\" format"),
         "expected one named 'tissue'");
  expect(vtu_changed(good, "type=\"Float64\"", "type=\"Float16\""), "has the type 'Float16'");
  expect(vtu_changed(good, "format=\"ascii\"", "format=\"text\""), "the format 'text', expected ascii");
  expect(vtu_changed(good, "<Piece", "<Piece/><Piece"), "holds 2 elements Piece, expected one");
  expect(vtu_changed(good, "byte_order=\"LittleEndian\"", "compressor=\"vtkLZ4DataCompressor\""), "vtkLZ4");
}

TEST(VtuFile, binary_data_that_does_not_hold_what_it_says_is_refused) {
  const TetrahedralMesh mesh = block_mesh(2, 1.0);
  VtkWriter appended{.packed = false, .raw = true, .appended = true, .appendix = {}, .block = 100};
  std::string text = appended.file<std::uint32_t>(mesh);
  EXPECT_THAT(vtu_refusal(vtu_changed(text, "offset=\"0\"", "offset=\"123456\"")), HasSubstr("behind the end"));
  const std::size_t header = text.find("\n_") + 2;
  std::string huge = text;
  huge.replace(header, 4, "\xFF\xFF\xFF\x7F");
  EXPECT_THAT(vtu_refusal(huge), HasSubstr("the data says that it has 2147483647 bytes"));
  EXPECT_THAT(vtu_refusal(vtu_changed(text, "</AppendedData>", "")),
              HasSubstr("does not begin with '_', or does not"));
  VtkWriter packed{.packed = true, .raw = false, .appended = false, .appendix = {}, .block = 100};
  text = packed.file<std::uint32_t>(mesh);
  EXPECT_THAT(vtu_refusal(vtu_changed(text, "format=\"binary\">\n", "format=\"binary\">\n!")),
              HasSubstr("not base64"));
  // Any changed letter is either reported or changes a value; it never crashes the reader.
  const std::size_t begin = text.find("Float32");
  for (std::size_t at = begin; at < text.size(); at += 7) {
    std::string other = text;
    other[at] = other[at] == 'A' ? 'B' : 'A';
    vtu_refusal(other);
  }
}

}  // namespace
}  // namespace bodkin
