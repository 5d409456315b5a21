#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include "core/error.h"
#include "io/mesh/foreign_mesh.h"
#include "io/mesh/mesh_builder.h"
#include "io/mesh/vtu_array.h"
#include "io/xml_document.h"

namespace bodkin::io {
namespace {

constexpr int vtk_tetrahedron = 10;
constexpr int vtk_tetrahedron_of_second_order = 24;
constexpr std::array<int, 7> flat_types = {1, 2, 3, 4, 5, 6, 7};  // points, lines, faces of first order
constexpr std::size_t most_bytes_per_value = 1040;                // of a file's byte, packed by zlib
constexpr std::array<const char*, 6> region_names = {"tissue", "gmsh:physical", "medit:ref",
                                                     "region", "material",      "label"};

std::string_view content(const xmlChar* text) {
  return text == nullptr ? std::string_view() : std::string_view(reinterpret_cast<const char*>(text));
}

struct DocumentEnd {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};
struct ContextEnd {
  void operator()(xmlParserCtxt* context) const { xmlFreeParserCtxt(context); }
};

// The file without its appended data, which may not be XML.
struct SplitFile {
  std::string xml;
  VtuAppended appended;
};

SplitFile split_file(std::string_view bytes, const std::string& origin) {
  const std::size_t begin = bytes.find("<AppendedData");
  if (begin == std::string_view::npos) return {std::string(bytes), {}};
  const std::size_t tag_end = bytes.find('>', begin);
  const std::size_t underscore = tag_end == std::string_view::npos ? tag_end : bytes.find('_', tag_end);
  const std::size_t end = bytes.rfind("</AppendedData>");
  if (underscore == std::string_view::npos || end == std::string_view::npos || end < underscore)
    throw InputError(fmt::format("{}: the appended data does not begin with '_', or does not end", origin));
  SplitFile parts;
  const std::string_view tag = bytes.substr(begin, tag_end - begin);
  parts.appended.raw = tag.find("\"raw\"") != std::string_view::npos || tag.find("'raw'") != std::string_view::npos;
  parts.appended.bytes = bytes.substr(underscore + 1, end - underscore - 1);
  parts.xml = std::string(bytes.substr(0, tag_end + 1)) + std::string(bytes.substr(end));
  return parts;
}

class VtuReader {
 public:
  VtuReader(std::string_view bytes, const std::string& origin)
      : origin_(origin), file_size_(bytes.size()), parts_(split_file(bytes, origin)) {}

  ForeignMesh read() {
    const std::unique_ptr<xmlParserCtxt, ContextEnd> context(xmlNewParserCtxt());
    if (!context) throw SystemError("out of memory while reading " + origin_);
    const int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE |
                        XML_PARSE_BIG_LINES | XML_PARSE_NOCDATA;
    const std::unique_ptr<xmlDoc, DocumentEnd> document(xmlCtxtReadMemory(
        context.get(), parts_.xml.data(), static_cast<int>(parts_.xml.size()), nullptr, nullptr, options));
    if (!document) {
      const xmlError* problem = xmlCtxtGetLastError(context.get());
      fail_at(
          origin_, problem == nullptr ? 0 : problem->line,
          fmt::format("this is not well-formed XML ({})",
                      problem == nullptr || problem->message == nullptr ? "damaged" : one_line(problem->message)));
    }
    if (document->intSubset != nullptr) fail_at(origin_, 1, "there is a document type, expected none");
    const xmlNode* root = xmlDocGetRootElement(document.get());
    if (root == nullptr || content(root->name) != "VTKFile" || attribute(root, "type") != "UnstructuredGrid") {
      fail_at(origin_, 1, "this is not a VTKFile of type UnstructuredGrid, expected a .vtu file");
    }
    storage_.big_endian = attribute(root, "byte_order") == "BigEndian";
    storage_.long_headers = attribute(root, "header_type") == "UInt64";
    const std::string packer = attribute(root, "compressor");
    storage_.packed = packer == "vtkZLibDataCompressor";
    if (!packer.empty() && !storage_.packed) {
      fail(root, fmt::format("compressor is {}, expected vtkZLibDataCompressor or none", in_quotes(packer)));
    }
    return mesh(child(child(root, "UnstructuredGrid"), "Piece"));
  }

