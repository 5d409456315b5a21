#include "report/document_pdf.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "io/run_program.h"

namespace bodkin::report {
namespace {

// The output of pdftotext for the file, its pages divided by form feeds.
std::string text_in(const std::string& pdf) {
  const io::ProgramResult read = io::run_program({"pdftotext", "-layout", "-", "-"}, pdf, "poppler-utils");
  EXPECT_EQ(read.exit_code, 0) << read.errors;
  return read.output;
}

std::vector<std::string> pages_in(const std::string& pdf) {
  std::istringstream text(text_in(pdf));
  std::vector<std::string> pages;
  for (std::string page; std::getline(text, page, '\f');) pages.push_back(page);
  return pages;
}

Document long_document() {
  Document document{"Lumbar puncture, Anna's back", "operator expert", {}};
  document.blocks.emplace_back(Verdict{training::Grade::dangerous,
                                       "Dangerous: the tip entered a nerve root",
                                       {{"At 51 mm, after 12 s.", training::Grade::dangerous}}});
  Table table{{{"event"}, {"time, s", true}}, {}, false};
  for (int i = 0; i < 200; ++i)
    table.rows.push_back({{"event number " + std::to_string(i)}, {std::to_string(i) + ".5"}});
  document.blocks.emplace_back(Heading{"Events"});
  document.blocks.emplace_back(table);
  return document;
}

TEST(DocumentPdf, says_every_text_on_numbered_pages_with_repeated_heads) {
  const std::vector<std::string> pages = pages_in(pdf_of(long_document()));
  ASSERT_GT(pages.size(), 3U);
  std::string all;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    EXPECT_NE(pages[i].find("page " + std::to_string(i + 1) + " of " + std::to_string(pages.size())),
              std::string::npos)
        << i;
    EXPECT_NE(pages[i].find("time, s"), std::string::npos) << "no head of the table on page " << i + 1;
    all += pages[i];
  }
  for (int i = 0; i < 200; ++i) EXPECT_NE(all.find("event number " + std::to_string(i)), std::string::npos) << i;
  for (const char* text : {"Lumbar puncture, Anna's back", "Dangerous: the tip entered", "At 51 mm, after 12 s."})
    EXPECT_NE(pages.front().find(text), std::string::npos) << text;
}

TEST(DocumentPdf, is_the_same_bytes_every_time) {
  EXPECT_TRUE(pdf_of(long_document()) == pdf_of(long_document()));
}

TEST(DocumentPdf, divides_words_wider_than_the_page_and_loses_no_character) {
  Document document{"Title", "", {}};
  std::string word;
  for (int i = 0; i < 120; ++i) word += "\u00e4" + std::to_string(100 + i);
  document.blocks.emplace_back(Facts{{{"case", word}}});
  std::string text = text_in(pdf_of(document));
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }), text.end());
  EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(DocumentPdf, a_heading_stays_with_its_figure) {
  Document document{"Figures", "", {}};
  document.blocks.emplace_back(Picture{imaging::Canvas(400.0, 380.0), "", false});
  document.blocks.emplace_back(Picture{imaging::Canvas(400.0, 150.0), "", false});
  document.blocks.emplace_back(Heading{"What the needle felt"});
  document.blocks.emplace_back(Picture{imaging::Canvas(400.0, 300.0), "", false});
  const std::vector<std::string> pages = pages_in(pdf_of(document));
  ASSERT_EQ(pages.size(), 2U);
  EXPECT_NE(pages[1].find("What the needle felt"), std::string::npos);
}

TEST(DocumentPdf, what_is_no_utf8_and_what_is_empty_can_be_written) {
  Document document{"\xff\xfe", "", {}};
  document.blocks.emplace_back(Table{{{"a"}}, {}, true});
  document.blocks.emplace_back(Tiles{});
  document.blocks.emplace_back(Verdict{});
  EXPECT_EQ(pages_in(pdf_of(document)).size(), 1U);
}

TEST(DocumentPdf, a_figure_goes_to_the_next_page_rather_than_over_the_end) {
  Document document{"Figures", "", {}};
  for (int i = 0; i < 5; ++i) {
    imaging::Canvas picture(400.0, 300.0);
    picture.text({20.0, 40.0}, "figure " + std::to_string(i), {});
    document.blocks.emplace_back(Picture{picture, "", false});
  }
  const std::vector<std::string> pages = pages_in(pdf_of(document));
  EXPECT_EQ(pages.size(), 3U);
  EXPECT_NE(pages[0].find("figure 1"), std::string::npos);
  EXPECT_EQ(pages[0].find("figure 2"), std::string::npos);
  EXPECT_NE(pages[2].find("figure 4"), std::string::npos);
}

}  // namespace
}  // namespace bodkin::report
