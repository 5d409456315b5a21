// How the review page is laid out.
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/pages/review.h"
#include "app/pages/session_list.h"
#include "app/pages/verdict_panel.h"
#include "scene/camera_moves.h"

namespace bodkin::app {

namespace {

constexpr int review_gap = 4, side_column = 330;  // pixels
constexpr double review_zoom = 1.12;

}  // namespace

QPushButton* ReviewPage::button(const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(text);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::NoFocus);  // keys belong to the page
  return made;
}

void ReviewPage::build() {
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  stack_ = new QStackedWidget;
  list_ = new SessionList;
  stack_->addWidget(list_);
  stack_->addWidget(make_player());
  whole->addWidget(stack_);
}

QWidget* ReviewPage::make_player() {
  auto* player = new QWidget;
  auto* columns = new QHBoxLayout(player);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(review_gap);
  auto* left = new QVBoxLayout;
  left->setSpacing(review_gap);
  left->addWidget(make_pictures(), 1);
  left->addWidget(make_transport());
  columns->addLayout(left, 1);
  auto* side = new QWidget;
  side->setObjectName(QStringLiteral("panel"));
  side->setAttribute(Qt::WA_StyledBackground);
  side->setFixedWidth(side_column);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(0, 8, 0, 8);
  rows->setSpacing(6);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(12, 0, 12, 0);
  QPushButton* const back = button(tr("Sessions"), "review.sessions", tr("Back to the list of sessions"));
  connect(back, &QPushButton::clicked, this, [this] { show_list(); });
  head->addWidget(back);
  title_ = new QLabel;
  title_->setObjectName(QStringLiteral("review.title"));
  title_->setWordWrap(true);
  title_->setProperty("role", QStringLiteral("label"));
  head->addWidget(title_, 1);
  rows->addLayout(head);
  verdict_ = new VerdictPanel;
  rows->addWidget(verdict_, 1);
  rows->addWidget(make_buttons());
  columns->addWidget(side);
  return player;
}

