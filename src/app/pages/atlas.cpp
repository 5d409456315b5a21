#include "app/pages/atlas.h"

#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <random>
#include <utility>

#include "patient/acupuncture/collaterals.h"
#include "views/atlas_view.h"
#include "views/language.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int side_width = 316;
constexpr double farthest_needled = 60.0;  // mm off the point: within the block about it
constexpr double longest_touch = 3600.0;   // s for which the device is read
constexpr double usual_reach = 100.0;      // mm, of a device that does not say how high its workspace is

QString text(const std::string& words) {
  return QString::fromStdString(words);
}

// The Chinese name, where a font for it is installed.
QString characters(const patient::AtlasPoint& point) {
  static const bool can = !QFontDatabase().families(QFontDatabase::TraditionalChinese).isEmpty();
  return can ? text(point.hanzi) : QString();
}

QPushButton* button(const QString& words, const char* object, const QString& tip, QVBoxLayout& rows) {
  auto* made = new QPushButton(words);
  made->setObjectName(QLatin1String(object));
  made->setAccessibleName(words);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::NoFocus);
  rows.addWidget(made);
  return made;
}

}  // namespace

AtlasPage::AtlasPage(const std::filesystem::path& folder, QWidget* parent)
    : Page(PageId::atlas, KeyScope::atlas, false, parent),
      model_(folder),
      quiz_(std::random_device()()),
      view_(new AtlasView) {
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(0);
  columns->addWidget(view_, 1);
  columns->addWidget(make_side());
  connect(view_, &AtlasView::clicked, this, &AtlasPage::take);
  choose(nullptr, false);
}

QWidget* AtlasPage::make_side() {
  auto* side = new QWidget;
  side->setObjectName(QStringLiteral("panel"));
  side->setAttribute(Qt::WA_StyledBackground);
  side->setFixedWidth(side_width);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(14, 14, 14, 14);
  rows->setSpacing(8);
  search_ = new QLineEdit;
  search_->setObjectName(QStringLiteral("atlas.search"));
  search_->setPlaceholderText(tr("Code, name or meridian"));
  search_->setAccessibleName(tr("Search"));
  search_->setClearButtonEnabled(true);
  rows->addWidget(search_);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("atlas.list"));
  list_->setAccessibleName(tr("Points"));
  rows->addWidget(list_, 3);
  card_ = new QLabel;
  card_->setObjectName(QStringLiteral("atlas.card"));
  card_->setWordWrap(true);
  card_->setAlignment(Qt::AlignTop);
  card_->setTextFormat(Qt::RichText);
  rows->addWidget(card_, 4);
  needle_ =
      button(tr("Practise this point"), "atlas.practise", tr("Needle it in a block of the body around it"), *rows);
  needle_->setProperty("role", QStringLiteral("primary"));
  find_ = button(tr("Find points"), "atlas.find", tr("Show on the body where a named point is (N)"), *rows);
  both_ = button(tr("And needle it"), "atlas.both",
                 tr("Where you show the point, the needle goes in; the true point is shown afterwards"), *rows);
  both_->setCheckable(true);
  touch_ = button(tr("Touch with the needle"), "atlas.touch",
                  tr("The needle of your device shows points on the body, without force (T)"), *rows);
  touch_->setCheckable(true);
  again_ = button(tr("The same again"), "atlas.again", tr("Show the same point once more (A)"), *rows);
  stop_ = button(tr("Back to the atlas"), "atlas.stop", tr("Stop finding points (Esc)"), *rows);
  score_ = new QLabel;
  score_->setObjectName(QStringLiteral("atlas.score"));
  score_->setProperty("role", QStringLiteral("second"));
  score_->setWordWrap(true);
  rows->addWidget(score_);
  auto* remark = new QLabel(tr("For training scenes, not for treatment."));
  remark->setProperty("role", QStringLiteral("label"));
  rows->addWidget(remark);
  again_->hide();
  stop_->hide();
  both_->hide();

  connect(search_, &QLineEdit::textChanged, this, &AtlasPage::list_points);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    if (list_->count() > 0) list_->setCurrentRow(0);
  });
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr && atlas_) choose(atlas_->find(item->data(Qt::UserRole).toString().toStdString()), true);
  });
  connect(needle_, &QPushButton::clicked, this, [this] {
    if (chosen_ == nullptr || !making_.isEmpty()) return;
    model_.make_case(chosen_->code);
    making_ = text(chosen_->code);
  });
  connect(find_, &QPushButton::clicked, this, [this] { ask(false); });
  connect(again_, &QPushButton::clicked, this, [this] { ask(true); });
  connect(stop_, &QPushButton::clicked, this, &AtlasPage::stop_asking);
  connect(touch_, &QPushButton::toggled, this, &AtlasPage::touch_with_device);
  connect(view_, &AtlasView::touched, this, [this](const patient::AtlasPoint* point) { choose(point, false); });
  return side;
}