 private:
  std::string where(const xmlNode* node) const { return fmt::format("{}, line {}", origin_, xmlGetLineNo(node)); }
  [[noreturn]] void fail(const xmlNode* node, const std::string& sentence) const {
    throw InputError(fmt::format("{}: {}", where(node), sentence));
  }

  static std::string attribute(const xmlNode* node, const char* name) {
    for (const xmlAttr* a = node->properties; a != nullptr; a = a->next) {
      if (content(a->name) != name) continue;
      return a->children == nullptr ? std::string() : std::string(content(a->children->content));
    }
    return {};
  }

  static std::vector<const xmlNode*> children(const xmlNode* node, std::string_view name) {
    std::vector<const xmlNode*> found;
    for (const xmlNode* c = node->children; c != nullptr; c = c->next) {
      if (c->type == XML_ELEMENT_NODE && content(c->name) == name) found.push_back(c);
    }
    return found;
  }

  const xmlNode* child(const xmlNode* node, std::string_view name) const {
    const auto found = children(node, name);
    if (found.size() != 1) {
      fail(node, fmt::format("{} holds {} elements {}, expected one", content(node->name), found.size(), name));
    }
    return found.front();
  }

  std::size_t count(const xmlNode* node, const char* name, std::size_t most) const {
    const std::string text = attribute(node, name);
    std::uint64_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || value == 0 || value > most)
      fail(node, fmt::format("{} is {}, expected 1 to {}", name, in_quotes(text), most));
    if (value > file_size_ * most_bytes_per_value)
      fail(node, fmt::format("{} is {}, but the file is too short for so many", name, value));
    return static_cast<std::size_t>(value);
  }

  VtuArray array(const xmlNode* node) {
    VtuArray found;
    found.name = attribute(node, "Name");
    if (found.name.empty()) found.name = "Points";
    found.type = attribute(node, "type");
    found.format = attribute(node, "format");
    const auto number = [&](const char* name, std::size_t fallback) {
      const std::string text = attribute(node, name);
      if (text.empty()) return fallback;
      std::size_t value = 0;
      const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (problem != std::errc() || end != text.data() + text.size())
        fail(node, fmt::format("{} is {}, expected a whole number", name, in_quotes(text)));
      return value;
    };
    found.components = number("NumberOfComponents", 1);
    found.offset = number("offset", 0);
    const xmlNode* text = node->children;
    while (text != nullptr && text->type != XML_TEXT_NODE) text = text->next;
    if (text != nullptr) found.text = content(text->content);
    return found;
  }

  std::vector<std::int64_t> wholes(const xmlNode* parent, std::string_view name, std::size_t expected,
                                   std::size_t most) {
    for (const xmlNode* node : children(parent, "DataArray")) {
      if (attribute(node, "Name") == name)
        return vtu_wholes(array(node), storage_, parts_.appended, expected, most, where(node));
    }
    fail(parent, fmt::format("there is no DataArray {}", name));
  }

  // The cell array that says which region each cell is in.
  const xmlNode* region_array(const xmlNode* piece) const {
    std::vector<const xmlNode*> candidates;
    for (const xmlNode* data : children(piece, "CellData")) {
      for (const xmlNode* node : children(data, "DataArray")) {
        const std::string components = attribute(node, "NumberOfComponents");
        if (components.empty() || components == "1") candidates.push_back(node);
      }
    }
    for (const char* name : region_names) {
      for (const xmlNode* node : candidates) {
        if (attribute(node, "Name") == name) return node;
      }
    }
    std::erase_if(candidates, [](const xmlNode* node) { return !is_whole_type(attribute(node, "type")); });
    if (candidates.size() == 1) return candidates.front();
    fail(piece, "no cell array gives the regions, expected one named 'tissue'");
  }

  ForeignMesh mesh(const xmlNode* piece) {
    const std::size_t nodes = count(piece, "NumberOfPoints", most_mesh_nodes);
    const std::size_t cells = count(piece, "NumberOfCells", most_mesh_elements);
    const xmlNode* points = child(child(piece, "Points"), "DataArray");
    const std::vector<double> places =
        vtu_numbers(array(points), storage_, parts_.appended, 3 * nodes, 3 * nodes, where(points));
    MeshBuilder builder;
    builder.mesh().nodes.reserve(nodes);
    const std::string at_points = where(points);
    for (std::size_t n = 0; n < nodes; ++n) {
      builder.add_node({places[3 * n], places[3 * n + 1], places[3 * n + 2]}, at_points);
    }
    const xmlNode* topology = child(piece, "Cells");
    const std::vector<std::int64_t> types = wholes(topology, "types", cells, cells);
    const std::vector<std::int64_t> offsets = wholes(topology, "offsets", cells, cells);
    const std::vector<std::int64_t> corners = wholes(topology, "connectivity", 0, 8 * cells);
    const xmlNode* data = region_array(piece);
    const std::vector<double> regions =
        vtu_numbers(array(data), storage_, parts_.appended, cells, cells, where(data));
    add_cells(builder, types, offsets, corners, regions, where(topology), where(data));
    return builder.finish(origin_);
  }

