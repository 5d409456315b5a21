// bodkin-mesher: the meshing worker (see io/mesh/mesher.h). It reads one JSON object from standard input and labels
// and edge lengths from file descriptor 3, writes the mesh back there, and writes one JSON object per line on
// standard output: {"progress", "fraction"}, {"error", "kind"}, {"result"}. Bodkin starts it; it is not for users.

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <new>
#include <string>
#include <string_view>

#include "programs/mesher/label_mesher.h"
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"

namespace bodkin::programs {
namespace {

using nlohmann::json;

constexpr int shared_descriptor = 3;

constexpr const char* about = R"(bodkin-mesher fills the labels of an image with tetrahedra. It is started by bodkin;
run 'bodkin case mesh --help'.

Licence: this program contains Mesh_3 and the triangulations of CGAL, which are under the GNU General Public License,
version 3 or later, and so this program as a whole is. The bodkin command and the haptic core, which only run it, stay
under the Apache License 2.0. https://www.cgal.org, https://www.gnu.org/licenses/gpl-3.0.html
)";

void send_message(const json& message) {
  std::cout << message.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
}

void read_all(void* target, std::size_t bytes) {
  auto* place = static_cast<char*>(target);
  while (bytes > 0) {
    const ssize_t count = read(shared_descriptor, place, bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw SystemError("the labels to mesh were not handed over whole");
    place += count;
    bytes -= static_cast<std::size_t>(count);
  }
}

template <typename Value>
void write_all(const std::vector<Value>& values) {
  const auto* place = reinterpret_cast<const char*>(values.data());
  std::size_t bytes = values.size() * sizeof(Value);
  while (bytes > 0) {
    const ssize_t count = write(shared_descriptor, place, bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw SystemError("the mesh cannot be handed over: no memory");
    place += count;
    bytes -= static_cast<std::size_t>(count);
  }
}

int run() {
  const json request = json::parse(std::string{std::istreambuf_iterator<char>(std::cin), {}});
  LabelLattice lattice{
      request.at("size").get<std::array<int, 3>>(), request.at("spacing").get<std::array<double, 3>>(), {}, {}};
  LabelMeshing meshing;
  meshing.fewest = request.at("fewest").get<std::size_t>();
  meshing.most = request.at("most").get<std::size_t>();
  meshing.expected = request.at("expected").get<std::size_t>();
  std::size_t voxels = 1;
  for (const int count : lattice.size) voxels *= static_cast<std::size_t>(count);
  lattice.labels.resize(voxels);
  lattice.edges.resize(voxels);
  if (lseek(shared_descriptor, 0, SEEK_SET) != 0) throw SystemError("no labels to mesh were handed over");
  read_all(lattice.labels.data(), voxels);
  read_all(lattice.edges.data(), voxels * sizeof(float));

  const LabelMesh mesh = mesh_labels(lattice, meshing, [](const char* stage, double fraction) {
    send_message({{"progress", stage}, {"fraction", fraction}});
  });
  if (ftruncate(shared_descriptor, 0) != 0 || lseek(shared_descriptor, 0, SEEK_SET) != 0) {
    throw SystemError("the mesh cannot be handed over");
  }
  write_all(mesh.nodes);
  write_all(mesh.elements);
  write_all(mesh.labels);
  send_message(
      {{"result",
        {{"nodes", mesh.nodes.size()}, {"elements", mesh.elements.size()}, {"refined_nodes", mesh.node_count}}}});
  return 0;
}

int fail(const std::string& sentence, const char* kind, int exit_code) {
  send_message({{"error", sentence}, {"kind", kind}});
  return exit_code;
}

}  // namespace
}  // namespace bodkin::programs

int main(int argc, char** argv) {
  if (argc != 2 || std::string_view(argv[1]) != "mesh") {
    std::fputs(bodkin::programs::about, argc == 2 && std::string_view(argv[1]) == "--help" ? stdout : stderr);
    return argc == 2 && std::string_view(argv[1]) == "--help" ? 0 : 1;
  }
  try {
    return bodkin::programs::run();
  } catch (const std::bad_alloc&) {
    return bodkin::programs::fail("out of memory", "memory", 2);
  } catch (const std::exception& error) {
    return bodkin::programs::fail(error.what(), "system", 1);
  }
}
