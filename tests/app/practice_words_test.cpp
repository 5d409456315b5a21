#include <string>

#include "app/models/data_folder.h"
#include "app/practice.h"
#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

TEST(PracticeWords, a_sentence_is_read_for_its_time_however_long_the_frame_before_it_took) {
  Practice practice(data_folder());
  practice.advance(1.0);
  practice.show_message("Saved as picture.png");
  EXPECT_EQ(practice.advance(61.0).hint, "Saved as picture.png");  // a minute for the picture
  EXPECT_EQ(practice.advance(64.9).hint, "Saved as picture.png");
  EXPECT_NE(practice.advance(65.1).hint, "Saved as picture.png") << "four seconds are enough";
}

TEST(PracticeWords, a_longer_sentence_is_shown_for_longer) {
  Practice practice(data_folder());
  const std::string sentence(200, 'x');
  practice.show_message(sentence);
  EXPECT_EQ(practice.advance(1.0).hint, sentence);
  EXPECT_EQ(practice.advance(12.9).hint, sentence);
  EXPECT_NE(practice.advance(13.1).hint, sentence);
}

}  // namespace
}  // namespace bodkin::app
