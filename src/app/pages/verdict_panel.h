#pragma once

#include <QWidget>

#include "app/models/recording.h"

class QLabel;
class QVBoxLayout;

namespace bodkin::app {

// A number of an attempt on an axis with the band of the experts.
class BandGauge : public QWidget {
 public:
  explicit BandGauge(const training::MetricResult& result, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  training::MetricResult result_;
};

// How an attempt went: the verdict and its reasons, the worst first, three numbers against the band of the experts,
// the steps of the procedure and every measure.
class VerdictPanel : public QWidget {
  Q_OBJECT
 public:
  explicit VerdictPanel(QWidget* parent = nullptr);

  void show_recording(const Recording& recording);
  // One sentence on top, such as where a report lies; empty: none.
  void say(const QString& sentence, bool is_trouble);

 private:
  QLabel* add(const char* name, const char* role);

  QVBoxLayout* rows_;
  QVBoxLayout* gauges_;
  QLabel* said_;
  QLabel* grade_;
  QLabel* headline_;
  QLabel* note_;
  QLabel* findings_;
  QLabel* details_;
};

// The numbers of an attempt that a person should see first: at most three, those that experts have before others.
std::vector<training::MetricResult> telling_numbers(const training::Score& score);

}  // namespace bodkin::app
