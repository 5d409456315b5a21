#include "io/case_folder.h"

#include <cstdlib>

#include "tests/io/case_documents.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/resources.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(CaseFolder, what_is_written_is_read) {
  const ScratchFolder folder;
  const CaseDescription description = parse(largest);
  write_case_description(description, folder.path());
  EXPECT_EQ(case_xml(read_case_description(folder.path())), case_xml(description));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1)
      << "nothing but case.xml is left";
}

TEST(CaseFolder, what_would_not_be_read_is_not_written_and_the_old_file_stays) {
  const ScratchFolder folder;
  CaseDescription description = parse(largest);
  write_case_description(description, folder.path());
  description.procedure.path->target = description.procedure.path->entry;
  EXPECT_THAT(refusal([&] { write_case_description(description, folder.path()); }), HasSubstr("from the entry"));
  description.procedure.path->target.x() = std::nan("");
  EXPECT_THAT(refusal([&] { write_case_description(description, folder.path()); }),
              HasSubstr("target x_mm is 'nan', expected a number"));
  EXPECT_EQ(read_case_description(folder.path()).procedure.path->target, Vec3(3.0, -117.5, 294.0));
  EXPECT_THROW(write_case_description(parse(largest), folder.path() / "missing"), SystemError);
}

TEST(CaseFolder, a_written_case_validates_for_xmllint_too) {
  if (std::system("command -v xmllint >/dev/null") != 0)
    GTEST_SKIP() << "xmllint is not installed (Debian package libxml2-utils)";
  const ScratchFolder folder;
  write_case_description(parse(largest), folder.path());
  const std::string command = "xmllint --noout --schema '" + shared_file("case.xsd").string() + "' '" +
                              (folder.path() / "case.xml").string() + "' 2>/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(CaseFolder, the_example_of_the_documentation_is_a_case) {
  const std::string page = read_text_file(BODKIN_REPOSITORY "/docs/case-format.md", 1 << 20);
  const auto start = page.find("```xml\n") + 7;
  const CaseDescription description = parse(page.substr(start, page.find("```", start) - start));
  EXPECT_EQ(description.name, "Lumbar puncture, L3/L4");
  EXPECT_EQ(description.structures.size(), 3U);
}

TEST(CaseFolder, the_documentation_names_every_element_and_attribute_of_the_schemas) {
  const std::string page = read_text_file(BODKIN_REPOSITORY "/docs/case-format.md", 1 << 20);
  for (const char* schema : {"case.xsd", "tissues.xsd"}) {
    const std::string text = read_text_file(shared_file(schema), 1 << 20);
    for (const std::string kind : {"<xs:element name=\"", "<xs:attribute name=\""}) {
      for (auto at = text.find(kind); at != std::string::npos; at = text.find(kind, at + 1)) {
        const auto start = at + kind.size();
        const std::string name = text.substr(start, text.find('"', start) - start);
        EXPECT_THAT(page, HasSubstr("`" + name)) << schema;
      }
    }
  }
}

TEST(CaseFolder, messages_name_the_file) {
  const ScratchFolder folder;
  EXPECT_THAT(refusal([&] { read_case_description(folder.path() / "none"); }),
              HasSubstr("none: there is no such case folder"));
  EXPECT_EQ(refusal([&] { read_case_description(folder.path()); }),
            (folder.path() / "case.xml").string() + ": there is no such file");
  folder.write("case.xml", replaced(smallest, "22", "many"));
  EXPECT_THAT(refusal([&] { read_case_description(folder.path()); }),
              ::testing::StartsWith((folder.path() / "case.xml").string() + ", line 6: needle gauge is 'many'"));
  folder.write("case.xml", smallest + std::string(17 << 20, ' '));
  EXPECT_THAT(refusal([&] { read_case_description(folder.path()); }), HasSubstr("larger than the 16384 kB"));
}

TEST(CaseFolder, a_case_may_bring_a_tissue_library_of_its_own) {
  const ScratchFolder folder;
  std::string library = read_text_file(shared_file("tissues.xml"), 1 << 20);
  library = replaced(library, "id=\"20\" name=\"mass\"", "id=\"40\" name=\"tumour\"");
  folder.write("mine/tissues.xml", library);
  folder.write("case.xml",
               replaced(smallest, "  <needle",
                        "  <tissue_library file='mine/tissues.xml'/><procedure target_tissue='tumour'/><needle"));
  const CaseDescription description = read_case_description(folder.path());
  EXPECT_EQ(description.procedure.target_tissue, "tumour");
  EXPECT_EQ(read_case_library(folder.path(), description).find("tumour")->id, 40);
  folder.write("mine/tissues.xml", replaced(library, "tumour", "lump"));
  EXPECT_THAT(refusal([&] { read_case_description(folder.path()); }),
              HasSubstr("target_tissue is 'tumour', which the tissue library does not have"));
  fs::remove(folder.path() / "mine/tissues.xml");
  EXPECT_THAT(refusal([&] { read_case_description(folder.path()); }),
              HasSubstr("tissue_library file is 'mine/tissues.xml', but"));
}

TEST(CaseFolder, files_are_looked_for_inside_the_folder_only) {
  const ScratchFolder folder;
  folder.write("outside.nrrd", "x");
  folder.write("case/inside.nrrd", "x");
  folder.write("case/deeper/inside.nrrd", "x");
  const fs::path inside = folder.path() / "case";
  fs::create_symlink("../outside.nrrd", inside / "link.nrrd");
  fs::create_symlink("deeper/inside.nrrd", inside / "good_link.nrrd");
  fs::create_directory_symlink("..", inside / "up");
  EXPECT_EQ(file_inside(inside, "deeper/inside.nrrd", "ct"), inside / "deeper/inside.nrrd");
  EXPECT_EQ(file_inside(inside, "good_link.nrrd", "ct"), inside / "good_link.nrrd");
  EXPECT_THAT(refusal([&] { file_inside(inside, "link.nrrd", "ct"); }),
              HasSubstr("a link that leads out of the case folder"));
  EXPECT_THAT(refusal([&] { file_inside(inside, "up/outside.nrrd", "ct"); }),
              HasSubstr("a link that leads out of the case folder"));
  EXPECT_THAT(refusal([&] { file_inside(inside, "none.nrrd", "ct"); }), HasSubstr("does not exist"));
  EXPECT_THAT(refusal([&] { file_inside(inside, "deeper", "ct"); }), HasSubstr("which is not a file"));
  for (const char* name : {"", "..", "../outside.nrrd", "deeper/../../outside.nrrd", "/etc/passwd", ".",
                           "./inside.nrrd", "deeper/", "a\\b"}) {
    EXPECT_FALSE(is_inside_name(name)) << name;
  }
  EXPECT_FALSE(is_inside_name(std::string("a\0b", 3)));
}

// Sets an environment variable for one test.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~Environment() { unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
};

TEST(SharedFiles, bodkin_share_comes_first_and_what_is_nowhere_is_said_so) {
  const ScratchFolder folder;
  const auto mine = folder.write("tissues.xml", "mine");
  const Environment share("BODKIN_SHARE", folder.path().string());
  EXPECT_EQ(shared_file("tissues.xml"), mine);
  EXPECT_NE(shared_file("case.xsd").parent_path(), folder.path()) << "falls back where the folder lacks a file";
  EXPECT_THROW(shared_file("no_such_file"), SystemError);
}

}  // namespace
}  // namespace bodkin
