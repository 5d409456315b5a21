#pragma once

#include <QWidget>
#include <filesystem>
#include <vector>

class QLabel;
class QHBoxLayout;
class QPushButton;

namespace bodkin::app {

// What a person can begin with: the procedure on the patient that comes with Bodkin, a patient opened before, or
// images that are dropped here.
class StartPage : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);

  // Patients that can be opened at once, newest first.
  void show_patients(const std::vector<std::filesystem::path>& folders);
  // One sentence at the foot; empty: none. Trouble is shown as such.
  void say(const QString& sentence, bool is_trouble);

 signals:
  void begin_requested();
  void patient_chosen(const QString& path);
  void open_requested();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* make_side();
  QWidget* make_hero();
  QPushButton* make_card(const QString& name, const QString& title, const QString& words);

  QHBoxLayout* patients_ = nullptr;
  QLabel* line_ = nullptr;
};

}  // namespace bodkin::app
