#include "app/pages/cards.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "views/language.h"
#include "views/theme.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int width_of_keys = 1120;  // pixels
constexpr int dimming = 150;         // of 255

}  // namespace

Card::Card(const char* name, QWidget* parent, int width) : QWidget(parent) {
  setObjectName(QLatin1String(name));
  auto* across = new QHBoxLayout(this);
  auto* down = new QVBoxLayout;
  across->addStretch(1);
  across->addLayout(down);
  across->addStretch(1);
  sheet_ = new QWidget;
  sheet_->setObjectName(QStringLiteral("card"));
  sheet_->setAttribute(Qt::WA_StyledBackground);
  sheet_->setFixedWidth(width);
  rows_ = new QVBoxLayout(sheet_);
  rows_->setContentsMargins(28, 24, 28, 24);
  rows_->setSpacing(12);
  down->addStretch(1);
  down->addWidget(sheet_);
  down->addStretch(1);
  hide();
}

void Card::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QColor dim = Theme::dark().ground;
  dim.setAlpha(dimming);
  painter.fillRect(rect(), dim);
}

QLabel* Card::add_label(const char* role) {
  auto* label = new QLabel;
  label->setProperty("role", QLatin1String(role));
  label->setWordWrap(true);
  rows_->addWidget(label);
  return label;
}

void Card::write(QLabel* label, const QString& text) {
  if (label->text() == text && label->isHidden() == text.isEmpty()) return;
  label->setText(text);
  label->setVisible(!text.isEmpty());
  rows_->invalidate();  // otherwise the height of a removed label remains as an empty line
}

QPushButton* Card::add_button(QHBoxLayout* row, const char* name, const QString& text, const QString& tip,
                              bool primary) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setMinimumHeight(36);
  if (primary) button->setProperty("role", QStringLiteral("primary"));
  row->addWidget(button);
  return button;
}

PreparingCard::PreparingCard(QWidget* parent) : Card("preparing", parent) {
  add_label("heading")->setText(tr("The patient is being prepared"));
  what_ = add_label("plain");
  what_->setObjectName(QStringLiteral("preparing.what"));
  bar_ = new QProgressBar;
  bar_->setObjectName(QStringLiteral("preparing.bar"));
  bar_->setTextVisible(false);
  bar_->setRange(0, 1000);
  rows()->addWidget(bar_);
  time_ = add_label("second");
  time_->setObjectName(QStringLiteral("preparing.time"));
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  connect(add_button(row, "preparing.cancel", tr("Cancel"), tr("Back to the start"), false), &QPushButton::clicked,
          this, &PreparingCard::cancel_requested);
  rows()->addLayout(row);
}

void PreparingCard::show_progress(const QString& what, double fraction, double seconds) {
  // The duration of a step that has hardly begun cannot be estimated.
  constexpr double known_from = 0.1, worth_telling = 1.0;  // of the step; s
  if (what != what_->text() || seconds < step_began_) step_began_ = seconds;
  what_->setText(what);
  bar_->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
  const double left = fraction < known_from ? 0.0 : (seconds - step_began_) * (1.0 - fraction) / fraction;
  time_->setText(left < worth_telling ? tr("%1 s so far").arg(static_cast<int>(seconds))
                                      : tr("%1 s so far, about %2 s more for this step")
                                            .arg(static_cast<int>(seconds))
                                            .arg(static_cast<int>(std::lround(left))));
}

