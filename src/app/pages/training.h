#pragma once

#include <future>
#include <optional>

#include "app/models/training_run.h"
#include "app/page.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace bodkin::app {

// A learning curve with CUSUM, as `bodkin results show` draws it.
class LearningCurve : public QWidget {
 public:
  explicit LearningCurve(QWidget* parent = nullptr);
  // In the order of time, of one procedure; none: a message in an empty figure.
  void show_attempts(const std::vector<training::AttemptSummary>& attempts);
  std::size_t attempts() const { return attempts_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPixmap picture_;
  std::size_t attempts_ = 0;
};

// Selection of a trainee's plan, its stages and progress, and the start of the next attempt.
class TrainingPage : public Page {
  Q_OBJECT
 public:
  explicit TrainingPage(QWidget* parent = nullptr);
  ~TrainingPage() override;

  void enter() override;
  void advance(double clock) override;
  bool press(const QKeySequence& keys) override;

  // Selects another plan, a name or a file.
  void choose(const QString& plan);
  // The standing of the chosen plan and trainee has been looked up.
  bool is_ready() const { return !looking_.valid(); }
  const std::optional<PlanStanding>& standing() const { return standing_; }

 signals:
  void follow_requested(const QString& plan, const QString& trainee);

 private:
  QWidget* make_side();
  QWidget* make_standing();
  void list_plans();
  void open_plan();
  void look();
  void show_standing();
  void follow();

  QString plan_;
  QListWidget* list_;
  QLineEdit* trainee_;
  QPushButton* follow_;
  QLabel *title_, *progress_, *stages_, *line_;
  LearningCurve* curve_;
  bool look_again_ = false;
  std::optional<PlanStanding> standing_;
  std::future<PlanStanding> looking_;
};

}  // namespace bodkin::app