  void add_cells(MeshBuilder& builder, const std::vector<std::int64_t>& types,
                 const std::vector<std::int64_t>& offsets, const std::vector<std::int64_t>& corners,
                 const std::vector<double>& regions, const std::string& at_cells, const std::string& at_regions) {
    std::int64_t begin = 0;
    std::size_t left_out = 0;
    for (std::size_t c = 0; c < types.size(); ++c) {
      const std::string name = fmt::format("cell {}", c);
      if (offsets[c] < begin || offsets[c] > static_cast<std::int64_t>(corners.size())) {
        throw InputError(fmt::format("{}: {} has the offset {}, expected {} to {}", at_cells, name, offsets[c], begin,
                                     corners.size()));
      }
      const std::int64_t first = std::exchange(begin, offsets[c]);
      if (std::find(flat_types.begin(), flat_types.end(), types[c]) != flat_types.end()) {
        ++left_out;
        continue;
      }
      if (types[c] != vtk_tetrahedron || offsets[c] - first != 4) {
        throw InputError(fmt::format("{}: {} has the type {} and {} nodes, expected tetrahedra{} (type 10, 4 nodes)",
                                     at_cells, name, types[c], offsets[c] - first,
                                     types[c] == vtk_tetrahedron_of_second_order ? " of first order" : ""));
      }
      std::array<std::uint32_t, 4> element{};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::int64_t node = corners[static_cast<std::size_t>(first) + i];
        if (node < 0 || node >= static_cast<std::int64_t>(builder.node_count())) {
          throw InputError(fmt::format("{}: {} has the node {}, expected 0 to {}", at_cells, name, node,
                                       builder.node_count() - 1));
        }
        element[i] = static_cast<std::uint32_t>(node);
      }
      if (!(regions[c] >= -1e9 && regions[c] <= 1e9 &&
            regions[c] == static_cast<double>(static_cast<std::int64_t>(regions[c])))) {
        throw InputError(
            fmt::format("{}: {} has the region {:g}, expected a whole number", at_regions, name, regions[c]));
      }
      builder.add_element(element, static_cast<std::int64_t>(regions[c]), name, at_cells);
    }
    if (left_out > 0) {
      builder.mesh().notes.push_back(
          fmt::format("{} cells that are no tetrahedra (points, lines, surfaces) were left out.", left_out));
    }
  }

  const std::string& origin_;
  std::size_t file_size_;
  SplitFile parts_;
  VtuStorage storage_;
};

}  // namespace

ForeignMesh parse_vtu(std::string_view bytes, const std::string& origin) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError(fmt::format("{}: the file is larger than 2 GB", origin));
  return VtuReader(bytes, origin).read();
}

std::string vtu_text(const anatomy::TetrahedralMesh& mesh) {
  std::string text;
  text.reserve(60 * mesh.nodes.size() + 40 * mesh.elements.size() + 2000);
  auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                 "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                 "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n"
                 "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n",
                 mesh.nodes.size(), mesh.elements.size());
  for (const Vec3& node : mesh.nodes) fmt::format_to(out, "{} {} {}\n", node.x(), node.y(), node.z());
  text += "</DataArray>\n</Points>\n<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const auto& corner : mesh.elements) {
    fmt::format_to(out, "{} {} {} {}\n", corner[0], corner[1], corner[2], corner[3]);
  }
  text += "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) fmt::format_to(out, "{}\n", 4 * (e + 1));
  text += "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) text += "10\n";
  text +=
      "</DataArray>\n</Cells>\n<CellData Scalars=\"tissue\">\n<DataArray type=\"UInt8\" Name=\"tissue\" "
      "format=\"ascii\">\n";
  for (const anatomy::TissueId id : mesh.tissues) fmt::format_to(out, "{}\n", id);
  text += "</DataArray>\n</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

}  // namespace bodkin::io