// The contents of images and videos.
QWidget* ReviewPage::make_pictures() {
  pictures_ = new QWidget;
  pictures_->setObjectName(QStringLiteral("ground"));
  pictures_->setAttribute(Qt::WA_StyledBackground);
  auto* rows = new QVBoxLayout(pictures_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(review_gap);
  auto* views = new QHBoxLayout;
  views->setSpacing(review_gap);
  body_ = new QStackedWidget;
  view3d_ = new View3d(QStringLiteral("review"));
  path_ = new PathPicture;
  path_->setObjectName(QStringLiteral("review.path"));
  body_->addWidget(view3d_);
  body_->addWidget(path_);
  views->addWidget(body_, 8);
  slice_column_ = new QWidget;
  slice_rows_ = new QVBoxLayout(slice_column_);
  slice_rows_->setContentsMargins(0, 0, 0, 0);
  slice_rows_->setSpacing(review_gap);
  small_slices_ = new QHBoxLayout;
  small_slices_->setSpacing(review_gap);
  auto measures = std::make_shared<Measures>();
  for (const auto& [kind, name] :
       {std::pair{SliceKind::sagittal, "review.slice.sagittal"}, std::pair{SliceKind::axial, "review.slice.axial"},
        std::pair{SliceKind::coronal, "review.slice.coronal"}}) {
    auto* slice = new SliceView(kind);
    slice->setObjectName(QLatin1String(name));
    slice->set_measures(measures);
    connect(slice, &View::crosshair_moved, this, [this](const Vec3& point) { crosshair_ = point; });
    connect(slice, &View::follow_tip_toggled, this,
            [this] { crosshair_ = crosshair_ ? std::nullopt : std::optional<Vec3>(frame_.crosshair); });
    connect(slice, &SliceView::measures_changed, this, [this] {
      for (SliceView* each : slices_) each->update();
    });
    slices_.push_back(slice);
  }
  ultrasound_ = new UltrasoundView;
  ultrasound_->setObjectName(QStringLiteral("review.ultrasound"));
  // Its probe is no longer held.
  ultrasound_->setAttribute(Qt::WA_TransparentForMouseEvents);
  ultrasound_->setFocusPolicy(Qt::NoFocus);
  slice_rows_->addLayout(small_slices_, 3);
  arrange_slices(false);
  views->addWidget(slice_column_, 6);
  rows->addLayout(views, 1);
  // There is no needle to push here: the wheel zooms.
  connect(view3d_, &View::pushed, this, [this](double notches, bool fine) {
    const scene::Camera now = view3d_->camera();
    view3d_->set_camera(scene::zoomed(now, std::pow(review_zoom, -notches * (fine ? 0.2 : 1.0)), now.focus));
  });
  chart_ = new ForceChart;
  chart_->setObjectName(QStringLiteral("review.chart"));
  chart_->setFixedHeight(150);
  chart_->set_axis(ForceChart::Axis::time);
  connect(chart_, &ForceChart::place_chosen, this, [this](double along) {
    if (recording_ == nullptr) return;
    if (chart_->axis() == ForceChart::Axis::time) return seek(along);
    // Over depth: the first moment at which the tip was this deep.
    const std::span<const station::HandSample> samples = recording_->samples();
    const auto there =
        std::find_if(samples.begin(), samples.end(), [&](const auto& each) { return each.depth >= along; });
    if (there != samples.end()) seek(there->time);
  });
  rows->addWidget(chart_);
  timeline_ = new Timeline;
  timeline_->setObjectName(QStringLiteral("review.timeline"));
  connect(timeline_, &Timeline::seek_requested, this, [this](double time) {
    play(false);
    seek(time);
  });
  rows->addWidget(timeline_);
  return pictures_;
}

// The large slot has the recorded ultrasound, or else the sagittal slice.
void ReviewPage::arrange_slices(bool has_ultrasound) {
  for (SliceView* slice : slices_) {
    slice_rows_->removeWidget(slice);
    small_slices_->removeWidget(slice);
  }
  slice_rows_->removeWidget(ultrasound_);
  slice_rows_->insertWidget(0, has_ultrasound ? static_cast<QWidget*>(ultrasound_) : slices_.front(), 4);
  for (std::size_t i = has_ultrasound ? 0 : 1; i < slices_.size(); ++i) small_slices_->addWidget(slices_[i], 1);
  ultrasound_->setVisible(has_ultrasound);
}

QWidget* ReviewPage::make_transport() {
  auto* bar = new QWidget;
  bar->setObjectName(QStringLiteral("panel"));
  bar->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(12, 6, 12, 6);
  row->setSpacing(6);
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto&& act) {
    QPushButton* const made = button(text, name, tip);
    connect(made, &QPushButton::clicked, this, act);
    row->addWidget(made);
    return made;
  };
  add(tr("< Event"), "review.event.before", tr("Go to the previous event (Shift+Left)"), [this] { step_event(-1); });
  add(tr("< Step"), "review.step.back", tr("One frame back, 1/25 s (Left)"), [this] { step(-1); });
  play_ = add(tr("Play"), "review.play", tr("Play, pause (Space)"), [this] { play(!playing_); });
  play_->setProperty("role", QStringLiteral("primary"));
  play_->setMinimumWidth(72);
  add(tr("Step >"), "review.step.on", tr("One frame forward, 1/25 s (Right)"), [this] { step(1); });
  add(tr("Event >"), "review.event.next", tr("Go to the next event (Shift+Right)"), [this] { step_event(1); });
  row->addSpacing(10);
  for (const double times : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    const QString text = times < 1.0 ? (times < 0.5 ? QStringLiteral("1/4") : QStringLiteral("1/2"))
                                     : QStringLiteral("%1x").arg(times);
    const QByteArray name = "review.speed." + QByteArray::number(times);
    QPushButton* const speed = add(text, name.constData(), tr("%1 times as fast (, slower, . faster)").arg(times),
                                   [this, times] { set_speed(times); });
    speed->setCheckable(true);
    speed->setProperty("speed", times);
    speed->setProperty("role", QStringLiteral("flat"));
    speeds_.push_back(speed);
  }
  row->addStretch(1);
  auto* moment = new QVBoxLayout;  // one over the other: the names of structures are long
  moment->setSpacing(0);
  row->addLayout(moment);
  place_ = new QLabel;
  place_->setObjectName(QStringLiteral("review.place"));
  place_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  moment->addWidget(place_);
  clock_label_ = new QLabel;
  clock_label_->setObjectName(QStringLiteral("review.clock"));
  clock_label_->setProperty("role", QStringLiteral("second"));
  clock_label_->setMinimumWidth(92);
  clock_label_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  moment->addWidget(clock_label_);
  return bar;
}

QWidget* ReviewPage::make_buttons() {
  auto* box = new QWidget;
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(12, 0, 12, 0);
  rows->setSpacing(6);
  auto* doing = new QHBoxLayout;
  busy_ = new QLabel;
  busy_->setObjectName(QStringLiteral("review.busy"));
  busy_->setProperty("role", QStringLiteral("second"));
  busy_->setWordWrap(true);
  doing->addWidget(busy_, 1);
  cancel_ = button(tr("Cancel"), "review.cancel", tr("Stop the running task"));
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (series_ != nullptr) return series_->cancel();
    if (other_job_ != nullptr) return other_job_->cancel();
    if (job_ != nullptr) job_->cancel();
  });
  cancel_->hide();
  doing->addWidget(cancel_);
  rows->addLayout(doing);
  auto* first = new QHBoxLayout;
  auto* second = new QHBoxLayout;
  const auto add = [&](QHBoxLayout* row, const QString& text, const char* name, const QString& tip, auto&& act) {
    QPushButton* const made = button(text, name, tip);
    connect(made, &QPushButton::clicked, this, act);
    row->addWidget(made, 1);
    return made;
  };
  compare_ = add(first, tr("Compare..."), "review.compare", tr("A second session over this one, in a second colour"),
                 [this] { other_ != nullptr ? stop_comparing() : choose_file(true); });
  add(first, tr("Report"), "review.report", tr("Write the report as an HTML page, and show it (G)"),
      [this] { write_report(); });
  add(second, tr("Pictures..."), "review.pictures", tr("25 numbered pictures for each second"),
      [this] { choose_target(false); });
  add(second, tr("Video..."), "review.video", tr("Made with ffmpeg, if it is installed"),
      [this] { choose_target(true); });
  rows->addLayout(first);
  rows->addLayout(second);
  return box;
}

}  // namespace bodkin::app
