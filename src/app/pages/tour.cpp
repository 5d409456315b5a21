#include "app/pages/tour.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "views/theme.h"

namespace bodkin::app {

using namespace views;

namespace {

using Step = TourSteps::Step;

constexpr int balloon_width = 330, tail_size = 14, least_drag = 25, ring_free = 34;  // pixels

// The target of the balloon's tail, the subject of the step, in fractions of the page.
struct BalloonText {
  const char* title;
  const char* words;
  double x, y;
};
constexpr BalloonText balloons[] = {
    {QT_TRANSLATE_NOOP("bodkin::app::Tour", "Look"),
     QT_TRANSLATE_NOOP("bodkin::app::Tour",
                       "Turn the patient: drag next to the needle with the left button, or press an arrow key."),
     0.20, 0.45},
    {QT_TRANSLATE_NOOP("bodkin::app::Tour", "Aim"),
     QT_TRANSLATE_NOOP("bodkin::app::Tour",
                       "The ring on the skin is where to go in. Point at it and click: the needle goes to the skin."),
     0.30, 0.42},
    {QT_TRANSLATE_NOOP("bodkin::app::Tour", "Push"),
     QT_TRANSLATE_NOOP("bodkin::app::Tour",
                       "Scroll towards you. The skin dents, the force rises in the chart, then the skin gives."),
     0.22, 0.80},
    {QT_TRANSLATE_NOOP("bodkin::app::Tour", "Read"),
     QT_TRANSLATE_NOOP("bodkin::app::Tour",
                       "At the upper left is the tissue at the tip, and to the right of it the ladder of the tissues "
                       "on the needle's line. Push on until the name changes."),
     0.12, 0.12},
    {QT_TRANSLATE_NOOP("bodkin::app::Tour", "That is all"),
     QT_TRANSLATE_NOOP("bodkin::app::Tour",
                       "Continue until you reach the fluid, slowly at the last puncture. Space holds the needle, E "
                       "ends and shows the result, F1 shows every key."),
     0.20, 0.30}};

}  // namespace

Tour::Tour(QWidget* page, View3d* patient)
    : QWidget(page),
      patient_(patient),
      number_(new QLabel),
      title_(new QLabel),
      words_(new QLabel),
      leave_(new QPushButton(tr("Skip the tour"))) {
  setObjectName(QStringLiteral("tour"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(18 + tail_size, 14, 18, 14);
  rows->setSpacing(6);
  number_->setProperty("role", QStringLiteral("label"));
  title_->setProperty("role", QStringLiteral("heading"));
  title_->setObjectName(QStringLiteral("tour.title"));
  words_->setWordWrap(true);
  words_->setObjectName(QStringLiteral("tour.words"));
  rows->addWidget(number_);
  rows->addWidget(title_);
  rows->addWidget(words_);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  leave_->setObjectName(QStringLiteral("tour.leave"));
  leave_->setToolTip(tr("Close this and continue to practise"));
  leave_->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
  connect(leave_, &QPushButton::clicked, this, &Tour::end);
  row->addWidget(leave_);
  rows->addLayout(row);
  patient_->installEventFilter(this);
  hide();
}

void Tour::begin() {
  steps_ = {};
  running_ = true;
  shown_ = Step::done;
}

void Tour::end() {
  running_ = false;
  hide();
}

void Tour::show_frame(const Frame& frame) {
  if (!running_) return;
  if (frame.state == State::no_case || frame.state == State::ended) return end();
  if (frame.state == State::preparing) return;
  steps_.see(frame);
  if (!isVisible() || shown_ != steps_.step()) return show_step(frame);
  if (shown_ == Step::aim) place(frame);  // the patient may be turned
}

std::optional<QPoint> Tour::ring(const Frame& frame) const {
  if (!frame.plan || patient_->scene() == nullptr || patient_->scene()->width() <= 0) return std::nullopt;
  const auto at = patient_->scene()->projection().place(frame.plan->entry);
  if (!at) return std::nullopt;
  const double scale = static_cast<double>(patient_->width()) / patient_->scene()->width();
  const QPoint there = QPointF(at->x * scale, at->y * scale).toPoint();
  if (!patient_->rect().contains(there)) return std::nullopt;
  return patient_->mapTo(parentWidget(), there);
}

// The balloon about the ring points at it and does not cover it.
void Tour::place(const Frame& frame) {
  const BalloonText& text = balloons[static_cast<int>(shown_)];
  const QSize page = parentWidget()->size();
  QPoint about(static_cast<int>(text.x * page.width()), static_cast<int>(text.y * page.height()));
  tail_right_ = false;
  if (const auto at = shown_ == Step::aim ? ring(frame) : std::nullopt) {
    tail_right_ = at->x() + ring_free + width() > page.width() - 8;
    about = *at + QPoint(tail_right_ ? -ring_free - width() : ring_free, 0);
  }
  const int y = std::clamp(about.y() - height() / 2, 8, std::max(8, page.height() - height() - 8));
  move(std::clamp(about.x(), 8, std::max(8, page.width() - width() - 8)), y);
  layout()->setContentsMargins(18 + (tail_right_ ? 0 : tail_size), 14, 18 + (tail_right_ ? tail_size : 0), 14);
}

void Tour::show_step(const Frame& frame) {
  shown_ = steps_.step();
  const int index = static_cast<int>(shown_);
  const BalloonText& text = balloons[index];
  number_->setText(shown_ == Step::done ? tr("The tour") : tr("%1 of %2").arg(index + 1).arg(TourSteps::count));
  title_->setText(tr(text.title));
  words_->setText(tr(text.words));
  leave_->setText(shown_ == Step::done ? tr("Done") : tr("Skip the tour"));
  leave_->setAccessibleName(leave_->text());
  const int high = heightForWidth(balloon_width) > 0 ? heightForWidth(balloon_width) : sizeHint().height();
  resize(balloon_width, high);
  place(frame);
  show();
  raise();
  update();
}

QPoint Tour::tail() const {
  return {tail_right_ ? width() - 2 : 1, height() / 2};
}

void Tour::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = Theme::now();
  QPolygonF pointer;
  const double root = tail_right_ ? width() - tail_size - 1.0 : tail_size + 1.0;
  pointer << tail() << QPointF(root, tail().y() - 10.0) << QPointF(root, tail().y() + 10.0);
  painter.setPen(QPen(theme.accent, 1.5));
  painter.setBrush(theme.raised);
  const double left = tail_right_ ? 1.0 : tail_size;
  painter.drawRoundedRect(QRectF(left, 1.0, width() - tail_size - 1.5, height() - 2.0), 10.0, 10.0);
  painter.drawPolyline(pointer);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(pointer);
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (running_ && steps_.step() == Step::look) {
    if (event->type() == QEvent::MouseButtonPress) pressed_ = static_cast<QMouseEvent*>(event)->pos();
    if (event->type() == QEvent::MouseMove) {
      const auto* const moved = static_cast<QMouseEvent*>(event);
      if (moved->buttons() != Qt::NoButton && (moved->pos() - pressed_).manhattanLength() > least_drag)
        steps_.looked();
    }
    if (event->type() == QEvent::KeyPress) {
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down) steps_.looked();
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace bodkin::app
