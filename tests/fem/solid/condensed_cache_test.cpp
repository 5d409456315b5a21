#include "fem/solid/condensed_cache.h"

#include <chrono>
#include <fstream>
#include <sstream>

#include "tests/fem/lattice_body.h"
#include "tests/io/scratch_folder.h"
#include "tests/sanitized.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string cache_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

void expect_same(const CondensedBody& a, const CondensedBody& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.mesh_nodes, b.mesh_nodes);
  EXPECT_EQ(a.tissues, b.tissues);
  EXPECT_EQ(a.compliance, b.compliance);
}

TEST(CondensedCache, gives_back_the_same_bits) {
  const ScratchFolder folder;
  const BodyDescription body = lattice_body(6, 50.0, 0.1, 33);
  const CondensedBody condensed = condense(body);
  const auto file = folder.path() / "cache" / "body.condensed";
  save_condensed(file, condensed, digest_of(body));
  expect_same(load_condensed(file, digest_of(body)), condensed);
}

TEST(CondensedCache, the_digest_knows_everything_that_the_compliance_depends_on) {
  const BodyDescription body = lattice_body(5, 40.0, 0.1, 12);
  const BodyDigest digest = digest_of(body);
  EXPECT_EQ(digest_of(lattice_body(5, 40.0, 0.1, 12)), digest);
  BodyDescription other = body;
  other.mesh.nodes[60].x() += 1e-9;
  EXPECT_NE(digest_of(other), digest);
  other = body;
  std::swap(other.mesh.elements[0], other.mesh.elements[1]);
  EXPECT_NE(digest_of(other), digest);
  other = body;
  other.mesh.tissues[3] = tissue::ligamentum_flavum;
  EXPECT_NE(digest_of(other), digest);
  other = body;
  other.materials.set(tissue::soft, {0.021, 0.3});
  EXPECT_NE(digest_of(other), digest);
  other = body;
  other.fixed.pop_back();
  EXPECT_NE(digest_of(other), digest);
  other = body;
  std::swap(other.corridor[0], other.corridor[1]);
  EXPECT_NE(digest_of(other), digest);
  other = body;  // what makes no difference
  other.materials.set(tissue::lung, {0.001, 0.3});
  std::reverse(other.fixed.begin(), other.fixed.end());
  other.fixed.push_back(other.fixed.front());
  EXPECT_EQ(digest_of(other), digest);
}

TEST(CondensedCache, refuses_files_that_are_damaged_or_of_something_else) {
  const ScratchFolder folder;
  const BodyDescription body = lattice_body(5, 40.0, 0.1, 12);
  const BodyDigest digest = digest_of(body);
  const auto file = folder.path() / "body.condensed";
  save_condensed(file, condense(body), digest);
  const std::string sound = cache_bytes(file);
  const auto answer = [&](const std::string& bytes) {
    folder.write("body.condensed", bytes);
    return refusal([&] { load_condensed(file, digest); });
  };
  EXPECT_THAT(refusal([&] { load_condensed(folder.path() / "none", digest); }), HasSubstr("cannot be opened"));
  EXPECT_THAT(answer(""), HasSubstr("is cut off"));
  EXPECT_THAT(answer(std::string(5000, 'x')), HasSubstr("is not a condensed body of Bodkin"));
  EXPECT_THAT(answer(sound.substr(0, 30)), HasSubstr("is cut off"));
  EXPECT_THAT(answer(sound.substr(0, sound.size() - 8)), HasSubstr("is damaged"));
  EXPECT_THAT(answer(sound + "more"), HasSubstr("is damaged"));
  std::string bytes = sound;
  bytes[8] = '\x7F';
  EXPECT_THAT(answer(bytes), HasSubstr("another version of Bodkin"));
  bytes = sound;
  bytes[32] = '\xFF';
  bytes[38] = '\xFF';  // very many nodes
  EXPECT_THAT(answer(bytes), HasSubstr("is damaged"));
  folder.write("body.condensed", sound);
  EXPECT_THAT(refusal([&] {
                load_condensed(file, {digest.high, digest.low + 1});
              }),
              AllOf(HasSubstr("belongs to another body"), HasSubstr("remove it, it is only a cache")));
  Random random(4);
  for (int round = 0; round < 200; ++round) {  // one bit
    bytes = sound;
    const auto place = static_cast<std::size_t>(random.uniform() * static_cast<double>(sound.size()));
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << (random.next() % 8)));
    EXPECT_FALSE(answer(bytes).empty()) << place;
  }
}

TEST(CondensedCache, prepares_what_the_cache_does_not_have_and_keeps_it) {
  const ScratchFolder folder;
  BodyDescription body = lattice_body(5, 40.0, 0.1, 12);
  const auto file = folder.path() / "body.condensed";
  std::vector<std::string> notes;
  int worked = 0;
  const auto get = [&] {
    notes.clear();
    worked = 0;
    return condensed_with_cache(
        file, body, {}, [&](std::string_view, double) { ++worked; },
        [&](const std::string& n) { notes.push_back(n); });
  };
  const CondensedBody first = get();
  EXPECT_GT(worked, 0);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0],
              AllOf(HasSubstr("a deformable body of 125 nodes, 12 of them in the corridor"), HasSubstr("MB")));
  expect_same(get(), first);
  EXPECT_EQ(worked, 0);
  EXPECT_TRUE(notes.empty());
  body.materials.set(tissue::soft, {0.04, 0.3});
  const CondensedBody stiffer = get();
  EXPECT_GT(worked, 0);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_THAT(notes[0], AllOf(HasSubstr("prepared again"), HasSubstr("belongs to another body")));
  expect_same(get(), stiffer);
  EXPECT_EQ(worked, 0);
  std::filesystem::resize_file(file, 100);
  expect_same(get(), stiffer);
  EXPECT_THAT(notes.at(0), HasSubstr("is damaged"));
  std::filesystem::remove(file);
  std::filesystem::create_directories(file / "in the way");
  expect_same(get(), stiffer);
  EXPECT_THAT(notes.back(), AllOf(HasSubstr("is not kept for the next time"), HasSubstr("cannot be written")));
}

TEST(CondensedCache, a_corridor_of_a_thousand_nodes_is_back_in_less_than_a_second) {
  const ScratchFolder folder;
  constexpr std::size_t nodes = sanitized ? 100 : 1000;
  CondensedBody body;
  body.nodes.resize(nodes, Vec3(1.0, 2.0, 3.0));
  body.mesh_nodes.resize(nodes, 7);
  body.tissues.resize(nodes, tissue::soft);
  Random random(8);
  const auto size = static_cast<Eigen::Index>(3 * nodes);
  body.compliance = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index j = 0; j < size; ++j)
    for (Eigen::Index i = j; i < size; ++i) body.compliance(i, j) = body.compliance(j, i) = random.uniform();
  const auto file = folder.path() / "large.condensed";
  save_condensed(file, body, {1, 2});
  double best = 1e9;
  for (int round = 0; round < 3; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const CondensedBody back = load_condensed(file, {1, 2});
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    expect_same(back, body);
  }
  EXPECT_LT(best, 1.0);
  RecordProperty("load_milliseconds", static_cast<int>(1000.0 * best));
}

}  // namespace
}  // namespace bodkin
