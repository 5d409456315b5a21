#pragma once

#include <QWidget>

#include "app/models/recording.h"

class QLabel;
class QVBoxLayout;

namespace bodkin::app {

// A number of an attempt on an axis with the range of the experts.
class BandGauge : public QWidget {
 public:
  explicit BandGauge(const training::MetricResult& result, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  training::MetricResult result_;
};

// The result of an attempt: the verdict and its reasons, the worst first, three numbers against the range of the
// experts, the steps of the procedure and every metric.
class VerdictPanel : public QWidget {
  Q_OBJECT
 public:
  explicit VerdictPanel(QWidget* parent = nullptr);

  void show_recording(const Recording& recording);
  // One sentence at the top, such as the path of a report; empty: none.
  void show_message(const QString& sentence, bool is_trouble);

 private:
  QLabel* add(const char* name, const char* role);

  QVBoxLayout* rows_;
  QVBoxLayout* gauges_;
  QLabel* message_;
  QLabel* grade_;
  QLabel* headline_;
  QLabel* note_;
  QLabel* findings_;
  QLabel* details_;
};

// The most important numbers of an attempt: at most three, those with expert ranges first.
std::vector<training::MetricResult> key_numbers(const training::Score& score);

}  // namespace bodkin::app
