#include "views/language.h"

#include <QCoreApplication>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.h"
#include "imaging/ultrasound/frame.h"

namespace bodkin::views {
namespace {

namespace fs = std::filesystem;

const fs::path translations = fs::path(BODKIN_REPOSITORY) / "share" / "bodkin" / "translations";

std::string german(const Language& language, const char* context, const std::string& text) {
  return language.translate(context, text.c_str(), nullptr, -1).toStdString();
}

// The literals directly after a call, joined: tr("one "\n  "text") gives "one text".
std::set<std::string> texts_after(const std::string& source, const std::string& call) {
  static const std::string literal = R"re("(?:[^"\\]|\\.)*")re";
  const std::regex whole(call + R"(()" + literal + R"((?:\s*)" + literal + R"()*)\s*[,)])");
  const std::regex one(literal);
  std::set<std::string> texts;
  for (std::sregex_iterator at(source.begin(), source.end(), whole), end; at != end; ++at) {
    const std::string found = (*at)[1];
    std::string text;
    for (std::sregex_iterator part(found.begin(), found.end(), one); part != end; ++part) {
      const std::string quoted = part->str();
      text += quoted.substr(1, quoted.size() - 2);
    }
    text = std::regex_replace(text, std::regex(R"(\\n)"), "\n");
    texts.insert(std::regex_replace(text, std::regex(R"(\\(.))"), "$1"));
  }
  return texts;
}

TEST(Language, german_has_every_text_of_the_window) {
  const Language language(QStringLiteral("de"), translations);
  int texts = 0;
  for (const char* module : {"app", "views", "scene"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(BODKIN_REPOSITORY) / "src" / module)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::ostringstream source;
      source << std::ifstream(entry.path()).rdbuf();
      for (const char* call :
           {R"re(\btr\(\s*)re", R"re(\bBODKIN_TEXT_OF\(\s*)re", R"re(\bQT_TRANSLATE_NOOP\("[\w:]+",\s*)re",
            R"re(Application::translate\("[\w:]+",\s*)re"}) {
        for (const std::string& text : texts_after(source.str(), call)) {
          ++texts;
          EXPECT_FALSE(language.translate("any", text.c_str(), nullptr, 2).isNull())
              << entry.path().filename() << ": add \"" << text << "\" to share/bodkin/translations/window_de.ts";
        }
      }
    }
  }
  EXPECT_GT(texts, 700);
}

// The texts of a progress bar.
TEST(Language, german_has_every_stage_of_long_work) {
  const Language language(QStringLiteral("de"), translations);
  int texts = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(BODKIN_REPOSITORY) / "src")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ostringstream source;
    source << std::ifstream(entry.path()).rdbuf();
    for (const std::string& text : texts_after(source.str(), R"re(\b(?:progress|report)\(\s*)re")) {
      ++texts;
      EXPECT_FALSE(language.translate("Words", text.c_str(), nullptr, -1).isNull())
          << entry.path().filename() << ": add \"" << text << "\" to share/bodkin/translations/words_de.ts";
    }
  }
  EXPECT_GT(texts, 20);
}

TEST(Language, sentences_keep_their_numbers_and_translate_what_stands_between) {
  const Language language(QStringLiteral("de"), translations);
  EXPECT_EQ(german(language, "Words", "The tip entered a nerve root at 12.3 s, 48 mm deep: paralysis."),
            "Die Spitze drang ein: eine Nervenwurzel, nach 12.3 s, in 48 mm Tiefe. Folge: Lähmung.");
  EXPECT_EQ(german(language, "Words", "Redirections: 5; at most 2 passes. Keep an even rhythm."),
            "Richtungsänderungen: 5; bestanden bis 2. Halten Sie einen gleichmäßigen Rhythmus.");
  EXPECT_EQ(german(language, "Words", "Passed: the tip came to rest in the epidural space"),
            "Bestanden: die Spitze: zur Ruhe gekommen in: Epiduralraum");
  EXPECT_EQ(german(language, "Words", "Bone: vertebra L3"), "Knochen: Wirbel L3");
  EXPECT_EQ(german(language, "Words",
                   "Not connected: room2:18944: the connection is ended: more than 1000 messages in a second. Trying "
                   "again"),
            "Nicht verbunden: room2:18944: die Verbindung wird beendet: mehr als 1000 Nachrichten in einer Sekunde. "
            "Neuer Versuch");
}

