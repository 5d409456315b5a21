#include "fem/solid/factor_cache.h"

#include <cstring>
#include <fstream>
#include <sstream>

#include "tests/fem/lattice_body.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::shared_ptr<const BodyDescription> small_body(double modulus = 0.02) {
  BodyDescription body = lattice_body(6, 50.0, 0.1, 12);
  body.materials.set(tissue::soft, {modulus, 0.3});
  return std::make_shared<const BodyDescription>(std::move(body));
}

std::string whole_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

// The contents of a needle's line through the body, to the last bit.
Eigen::MatrixXd compliance_in(const ContactBody& body) {
  std::vector<ContactSite> sites;
  for (int depth = 0; depth < 30; ++depth)
    sites.push_back({Vec3(24.0, 26.0, 50.0 - depth), 1.0 * depth, tissue::soft, depth == 0, depth == 0});
  return body.contact_points(sites, -Vec3::UnitZ(), 0.35).compliance;
}

TEST(FactorCache, gives_back_the_same_bits) {
  const ScratchFolder folder;
  const auto file = folder.path() / "cache" / "body.factor";
  const auto description = small_body();
  const ContactBody body(description);
  const BodyDigest digest = digest_of(*description);
  save_factor(file, body.factor(), digest);
  const ContactBody again(description, load_factor(file, digest));
  const std::span<const double> one = body.factor().numbers(), other = again.factor().numbers();
  ASSERT_EQ(one.size(), other.size());
  EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size_bytes()), 0);
  EXPECT_EQ(again.factor().bytes(), body.factor().bytes());
  EXPECT_EQ(compliance_in(again), compliance_in(body));
  const std::vector<std::uint32_t> nodes = {0, 7, 100, 215};
  const std::vector<CarriedPoint> points = {body.carried({.nodes = {150, 151, 152, 160}, .weights = {1, 0, 0, 0}})};
  EXPECT_EQ(again.displacements(points, nodes), body.displacements(points, nodes));
}

TEST(FactorCache, refuses_files_that_are_damaged_or_of_something_else) {
  const ScratchFolder folder;
  const auto file = folder.path() / "body.factor";
  const auto description = small_body();
  const BodyDigest digest = digest_of(*description);
  save_factor(file, ContactBody(description).factor(), digest);
  const std::string sound = whole_file(file);
  const auto answer = [&](const std::string& bytes) {
    folder.write("body.factor", bytes);
    return refusal([&] { load_factor(file, digest); });
  };
  EXPECT_THAT(refusal([&] { load_factor(folder.path() / "none", digest); }), HasSubstr("cannot be opened"));
  EXPECT_THAT(answer(""), HasSubstr("is cut off"));
  EXPECT_THAT(answer(std::string(5000, 'x')), HasSubstr("is not a factor of Bodkin"));
  EXPECT_THAT(answer(sound.substr(0, 30)), HasSubstr("is cut off"));
  EXPECT_THAT(answer(sound.substr(0, 90)), HasSubstr("is damaged"));
  EXPECT_THAT(answer(sound.substr(0, sound.size() - 8)), HasSubstr("is damaged"));
  EXPECT_THAT(answer(sound + "more"), HasSubstr("is damaged"));
  std::string bytes = sound;
  bytes[8] = '\x7F';
  EXPECT_THAT(answer(bytes), HasSubstr("another version of Bodkin"));
  for (const std::size_t count : {32U, 40U, 48U, 56U}) {  // of nodes, supernodes, rows and numbers: very many
    bytes = sound;
    std::memset(bytes.data() + count, 0xFF, 8);
    EXPECT_THAT(answer(bytes), HasSubstr("is damaged")) << count;
  }
  folder.write("body.factor", sound);
  EXPECT_THAT(refusal([&] {
                load_factor(file, {digest.high, digest.low + 1});
              }),
              AllOf(HasSubstr("belongs to another body"), HasSubstr("remove it, it is only a cache")));
  EXPECT_THAT(refusal([&] {
                BodyDescription larger = lattice_body(7, 50.0, 0.1, 0);
                ContactBody(std::make_shared<const BodyDescription>(std::move(larger)), load_factor(file, digest));
              }),
              HasSubstr("180 nodes and edges that can move, but the body has 294 of them"));
  Random random(4);
  for (int round = 0; round < 200; ++round) {  // one bit
    bytes = sound;
    const auto place = static_cast<std::size_t>(random.uniform() * static_cast<double>(sound.size()));
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << (random.next() % 8)));
    EXPECT_FALSE(answer(bytes).empty()) << place;
  }
}

TEST(FactorCache, prepares_what_the_cache_does_not_have_and_keeps_it) {
  const ScratchFolder folder;
  const auto file = folder.path() / "body.factor";
  std::vector<std::string> notes;
  int worked = 0;
  const auto get = [&](const std::shared_ptr<const BodyDescription>& description) {
    notes.clear();
    worked = 0;
    return contact_body_with_cache(
        file, description, [&](std::string_view, double) { ++worked; },
        [&](const std::string& note) { notes.push_back(note); });
  };
  const Eigen::MatrixXd first = compliance_in(*get(small_body()));
  EXPECT_GT(worked, 0);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(compliance_in(*get(small_body())), first);
  EXPECT_EQ(worked, 0);
  EXPECT_TRUE(notes.empty());

  const auto kept = get(small_body());  // and stays in use while the file is replaced by that of a stiffer body
  const Eigen::MatrixXd stiffer = compliance_in(*get(small_body(0.04)));
  EXPECT_GT(worked, 0);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], AllOf(HasSubstr("prepared again"), HasSubstr("belongs to another body")));
  EXPECT_EQ(compliance_in(*get(small_body(0.04))), stiffer);
  EXPECT_EQ(worked, 0);
  EXPECT_EQ(compliance_in(*kept), first);

  folder.write("file", "");
  notes.clear();
  contact_body_with_cache(folder.path() / "file" / "below", small_body(), {},
                          [&](const std::string& note) { notes.push_back(note); });
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], AllOf(HasSubstr("is not kept for the next time"), HasSubstr("cannot be written")));
  EXPECT_EQ(compliance_in(*contact_body_with_cache({}, small_body())), first);
}

}  // namespace
}  // namespace bodkin
