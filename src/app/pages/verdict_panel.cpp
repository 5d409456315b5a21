#include "app/pages/verdict_panel.h"

#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>
#include <string_view>

#include "views/language.h"
#include "views/paint_kit.h"
#include "views/theme.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr std::size_t most_gauges = 3;
constexpr std::array<std::string_view, 7> telling = {"final_distance_mm", "loss_overshoot_mm", "time_in_body_s",
                                                     "path_length_mm",    "deviation_max_mm",  "peak_force_N",
                                                     "bone_contacts"};

QString words(std::string_view text) {
  return in_words(std::string(text));
}

QString verdict_word(training::Grade grade) {
  switch (grade) {
    case training::Grade::pass:
      return VerdictPanel::tr("Passed");
    case training::Grade::borderline:
      return VerdictPanel::tr("Borderline");
    case training::Grade::fail:
      return VerdictPanel::tr("Not passed");
    case training::Grade::dangerous:
      return VerdictPanel::tr("Dangerous");
  }
  return {};
}

QColor verdict_colour(training::Grade grade) {
  const Theme& theme = Theme::now();
  if (grade == training::Grade::pass) return theme.good;
  return grade == training::Grade::borderline ? theme.caution : theme.danger;
}

QString value_text(const training::MetricResult& result) {
  return QString::fromStdString(training::metric_text(*result.metric, result.value));
}

}  // namespace

std::vector<training::MetricResult> key_numbers(const training::Score& score) {
  std::vector<training::MetricResult> chosen;
  for (const bool of_experts : {true, false}) {
    for (const std::string_view name : telling) {
      const training::MetricResult* const found = score.find(name);
      if (found != nullptr && found->experts.has_value() == of_experts && chosen.size() < most_gauges)
        chosen.push_back(*found);
    }
  }
  return chosen;
}

BandGauge::BandGauge(const training::MetricResult& result, QWidget* parent) : QWidget(parent), result_(result) {
  setFixedHeight(46);
  setAccessibleName(words(result.metric->title));
  setToolTip(result.experts ? tr("The band holds nine of ten experts") : tr("No experts to compare with"));
}

void BandGauge::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Theme& theme = Theme::now();
  set_font(painter, 12);
  draw_text(painter, {0.0, 14.0}, words(result_.metric->title), theme.second);
  set_font(painter, text_size, true);
  draw_text(painter, {width() - 2.0, 14.0}, value_text(result_), theme.text, Anchor::right);
  if (!result_.experts) return;
  const training::ExpertSet::Place& band = *result_.experts;
  const double span = std::max({band.high - band.low, 1e-6});
  const double low = std::min({0.0, band.low - 0.25 * span, result_.value}),
               high = std::max(band.high + 0.5 * span, 1.05 * result_.value);
  const auto x = [&](double value) { return 6.0 + (width() - 12.0) * (value - low) / (high - low); };
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.raised);
  painter.drawRoundedRect(QRectF(0.0, 22.0, width(), 8.0), 4.0, 4.0);
  QColor good = theme.good;
  good.setAlphaF(0.55);
  painter.setBrush(good);
  painter.drawRoundedRect(QRectF(x(band.low), 22.0, std::max(3.0, x(band.high) - x(band.low)), 8.0), 4.0, 4.0);
  const bool inside = result_.value >= band.low && result_.value <= band.high;
  painter.setPen(QPen(theme.panel, 1.5));
  painter.setBrush(inside ? theme.text : theme.caution);
  painter.drawEllipse(QPointF(x(result_.value), 26.0), 6.0, 6.0);
  set_font(painter, label_size);
  const auto text = [&](double value) {
    return QString::fromStdString(training::metric_text(*result_.metric, value));
  };
  draw_text(painter, {0.0, 43.0}, tr("experts %1 to %2").arg(text(band.low), text(band.high)), theme.second);
}

VerdictPanel::VerdictPanel(QWidget* parent) : QWidget(parent) {
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setObjectName(QStringLiteral("review.verdict"));
  auto* inner = new QWidget;
  rows_ = new QVBoxLayout(inner);
  rows_->setContentsMargins(14, 10, 14, 10);
  rows_->setSpacing(8);
  message_ = add("review.said", "plain");
  grade_ = add("review.grade", "heading");
  headline_ = add("review.headline", "heading");
  note_ = add("review.note", "second");
  findings_ = add("review.findings", "plain");
  gauges_ = new QVBoxLayout;
  gauges_->setSpacing(6);
  rows_->addLayout(gauges_);
  details_ = add("review.details", "plain");
  rows_->addStretch(1);
  area->setWidget(inner);
  whole->addWidget(area);
  message_->hide();
}

QLabel* VerdictPanel::add(const char* name, const char* role) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setProperty("role", QLatin1String(role));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  rows_->addWidget(label);
  return label;
}

void VerdictPanel::show_message(const QString& sentence, bool is_trouble) {
  message_->setVisible(!sentence.isEmpty());
  message_->setText(sentence);
  message_->setStyleSheet(
      QStringLiteral("color: %1;").arg((is_trouble ? Theme::now().danger : Theme::now().accent).name()));
}

void VerdictPanel::show_recording(const Recording& recording) {
  show_message({}, false);
  while (QLayoutItem* item = gauges_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const std::optional<training::Score>& score = recording.score();
  QStringList notes;
  if (!recording.session().finished)
    notes << tr("This session was cut off; what had been recorded until then is here.");
  if (!recording.note().empty()) notes << in_words(recording.note());
  note_->setVisible(!notes.isEmpty());
  note_->setText(notes.join(QLatin1Char('\n')));
  grade_->setVisible(score.has_value());
  findings_->setVisible(score && !score->findings.empty());
  details_->setVisible(score.has_value());
  if (!score) {
    headline_->setText(in_words(recording.not_judged()));
    return;
  }
  grade_->setText(verdict_word(score->verdict));
  grade_->setStyleSheet(
      QStringLiteral("font-size: 15px; font-weight: 500; color: %1;").arg(verdict_colour(score->verdict).name()));
  headline_->setText(in_words(score->headline));
  QStringList sentences;
  for (const training::Finding& each : score->findings) sentences << in_words(each.sentence);
  findings_->setText(sentences.join(QStringLiteral("\n\n")));
  for (const training::MetricResult& each : key_numbers(*score)) gauges_->addWidget(new BandGauge(each));
  const QString faint = Theme::now().second.name();
  QString text;
  if (!score->steps.empty()) {
    text += QStringLiteral("<p style='color:%1'>%2</p><table width='100%'>").arg(faint, tr("Steps"));
    for (const training::StepResult& step : score->steps) {
      text += QStringLiteral("<tr><td>%1</td><td align='right'>%2</td></tr>")
                  .arg(in_words(step.title).toHtmlEscaped(),
                       step.time ? tr("%1 s").arg(*step.time, 0, 'f', 1) : tr("not seen"));
    }
    text += QStringLiteral("</table>");
  }
  text += QStringLiteral("<p style='color:%1'>%2</p><table width='100%'>").arg(faint, tr("Every measure"));
  for (const training::MetricResult& each : score->metrics) {
    text += QStringLiteral("<tr><td>%1</td><td align='right'>&nbsp;&nbsp;%2</td></tr>")
                .arg(words(each.metric->title).toHtmlEscaped(), value_text(each).toHtmlEscaped());
  }
  details_->setText(text + QStringLiteral("</table>"));
}

}  // namespace bodkin::app