void AtlasPage::enter() {
  model_.prepare();
  view_->setFocus();
}

void AtlasPage::leave() {
  touch_->setChecked(false);
}

void AtlasPage::set_device(const std::optional<station::DeviceChoice>& device) {
  touch_->setChecked(false);
  device_ = device;
}

void AtlasPage::touch_with_device(bool on) {
  if (!on) {
    hand_.cancel();
    view_->show_needle(std::nullopt, usual_reach);
    touches_ = opens_ = false;
    return;
  }
  if (!device_) {
    view_->show_message(tr("The mouse points by itself. Choose a device under Devices to touch with its needle."));
    touch_->setChecked(false);
    return;
  }
  if (quiz_.point() != nullptr) stop_asking();
  touches_ = opens_ = true;
  view_->show_message(tr("Touch a point with the needle. Wheel to come nearer, drag to turn."));
}

// The needle at the device's position; it disappears with the device.
void AtlasPage::follow_device() {
  const DeviceWork::Status status = hand_.status();
  if (opens_) {
    if (status.is_busy) return;
    hand_.check(*device_, longest_touch);
    opens_ = false;
    return;
  }
  if (!status.is_busy) {
    const QString why = in_words(status.trouble);
    touch_->setChecked(false);
    view_->show_message(why);
    return;
  }
  if (!status.is_open) return;
  const Vec3 &low = status.abilities.workspace_low, &high = status.abilities.workspace_high;
  Pose hand = status.hand;
  hand.translation() -= 0.5 * (low + high);
  view_->show_needle(hand, high.z() > low.z() ? high.z() - low.z() : usual_reach);
}

void AtlasPage::advance(double /*clock*/) {
  const AtlasModel::Status status = model_.status();
  if (!atlas_) atlas_ = model_.atlas();
  if (atlas_ && !listed_) {
    listed_ = true;
    list_points();
  }
  if (!view_->is_ready()) {
    if (const auto surfaces = model_.surfaces(); surfaces && atlas_) {
      view_->show_message({});
      view_->set_body(atlas_, surfaces);
    } else {
      view_->show_message(status.error.empty() ? tr("Preparing the body: %1 %").arg(qRound(100.0 * status.fraction))
                                               : in_words(status.error));
    }
  }
  if (touches_) follow_device();
  if (!making_.isEmpty()) {
    view_->show_message(tr("Preparing %1: %2 %").arg(making_).arg(qRound(100.0 * status.fraction)));
    if (!status.working) {
      making_.clear();
      view_->show_message(in_words(status.error));
      const std::optional<Vec3> found = std::exchange(found_at_, std::nullopt);
      if (status.error.empty() && found) {
        emit needling_requested(text(status.made.string()), *found);
      } else if (status.error.empty()) {
        emit patient_requested(text(status.made.string()));
      }
    }
  }
}

void AtlasPage::list_points() {
  list_->clear();
  if (!atlas_) return;
  const auto found = atlas_->search(search_->text().toStdString());
  for (const patient::AtlasPoint* point : found) {
    auto* item = new QListWidgetItem(
        QStringLiteral("%1   %2   %3").arg(text(point->code), -5).arg(text(point->pinyin), characters(*point)));
    item->setData(Qt::UserRole, text(point->code));
    item->setToolTip(in_words(point->meridian));
    list_->addItem(item);
  }
  if (found.empty()) list_->addItem(tr("No point of that name."));
}

QString AtlasPage::collateral_words(const patient::Collateral& collateral) const {
  const patient::AtlasPoint* const source = atlas_->find(collateral.source);
  if (source == nullptr) {
    return tr("<p><b>Luo-connecting point</b> Its collateral %1.</p>")
        .arg(in_words(std::string(collateral.goes_to)).toHtmlEscaped());
  }
  return tr("<p><b>Luo-connecting point</b> Its collateral goes to the %1 meridian; the dashed line to the source "
            "point "
            "%2 is a scheme, no course is published.</p>")
      .arg(in_words(source->meridian), text(source->code));
}

