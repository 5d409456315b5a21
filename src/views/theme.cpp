#include "views/theme.h"

#include <QFontDatabase>
#include <QRgb>
#include <array>
#include <string>

#include "core/error.h"
#include "io/resources.h"

namespace bodkin::views {

namespace {

bool dark_now = true;

// By TissueId, 0 to 22.
constexpr std::array<QRgb, anatomy::tissue::count> own_colours = {
    0x000000, 0xE0C3B8, 0xFFFFB3, 0xA64E56, 0xC09696, 0xF9FCFF, 0x9F9276, 0x6EBEC7,
    0x399283, 0x7BCDB2, 0xD09500, 0xDBC2B2, 0x9D4FC6, 0x56B4E9, 0xEDEF34, 0xD80F16,
    0x704E69, 0xC09696, 0x000000, 0xE9EDF2, 0xCC79A7, 0xB6D9E0, 0xFF2BD6};

QString family() {
  static const QString chosen = [] {
    const QStringList families = QFontDatabase().families();
    for (const char* name : {"Roboto", "DejaVu Sans"}) {
      if (families.contains(QLatin1String(name))) return QString::fromLatin1(name);
    }
    return QFont().family();
  }();
  return chosen;
}

// A style sheet's reference to an icon of share/bodkin/app that is legible on dark and light.
QString picture(const char* name) {
  try {
    return QStringLiteral("url(\"%1\")")
        .arg(QString::fromStdString(io::shared_file("app/" + std::string(name) + ".png").string()));
  } catch (const SystemError&) {
    return QStringLiteral("none");
  }
}

}  // namespace

const Theme& Theme::dark() {
  static const Theme theme{QColor(0x0E, 0x11, 0x16), QColor(0x16, 0x1B, 0x22), QColor(0x1F, 0x26, 0x30),
                           QColor(0x2C, 0x35, 0x41), QColor(0xE9, 0xEE, 0xF4), QColor(0x98, 0xA4, 0xB3),
                           QColor(0x4D, 0xA3, 0xFF), QColor(0x2E, 0xE6, 0xC5), QColor(0xFF, 0xB0, 0x2E),
                           QColor(0xFF, 0x5A, 0x52), QColor(0x35, 0xC9, 0x8B), true};
  return theme;
}

const Theme& Theme::light() {
  static const Theme theme{QColor(0xF7, 0xF8, 0xFA), QColor(0xFF, 0xFF, 0xFF), QColor(0xEE, 0xF1, 0xF5),
                           QColor(0xD3, 0xDA, 0xE3), QColor(0x1B, 0x22, 0x2B), QColor(0x56, 0x62, 0x72),
                           QColor(0x0B, 0x63, 0xC5), QColor(0x00, 0x79, 0x6B), QColor(0x8A, 0x5A, 0x00),
                           QColor(0xC6, 0x28, 0x28), QColor(0x1B, 0x7F, 0x4D), false};
  return theme;
}

const Theme& Theme::now() {
  return dark_now ? dark() : light();
}

void Theme::use(bool dark) {
  dark_now = dark;
}

QString Theme::style_sheet() const {
  const QString on_accent = is_dark ? QStringLiteral("#08111C") : QStringLiteral("#FFFFFF");
  return QStringLiteral(R"(
* { font-family: "%1"; font-size: 13px; color: %2; }
QWidget { background: transparent; }
QMainWindow, #ground { background: %3; }
#panel { background: %4; }
#line { background: %5; }
QLabel[role="label"] { font-size: 11px; color: %6; }
QLabel[role="second"] { color: %6; }
QLabel[role="heading"] { font-size: 15px; font-weight: 500; }
QLabel[role="danger"] { font-size: 15px; font-weight: 500; color: %11; }
QLabel[role="title"] { font-size: 30px; font-weight: 500; }
QPushButton { background: %7; border: 1px solid %5; border-radius: 6px; padding: 6px 12px; }
QPushButton:hover { border-color: %8; }
QPushButton:focus { border-color: %8; }
QPushButton:disabled { color: %6; }
QPushButton:checked { background: %9; border-color: %8; }
QPushButton[role="primary"] { background: %8; border-color: %8; color: %10; font-weight: 500; }
QPushButton[role="flat"] { background: transparent; border-color: transparent; }
QPushButton[role="flat"]:hover { background: %7; }
QPushButton[role="flat"]:checked { background: %9; border-color: %8; }
QPushButton[role="drop"] { background: transparent; border: 1px dashed %8; }
#hero, #card { background: %4; border: 1px solid %5; border-radius: 10px; }
QToolTip { background: %7; border: 1px solid %5; color: %2; }
QProgressBar { background: %7; border: none; border-radius: 3px; height: 6px; }
QProgressBar::chunk { background: %8; border-radius: 3px; }
QScrollArea { border: none; }
QScrollBar:vertical { background: %4; width: 10px; }
QScrollBar::handle:vertical { background: %5; border-radius: 5px; min-height: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
QSplitter::handle { background: %3; }
QLineEdit { background: %7; border: 1px solid %5; border-radius: 6px; padding: 6px; }
QTreeWidget { selection-background-color: %9; }
QHeaderView::section { background: %7; color: %6; border: none; padding: 3px 4px; }
QListWidget::item { padding: 5px 8px; border-radius: 6px; }
QListWidget::item:selected, QTreeWidget::item:selected { background: %9; color: %2; }
QComboBox, QDoubleSpinBox, QSpinBox { background: %7; border: 1px solid %5; border-radius: 6px; padding: 5px 8px; }
QComboBox::drop-down { border: none; width: 24px; }
QComboBox::down-arrow, QSpinBox::down-arrow, QDoubleSpinBox::down-arrow { image: %13; width: 9px; height: 6px; }
QSpinBox::up-arrow, QDoubleSpinBox::up-arrow { image: %12; width: 9px; height: 6px; }
QDoubleSpinBox::up-button, QDoubleSpinBox::down-button, QSpinBox::up-button, QSpinBox::down-button {
  width: 20px; border: none; background: transparent; }
QComboBox QAbstractItemView { background: %7; selection-background-color: %9; }
QCheckBox::indicator:unchecked { width: 12px; height: 12px; border: 1px solid %6; border-radius: 3px; }
QCheckBox::indicator:checked { width: 12px; height: 12px; border: 1px solid %8; border-radius: 3px;
  background: %8; image: %14; }
QSlider::groove:horizontal { background: %5; height: 6px; border-radius: 3px; }
QSlider::sub-page:horizontal { background: %8; border-radius: 3px; }
QSlider::handle:horizontal { background: %2; width: 16px; margin: -5px 0; border-radius: 8px; }
QMenu { background: %7; border: 1px solid %5; }
QMenu::item { padding: 5px 18px; }
QMenu::item:selected { background: %9; }
)")
      .arg(family(), text.name(), ground.name(), panel.name(), line.name(), second.name(), raised.name(),
           accent.name(), is_dark ? QStringLiteral("#1B3350") : QStringLiteral("#D6E6F8"))
      .arg(on_accent, danger.name(), picture("arrow_up"), picture("arrow_down"), picture("tick"));
}

QFont font(int pixels, bool strong) {
  QFont chosen(family());
  chosen.setPixelSize(std::max(pixels, label_size));
  chosen.setWeight(strong ? QFont::Medium : QFont::Normal);
  return chosen;
}

QColor tissue_colour(anatomy::TissueId id, const anatomy::TissueLibrary& library) {
  if (id < own_colours.size()) return QColor(own_colours[id]);
  const anatomy::TissueProperties* tissue = library.find(id);
  return tissue == nullptr ? QColor(0x80, 0x80, 0x80) : QColor(static_cast<QRgb>(tissue->colour));
}

}  // namespace bodkin::views
