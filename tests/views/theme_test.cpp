#include "views/theme.h"

#include <QFileInfo>
#include <QImage>
#include <QRegularExpression>
#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

TEST(Theme, arrows_and_ticks_of_its_style_sheet_are_there_and_are_seen_on_dark_and_light) {
  for (const Theme* const theme : {&Theme::dark(), &Theme::light()}) {
    const QString sheet = theme->style_sheet();
    EXPECT_FALSE(sheet.contains(QLatin1Char('%'))) << "a place without its value";
    QRegularExpressionMatchIterator found =
        QRegularExpression(QStringLiteral("url\\(\"([^\"]+)\"\\)")).globalMatch(sheet);
    int count = 0;
    while (found.hasNext()) {
      const QString file = found.next().captured(1);
      const QImage picture(file);
      ASSERT_FALSE(picture.isNull()) << file.toStdString();
      EXPECT_TRUE(QFileInfo::exists(QString(file).replace(QStringLiteral(".png"), QStringLiteral("@2x.png"))));
      // Some pixel differs from its background: fields for arrows, the accent for the tick.
      const QColor under = file.contains(QStringLiteral("tick")) ? theme->accent : theme->raised;
      int most = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          const QColor here = picture.pixelColor(x, y);
          if (here.alpha() > 200) most = std::max(most, std::abs(here.green() - under.green()));
        }
      }
      EXPECT_GT(most, 60) << file.toStdString();
      ++count;
    }
    EXPECT_EQ(count, 3);
  }
}

}  // namespace
}  // namespace bodkin::views
