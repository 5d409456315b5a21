#include <algorithm>
#include <charconv>
#include <optional>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "io/mesh/foreign_mesh.h"
#include "io/mesh/mesh_builder.h"
#include "io/xml_document.h"

namespace bodkin::io {
namespace {

constexpr std::size_t least_bytes_per_node = 6;     // "0 0 0\n" of version 4.1
constexpr std::size_t least_bytes_per_element = 9;  // "1 1 2 3 4"; a point's "1 1\n" needs less
constexpr std::size_t least_bytes_per_line = 2;
constexpr int tetrahedron = 4;
constexpr int tetrahedron_of_second_order = 11;

// Nodes of Gmsh's element types 1 to 31 of up to third order; 0: not among them.
constexpr std::array<int, 32> nodes_of_type = {0, 2,  3,  4,  4, 8,  6,  5,  3,  6,  9, 10, 27, 18, 14, 1,
                                               8, 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5,  6,  20, 35, 56};

// Words of a text, with the line on which each stands.
class Words {
 public:
  Words(std::string_view text, const std::string& origin) : text_(text), origin_(origin) {}

  [[noreturn]] void fail(const std::string& sentence) const { fail_at(origin_, line_, sentence); }
  std::string where() const { return fmt::format("{}, line {}", origin_, line_); }
  std::size_t left() const { return text_.size() - at_; }

  // Empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && is_blank(text_[at_])) {
      if (text_[at_] == '\n') ++line_;
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  // The rest of the present line.
  std::string_view rest_of_line() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    return text_.substr(begin, at_ - begin);
  }
  std::int64_t whole(const char* what) {
    const std::string_view word = next();
    std::int64_t value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty()) fail(fmt::format("the file ends where {} was expected", what));
    if (problem != std::errc() || end != word.data() + word.size())
      fail(fmt::format("{} is {}, expected a whole number", what, in_quotes(word)));
    return value;
  }
  double number(const char* what) {
    const std::string_view word = next();
    double value = 0.0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty()) fail(fmt::format("the file ends where {} was expected", what));
    if (problem != std::errc() || end != word.data() + word.size())
      fail(fmt::format("{} is {}, expected a number", what, in_quotes(word)));
    return value;
  }
  // A count of items, each of which needs some of the remaining bytes.
  std::size_t count(const char* what, std::size_t most, std::size_t least_bytes) {
    const std::int64_t value = whole(what);
    if (value < 0 || static_cast<std::uint64_t>(value) > most)
      fail(fmt::format("{} is {}, expected 0 to {}", what, value, most));
    if (static_cast<std::size_t>(value) > left() / least_bytes + 1)
      fail(fmt::format("{} is {}, but the rest of the file is too short for so many", what, value));
    return static_cast<std::size_t>(value);
  }
  void expect(std::string_view word) {
    const std::string_view found = next();
    if (found != word)
      fail(fmt::format("there is {}, expected {}", found.empty() ? "the end of the file" : in_quotes(found), word));
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  std::string_view text_;
  const std::string& origin_;
  std::size_t at_ = 0;
  int line_ = 1;
};

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& origin) : words_(text, origin), origin_(origin) {}

  ForeignMesh read() {
    format();
    bool elements_read = false;
    for (std::string_view section = words_.next(); !section.empty(); section = words_.next()) {
      if (section == "$PhysicalNames") {
        names();
      } else if (section == "$Entities" && version_4_) {
        entities();
      } else if (section == "$Nodes") {
        if (builder_.node_count() > 0) words_.fail("there is a second section $Nodes, expected one");
        version_4_ ? nodes_4() : nodes_2();
      } else if (section == "$Elements") {
        if (builder_.node_count() == 0) words_.fail("$Elements stand before $Nodes, expected nodes first");
        if (std::exchange(elements_read, true)) words_.fail("there is a second section $Elements, expected one");
        version_4_ ? elements_4() : elements_2();
      } else if (section.front() == '$') {
        skip(section);
      } else {
        words_.fail(fmt::format("there is {}, expected a section such as $Nodes", in_quotes(section)));
      }
    }
    if (builder_.node_count() == 0) words_.fail("there are no nodes (no section $Nodes)");
    ForeignMesh& mesh = builder_.mesh();
    if (left_out_ > 0) {
      mesh.notes.push_back(
          fmt::format("{} elements that are no tetrahedra (points, lines, surfaces) were left out.", left_out_));
    }
    if (without_group_ > 0) {
      mesh.notes.push_back(fmt::format(
          "{} tetrahedra belong to no physical group; their region is the number of their volume.", without_group_));
    }
    return builder_.finish(origin_);
  }

 private:
  void format() {
    if (words_.next() != "$MeshFormat") {
      fail_at(origin_, 1, "the file does not begin with $MeshFormat; it is not a mesh of Gmsh");
    }
    const std::string version(words_.next());
    if (version != "2.2" && version != "4.1") {
      words_.fail(
          fmt::format("the format's version is {}, expected 2.2 or 4.1; save it again with 'gmsh FILE -save "
                      "-format msh41'",
                      in_quotes(version)));
    }
    version_4_ = version == "4.1";
    if (words_.whole("the file type") != 0) {
      words_.fail("the mesh is binary, expected ASCII; save it again without -bin (Mesh.Binary = 0)");
    }
    words_.whole("the size of a number");
    words_.expect("$EndMeshFormat");
  }

  void skip(std::string_view section) {
    const std::string end = "$End" + std::string(section.substr(1));
    for (std::string_view word = words_.next(); word != end; word = words_.next()) {
      if (word.empty()) words_.fail(fmt::format("the section {} does not end", in_quotes(section)));
    }
  }

  void names() {
    const std::size_t count = words_.count("the number of physical names", 1'000'000, least_bytes_per_line);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t dimension = words_.whole("the dimension of a physical name");
      const std::int64_t tag = words_.whole("the tag of a physical name");
      std::string name = one_line(words_.rest_of_line());
      if (name.size() < 2 || name.front() != '"' || name.back() != '"')
        words_.fail(fmt::format("the physical name is {}, expected it in double quotes", in_quotes(name)));
      if (dimension == 3) builder_.mesh().names[tag] = name.substr(1, name.size() - 2);
    }
    words_.expect("$EndPhysicalNames");
  }

  void numbers(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) words_.number("a bound of an entity");
  }
  void wholes(const char* what) {
    const std::size_t count = words_.count(what, 1'000'000, least_bytes_per_line);
    for (std::size_t i = 0; i < count; ++i) words_.whole("a tag of an entity");
  }

  void entities() {
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts)
      count = words_.count("the number of entities", 10'000'000, least_bytes_per_line);
    for (std::size_t dimension = 0; dimension < 4; ++dimension) {
      for (std::size_t i = 0; i < counts[dimension]; ++i) {
        const std::int64_t tag = words_.whole("the tag of an entity");
        numbers(dimension == 0 ? 3 : 6);
        const std::size_t groups = words_.count("the number of physical groups", 1'000'000, least_bytes_per_line);
        for (std::size_t g = 0; g < groups; ++g) {
          const std::int64_t group = words_.whole("a physical group");
          if (dimension == 3 && g == 0) group_of_volume_[tag] = group;
        }
        if (dimension > 0) wholes("the number of bounding entities");
      }
    }
    words_.expect("$EndEntities");
  }

  void add_node(std::int64_t tag, double x, double y, double z) {
    if (!position_.emplace(tag, static_cast<std::uint32_t>(builder_.node_count())).second)
      words_.fail(fmt::format("node {} is given twice", tag));
    builder_.add_node({x, y, z}, words_.where());
  }
  Vec3 point() {
    const double x = words_.number("a coordinate"), y = words_.number("a coordinate");
    return {x, y, words_.number("a coordinate")};
  }

  void nodes_2() {
    const std::size_t count = words_.count("the number of nodes", most_mesh_nodes, least_bytes_per_node);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t tag = words_.whole("the number of a node");
      const Vec3 place = point();
      add_node(tag, place.x(), place.y(), place.z());
    }
    words_.expect("$EndNodes");
  }

  void nodes_4() {
    const std::size_t blocks = words_.count("the number of blocks of nodes", most_mesh_nodes, least_bytes_per_line);
    const std::size_t all = words_.count("the number of nodes", most_mesh_nodes, least_bytes_per_node);
    words_.whole("the smallest tag of a node");
    words_.whole("the largest tag of a node");
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = words_.whole("the dimension of an entity");
      words_.whole("the tag of an entity");
      const bool parametric = words_.whole("whether nodes are parametric") != 0;
      const std::size_t count = words_.count("the number of nodes of a block", all, least_bytes_per_node);
      std::vector<std::int64_t> tags(count);
      for (std::int64_t& tag : tags) tag = words_.whole("the tag of a node");
      for (const std::int64_t tag : tags) {
        const Vec3 place = point();
        if (parametric) numbers(static_cast<std::size_t>(std::clamp<std::int64_t>(dimension, 0, 3)));
        add_node(tag, place.x(), place.y(), place.z());
      }
    }
    if (builder_.node_count() != all) {
      words_.fail(fmt::format("there are {} nodes, but {} were announced", builder_.node_count(), all));
    }
    words_.expect("$EndNodes");
  }

  // The corners of one element of a type; only a tetrahedron's are kept.
  std::optional<std::array<std::uint32_t, 4>> corners(std::int64_t type, std::int64_t element) {
    if (type == tetrahedron_of_second_order) {
      words_.fail(
          fmt::format("element {} is a tetrahedron of second order, expected first order; save the mesh again "
                      "with 'gmsh FILE -save -order 1'",
                      element));
    }
    const bool known = type > 0 && type < static_cast<std::int64_t>(nodes_of_type.size());
    const int count = known ? nodes_of_type[static_cast<std::size_t>(type)] : 0;
    if (count == 0) words_.fail(fmt::format("element {} has the type {}, which is not known", element, type));
    const bool solid = type == 5 || type == 6 || type == 7 || type == 12 || type == 13 || type == 14 ||
                       (type >= 17 && type <= 19) || type >= 29;
    if (solid) {
      words_.fail(
          fmt::format("element {} is a solid of type {}, expected tetrahedra (type 4) only; mesh the body "
                      "with tetrahedra",
                      element, type));
    }
    std::array<std::uint32_t, 4> found{};
    for (int i = 0; i < count; ++i) {
      const std::int64_t tag = words_.whole("the node of an element");
      if (type != tetrahedron) continue;
      const auto place = position_.find(tag);
      if (place == position_.end())
        words_.fail(fmt::format("element {} has the node {}, which $Nodes does not list", element, tag));
      found[static_cast<std::size_t>(i)] = place->second;
    }
    if (type == tetrahedron) return found;
    ++left_out_;
    return std::nullopt;
  }

  void add(const std::array<std::uint32_t, 4>& found, std::int64_t group, std::int64_t volume, std::int64_t element) {
    if (group == 0) ++without_group_;
    builder_.add_element(found, group == 0 ? volume : group, fmt::format("element {}", element), words_.where());
  }

  void elements_2() {
    const std::size_t count = words_.count("the number of elements", most_mesh_elements, least_bytes_per_element);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t element = words_.whole("the number of an element");
      const std::int64_t type = words_.whole("the type of an element");
      const std::size_t tags = words_.count("the number of tags of an element", 1'000'000, least_bytes_per_line);
      std::int64_t group = 0, volume = 0;
      for (std::size_t t = 0; t < tags; ++t) {
        const std::int64_t tag = words_.whole("a tag of an element");
        if (t == 0) group = tag;
        if (t == 1) volume = tag;
      }
      if (const auto found = corners(type, element)) add(*found, group, volume, element);
    }
    words_.expect("$EndElements");
  }

  void elements_4() {
    const std::size_t blocks =
        words_.count("the number of blocks of elements", most_mesh_elements, least_bytes_per_line);
    const std::size_t all = words_.count("the number of elements", most_mesh_elements, 4);
    words_.whole("the smallest tag of an element");
    words_.whole("the largest tag of an element");
    std::size_t seen = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
      words_.whole("the dimension of an entity");
      const std::int64_t volume = words_.whole("the tag of an entity");
      const std::int64_t type = words_.whole("the type of elements");
      const std::size_t count = words_.count("the number of elements of a block", all, 4);
      const auto group = group_of_volume_.find(volume);
      for (std::size_t i = 0; i < count; ++i, ++seen) {
        const std::int64_t element = words_.whole("the tag of an element");
        const auto found = corners(type, element);
        if (found) add(*found, group == group_of_volume_.end() ? 0 : group->second, volume, element);
      }
    }
    if (seen != all) words_.fail(fmt::format("there are {} elements, but {} were announced", seen, all));
    words_.expect("$EndElements");
  }

  Words words_;
  const std::string& origin_;
  bool version_4_ = false;
  MeshBuilder builder_;
  std::unordered_map<std::int64_t, std::uint32_t> position_;        // of a node, by its tag
  std::unordered_map<std::int64_t, std::int64_t> group_of_volume_;  // first physical group
  std::size_t left_out_ = 0, without_group_ = 0;
};

}  // namespace

ForeignMesh parse_gmsh(std::string_view text, const std::string& origin) {
  return GmshReader(text, origin).read();
}

}  // namespace bodkin::io