PauseCard::PauseCard(QWidget* parent) : Card("pause", parent) {
  title_ = add_label("heading");
  title_->setObjectName(QStringLiteral("pause.title"));
  reason_ = add_label("second");
  reason_->setObjectName(QStringLiteral("pause.reason"));
  auto* row = new QHBoxLayout;
  resume_ = add_button(row, "pause.resume", tr("Resume"), tr("Continue where you were (Esc)"), true);
  connect(resume_, &QPushButton::clicked, this, &PauseCard::resume_requested);
  mouse_ = add_button(row, "pause.mouse", tr("With the mouse"),
                      tr("Save this attempt and begin another one with the mouse"), false);
  connect(mouse_, &QPushButton::clicked, this, &PauseCard::mouse_requested);
  connect(add_button(row, "pause.again", tr("Again"), tr("Save this attempt and begin another one"), false),
          &QPushButton::clicked, this, &PauseCard::again_requested);
  connect(add_button(row, "pause.end", tr("End"), tr("Save this attempt and see the result"), false),
          &QPushButton::clicked, this, &PauseCard::end_requested);
  connect(add_button(row, "pause.leave", tr("Leave"), tr("Save this attempt and go back to the start"), false),
          &QPushButton::clicked, this, &PauseCard::leave_requested);
  rows()->addLayout(row);
}

void PauseCard::show_reason(State state, const QString& reason) {
  title_->setText(state == State::faulted       ? tr("The guard took the force away")
                  : state == State::device_lost ? tr("The device was disconnected")
                                                : tr("Paused"));
  reason_->setText(state == State::paused ? tr("The needle stays where it is.") : reason);
  const bool lost = state == State::device_lost;
  if (lost) {
    reason_->setText(tr("%1 What was recorded is safe. Reconnecting begins another attempt.")
                         .arg(reason.isEmpty() ? tr("It does not answer any more; the force is zero.") : reason));
  }
  resume_->setText(lost ? tr("Reconnect") : state == State::faulted ? tr("Arm again") : tr("Resume"));
  mouse_->setVisible(lost);
}

QString ResultsCard::grade_name(training::Grade grade) {
  switch (grade) {
    case training::Grade::pass:
      return tr("Passed");
    case training::Grade::borderline:
      return tr("Borderline");
    case training::Grade::fail:
      return tr("Not passed");
    case training::Grade::dangerous:
      return tr("Dangerous");
  }
  return {};
}

void ResultsCard::show_grade(training::Grade grade) {
  const bool bad = grade == training::Grade::dangerous || grade == training::Grade::fail;
  const bool good = grade == training::Grade::pass;
  const Theme& theme = Theme::now();
  grade_->setText(grade_name(grade));
  grade_->setStyleSheet(QStringLiteral("font-size: 15px; font-weight: 500; color: %1;")
                            .arg((bad    ? theme.danger
                                  : good ? theme.good
                                         : theme.caution)
                                     .name()));
}

ResultsCard::ResultsCard(QWidget* parent) : Card("results", parent) {
  grade_ = add_label("heading");
  grade_->setObjectName(QStringLiteral("results.grade"));
  dangers_ = add_label("danger");
  dangers_->setObjectName(QStringLiteral("results.dangers"));
  headline_ = add_label("heading");
  headline_->setObjectName(QStringLiteral("results.headline"));
  remarks_ = add_label("plain");
  numbers_ = add_label("second");
  plan_ = add_label("heading");
  plan_->setObjectName(QStringLiteral("results.plan"));
  plan_->hide();
  file_ = add_label("label");
  file_->setObjectName(QStringLiteral("results.file"));
  file_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  connect(add_button(row, "results.leave", tr("To the start"), tr("Choose another patient"), false),
          &QPushButton::clicked, this, &ResultsCard::leave_requested);
  connect(add_button(row, "results.look", tr("See where"),
                     tr("Hide this card and show the needle and the planned point in the views (Esc brings it back)"),
                     false),
          &QPushButton::clicked, this, &ResultsCard::look_requested);
  review_ =
      add_button(row, "results.review", tr("Review this"), tr("See the attempt again, moment by moment"), false);
  connect(review_, &QPushButton::clicked, this, &ResultsCard::review_requested);
  again_ = add_button(row, "results.again", tr("Again   A"), tr("The same patient and plan once more"), true);
  connect(again_, &QPushButton::clicked, this, &ResultsCard::again_requested);
  rows()->addLayout(row);
}