TEST(Language, the_ultrasound_machine_speaks_it) {
  const Language language(QStringLiteral("de"), translations);
  EXPECT_EQ(german(language, "Words", "contact 87 %"), "Kontakt 87 %");
  EXPECT_EQ(german(language, "Words", "press 3.5 mm"), "eingedrückt 3.5 mm");
  EXPECT_EQ(german(language, "Words", "FROZEN"), "ANGEHALTEN");
  for (const auto why : {imaging::NoImage::outside_volume, imaging::NoImage::no_contact,
                         imaging::NoImage::inside_body, imaging::NoImage::broken_pose}) {
    const std::string text(imaging::reason(why));
    EXPECT_FALSE(language.translate("Words", text.c_str(), nullptr, -1).isNull()) << text;
  }
}

TEST(Language, a_number_sign_stands_for_numbers_alone) {
  const Language language(QStringLiteral("de"), translations);
  EXPECT_EQ(german(language, "Words", "0.1 to 1e+06 N/mm"), "0.1 bis 1e+06 N/mm");
  EXPECT_EQ(german(language, "Words", "more than 0 and at most 5 mm"), "mehr als 0 und höchstens 5 mm");
  EXPECT_EQ(german(language, "Words", "Skin: break force_N is 9 N, expected 0 to 5 N"),
            "Haut: break force_N ist 9 N, erwartet: 0 bis 5 N");
  EXPECT_TRUE(language.translate("Words", "from here to there", nullptr, -1).isNull());
}

TEST(Language, one_thing_and_many_have_forms_of_their_own) {
  const Language language(QStringLiteral("de"), translations);
  EXPECT_EQ(language.translate("View3d", "%n surface(s) saved in %1", nullptr, 1),
            QStringLiteral("%n Oberfläche in %1 gespeichert"));
  EXPECT_EQ(language.translate("View3d", "%n surface(s) saved in %1", nullptr, 7),
            QStringLiteral("%n Oberflächen in %1 gespeichert"));
}

TEST(Language, every_place_of_a_text_is_in_its_translation) {
  for (const char* name : {"window_de.ts", "words_de.ts"}) {
    std::ostringstream file;
    file << std::ifstream(translations / name).rdbuf();
    const std::string text = file.str();
    const std::regex message(R"(<source>([^<]*)</source>\s*<translation>([^<]*)</translation>)");
    int messages = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), message), end; at != end; ++at, ++messages) {
      for (const char sign : {'%', '#'}) {
        for (int place = 1; place <= 9; ++place) {
          const std::string mark = sign + std::to_string(place);
          EXPECT_EQ((*at)[1].str().find(mark) != std::string::npos, (*at)[2].str().find(mark) != std::string::npos)
              << name << ": " << at->str();
        }
      }
    }
    EXPECT_GT(messages, 300);
  }
}

TEST(Language, what_the_dictionary_lacks_stays_as_it_is) {
  const Language language(QStringLiteral("de"), translations);
  EXPECT_TRUE(language.translate("Words", "patient/ct.nii.gz cannot be read", nullptr, -1).isNull());
  EXPECT_EQ(in_words("no translator is installed here"), QStringLiteral("no translator is installed here"));
}

TEST(Language, only_languages_with_both_files_are_offered) {
  EXPECT_EQ(languages_in(translations), (QStringList{QStringLiteral("en"), QStringLiteral("de")}));
  EXPECT_EQ(languages_in("/nowhere"), QStringList(QStringLiteral("en")));
}

TEST(Language, a_broken_file_is_told_with_its_line) {
  const fs::path folder = fs::temp_directory_path() / ("bodkin-language-" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "window_xx.ts") << "<TS>\n<context>\n<name>A</name>\n<message>\n";
  std::ofstream(folder / "words_xx.ts") << "<TS></TS>\n";
  try {
    const Language language(QStringLiteral("xx"), folder);
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("window_xx.ts, line "));
  }
  std::ofstream(folder / "window_xx.ts") << "<html></html>\n";
  EXPECT_THROW(Language(QStringLiteral("xx"), folder), InputError);
  EXPECT_THROW(Language(QStringLiteral("yy"), folder), InputError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace bodkin::views
