#pragma once

#include <QWidget>
#include <array>
#include <utility>
#include <vector>

#include "app/key_table.h"
#include "app/models/case_model.h"
#include "app/models/station_link.h"
#include "views/states.h"

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace bodkin::app {

using namespace views;

// A card in the middle of a dimmed page.
class Card : public QWidget {
  Q_OBJECT
 public:
  // `width` in pixels.
  Card(const char* name, QWidget* parent, int width = 520);

 protected:
  void paintEvent(QPaintEvent* event) override;
  QVBoxLayout* rows() { return rows_; }
  QLabel* add_label(const char* role);
  // An empty label takes no space.
  void write(QLabel* label, const QString& text);
  QPushButton* add_button(QHBoxLayout* row, const char* name, const QString& text, const QString& tip, bool primary);

 private:
  QWidget* sheet_;
  QVBoxLayout* rows_;
};

// The present preparation step, its progress, and a button to cancel.
class PreparingCard : public Card {
  Q_OBJECT
 public:
  explicit PreparingCard(QWidget* parent);
  // The step `what`, `fraction` (0 to 1) complete, `seconds` after the beginning of the preparation. The remaining
  // time is estimated from the step's own pace.
  void show_progress(const QString& what, double fraction, double seconds);

 signals:
  void cancel_requested();

 private:
  QLabel* what_;
  QLabel* time_;
  QProgressBar* bar_;
  double step_began_ = 0.0;  // s
};

// Resume, Again, End, Leave; also after a fault and after a device is lost.
class PauseCard : public Card {
  Q_OBJECT
 public:
  explicit PauseCard(QWidget* parent);
  // `state`: paused, faulted or device_lost.
  void show_reason(State state, const QString& reason);

 signals:
  void resume_requested();  // if a device was lost: reconnect
  void mouse_requested();   // continue with the mouse
  void again_requested();
  void end_requested();
  void leave_requested();

 private:
  QLabel* title_;
  QLabel* reason_;
  QPushButton* resume_;
  QPushButton* mouse_;
};

// The result of an attempt.
class ResultsCard : public Card {
  Q_OBJECT
 public:
  explicit ResultsCard(QWidget* parent);
  // `result`: null while saving. `dangers`: one sentence each, the worst first. `failure`: why saving failed, or why
  // the attempt ended; empty: no failure.
  void show_result(const AttemptResult* result, const QStringList& dangers, const QString& failure);
  // The progress of a training plan, and the text of the button for another attempt; both empty: no plan.
  void show_plan(const QString& standing, const QString& next);

 signals:
  void again_requested();
  void review_requested();
  void look_requested();  // show the views under the card
  void leave_requested();

 private:
  static QString grade_name(training::Grade grade);
  void show_grade(training::Grade grade);

  QLabel* grade_;
  QLabel* headline_;
  QLabel* dangers_;
  QLabel* remarks_;
  QLabel* numbers_;
  QLabel* file_;
  QLabel* plan_;
  QPushButton* review_;
  QPushButton* again_;
};

// Version, licence, libraries and system of this Bodkin.
class AboutCard : public Card {
  Q_OBJECT
 public:
  explicit AboutCard(QWidget* parent);

  // Name and version of Bodkin, its libraries, compiler and system, in display order.
  static std::vector<std::pair<QString, QString>> versions();

 signals:
  void closed();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
};

// The keys of a screen.
class KeysCard : public Card {
  Q_OBJECT
 public:
  explicit KeysCard(QWidget* parent);
  void show_keys(const std::vector<KeyScope>& scopes);

 signals:
  void closed();

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  std::array<QLabel*, 3> columns_;
};

}  // namespace bodkin::app