void ResultsCard::show_result(const AttemptResult* result, const QStringList& dangers, const QString& failure) {
  // With a verdict they are listed among the reasons.
  const bool has_verdict = result != nullptr && result->verdict;
  write(dangers_, has_verdict ? QString() : dangers.join(QLatin1Char('\n')));
  review_->setEnabled(result != nullptr);
  if (result == nullptr) {
    grade_->hide();
    headline_->setText(failure.isEmpty() ? tr("The session is being saved.") : tr("The session has ended."));
    write(remarks_, failure);
    write(numbers_, {});
    write(file_, {});
    return;
  }
  headline_->setText(in_words(result->headline));
  grade_->setVisible(result->verdict.has_value());
  if (result->verdict) show_grade(*result->verdict);
  QStringList remarks;
  for (const std::string& remark : result->remarks) remarks << in_words(remark);
  if (!failure.isEmpty()) remarks.prepend(failure);
  QString paragraphs;
  for (const QString& remark : remarks)
    paragraphs += QStringLiteral("<p style='margin: 0 0 6px 0'>%1</p>").arg(remark.toHtmlEscaped());
  write(remarks_, paragraphs);
  write(numbers_, !has_verdict ? QString()
                               : tr("%1 mm from the target, %2 mm deep, at most %3 N, %4 s in the body")
                                     .arg(result->target_distance, 0, 'f', 1)
                                     .arg(result->deepest, 0, 'f', 1)
                                     .arg(result->peak_force, 0, 'f', 2)
                                     .arg(result->time_in_body, 0, 'f', 0));
  write(file_, tr("Saved: %1").arg(QString::fromStdString(result->session.string())));
}

void ResultsCard::show_plan(const QString& standing, const QString& next) {
  plan_->setVisible(!standing.isEmpty());
  plan_->setText(standing);
  again_->setText(next.isEmpty() ? tr("Again   A") : next);
}

KeysCard::KeysCard(QWidget* parent) : Card("keys", parent, width_of_keys) {
  add_label("heading")->setText(tr("Keys"));
  auto* row = new QHBoxLayout;
  row->setSpacing(20);
  for (QLabel*& column : columns_) {
    column = new QLabel;
    column->setTextFormat(Qt::RichText);
    column->setAlignment(Qt::AlignTop);
    column->setWordWrap(true);
    row->addWidget(column, 1);
  }
  rows()->addLayout(row);
}

void KeysCard::show_keys(const std::vector<KeyScope>& scopes) {
  std::array<QString, 3> text;
  std::array<std::size_t, 3> lines{};
  for (const KeyScope scope : scopes) {
    QString block =
        QStringLiteral("<p style='color:%1'>%2</p><table>").arg(Theme::now().accent.name(), name_of(scope));
    QString last;
    QStringList keys;
    std::size_t count = 1;
    const auto flush = [&] {
      if (keys.isEmpty()) return;
      block += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                   .arg(keys.join(QLatin1Char(' ')).toHtmlEscaped(), last.toHtmlEscaped());
      ++count;
      keys.clear();
    };
    for (const KeyBinding& binding : key_table()) {
      if (binding.scope != scope) continue;
      const QString words = text_of(binding);
      if (words != last) flush();
      last = words;
      const QString key = QKeySequence(QLatin1String(binding.keys)).toString(QKeySequence::NativeText);
      if (!keys.contains(key)) keys << key;  // "Eingabe" is both Return and Enter
    }
    flush();
    block += QStringLiteral("</table>");
    const auto column = static_cast<std::size_t>(std::min_element(lines.begin(), lines.end()) - lines.begin());
    text[column] += block;
    lines[column] += count + 1;
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    columns_[i]->setText(text[i]);
    columns_[i]->setVisible(!text[i].isEmpty());
  }
}

void KeysCard::mousePressEvent(QMouseEvent*) {
  emit closed();
}

}  // namespace bodkin::app