void AtlasPage::choose(const patient::AtlasPoint* point, bool look) {
  chosen_ = point;
  view_->choose(point);
  needle_->setVisible(point != nullptr);
  if (point == nullptr) {
    card_->setText(tr("<p>Touch a point on the body, or search for one.</p>"));
    return;
  }
  if (look) view_->look_at(point->place, point->normal);
  const patient::Needling how = atlas_->needling(*point);
  std::string region = point->region;
  std::replace(region.begin(), region.end(), '_', ' ');
  QString words = tr("<p style='font-size:18px'><b>%1</b> %2 %3</p><p>%4 meridian, %5</p>")
                      .arg(text(point->code), text(point->pinyin), characters(*point), in_words(point->meridian),
                           in_words(region));
  words +=
      tr("<p><b>Depth</b> %1 to %2 mm<br><b>Angle</b> %3 degrees to the skin%4</p>")
          .arg(qRound(how.shallowest))
          .arg(qRound(how.deepest))
          .arg(qRound(how.angle))
          .arg(how.direction.empty() ? QString() : QStringLiteral(", ") + in_words(how.direction).toHtmlEscaped());
  if (!how.caution.empty())
    words += tr("<p style='color:#F2A33C'><b>Caution</b> %1</p>").arg(in_words(how.caution).toHtmlEscaped());
  QStringList under;
  if (point->bone_depth) under << tr("bone at %1 mm").arg(qRound(*point->bone_depth));
  if (point->danger_depth) under << tr("%1 at %2 mm").arg(in_words(point->danger)).arg(qRound(*point->danger_depth));
  if (!under.isEmpty()) words += tr("<p><b>Straight under it</b> %1</p>").arg(under.join(QStringLiteral(", ")));
  if (const patient::Collateral* const collateral = patient::collateral_at(point->code))
    words += collateral_words(*collateral);
  words += how.derived ? tr("<p>Depth derived from this body, not published.</p>")
                       : tr("<p>%1</p>").arg(text(how.source).toHtmlEscaped());
  card_->setText(words);
}

void AtlasPage::take(const Vec3& place, const patient::AtlasPoint* point) {
  if (!quiz_.asked()) {
    if (point != nullptr) choose(point, false);
    return;
  }
  quiz_.answer(place);
  show_score();
  again_->show();
  find_->setText(tr("Next point"));
  if (both_->isChecked() && needles_found(place)) return;
  view_->hide_points(false);
  view_->show_answer(place);
  choose(quiz_.point(), false);
  view_->show_message(tr("%1 %2: you are %3 mm off")
                          .arg(text(quiz_.point()->code), text(quiz_.point()->pinyin))
                          .arg(quiz_.miss(), 0, 'f', 0));
}

// The case about the requested point, for a needle at the shown place. False if the place is not in it. A case has
// the left half of the body.
bool AtlasPage::needles_found(const Vec3& place) {
  const patient::AtlasPoint& point = *quiz_.point();
  const bool is_right = point.bilateral && (place - point.mirrored()).norm() < (place - point.place).norm();
  if (quiz_.miss() > farthest_needled) return false;
  found_at_ = is_right ? Vec3(-place.x(), place.y(), place.z()) : place;
  model_.make_case(point.code);
  making_ = text(point.code);
  return true;
}

void AtlasPage::ask(bool same) {
  touch_->setChecked(false);
  if (!atlas_ || !view_->is_ready() || !making_.isEmpty()) return;
  if (same) {
    quiz_.ask_again();
  } else {
    quiz_.ask(*atlas_);
  }
  choose(nullptr, false);
  card_->setText(tr("<p>Click on the body where the point is. Drag to turn, wheel to come nearer.</p>"));
  list_->setEnabled(false);
  search_->setEnabled(false);
  view_->show_answer(std::nullopt);
  view_->hide_points(true);
  if (!same) view_->look_at_all();
  view_->show_message(tr("Where is %1, %2?").arg(text(quiz_.point()->code), text(quiz_.point()->pinyin)));
  again_->hide();
  stop_->show();
  both_->show();
  view_->setFocus();
}

void AtlasPage::stop_asking() {
  quiz_.stop();
  list_->setEnabled(true);
  search_->setEnabled(true);
  view_->hide_points(false);
  view_->show_answer(std::nullopt);
  view_->show_message({});
  find_->setText(tr("Find points"));
  again_->hide();
  stop_->hide();
  both_->hide();
}

void AtlasPage::show_score() {
  score_->setText(tr("%1 of %2 found within %3 mm; %4 mm off on average")
                      .arg(quiz_.found())
                      .arg(quiz_.rounds())
                      .arg(PointQuiz::near, 0, 'f', 0)
                      .arg(quiz_.mean_miss(), 0, 'f', 0));
}

bool AtlasPage::press(const QKeySequence& keys) {
  if (keys == QKeySequence(Qt::Key_N)) {
    ask(false);
  } else if (keys == QKeySequence(Qt::Key_A) && quiz_.answered()) {
    ask(true);
  } else if (keys == QKeySequence(Qt::Key_T)) {
    touch_->toggle();
  } else if (keys == QKeySequence(Qt::Key_0)) {
    view_->look_at_all();
  } else {
    return false;
  }
  return true;
}

}  // namespace bodkin::app
