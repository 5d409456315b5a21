#pragma once

#include <QWidget>
#include <filesystem>
#include <vector>

#include "app/page.h"

class QLabel;
class QHBoxLayout;
class QVBoxLayout;
class QPushButton;

namespace bodkin::app {

// The choices at the start: a procedure on a patient supplied with Bodkin, a patient opened before, or images dropped
// here.
class StartPage : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);

  // Patients that can be opened immediately, newest first.
  void show_patients(const std::vector<std::filesystem::path>& folders);
  // One sentence at the bottom; empty: none. Trouble is marked as such.
  void show_message(const QString& sentence, bool is_trouble);
  // Offers a session truncated by a crash, at the top; empty: none.
  void offer_recovered(const QString& file);
  // Offers a training plan in progress, at the top; empty: none.
  void offer_plan(const QString& words);
  // Adds a button to another page below the existing ones.
  void add_entry(PageId page, const QString& text, const QString& tip);

 signals:
  void begin_requested();
  void procedure_chosen(const QString& name);
  void tour_requested();
  void patient_chosen(const QString& path);
  void open_requested();
  void about_requested();
  void page_requested(bodkin::app::PageId id);
  void review_requested(const QString& file);
  void forget_requested(const QString& file);
  void plan_continued();
  void plan_left();
  void language_requested(const QString& code);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* make_side();
  QPushButton* make_entry(const QString& text, const QString& object, const QString& tip);
  QWidget* make_hero();
  QWidget* make_procedures();
  struct Offer;
  static Offer make_offer();
  QWidget* make_recovered();
  QWidget* make_plan();
  void add_languages(QVBoxLayout* rows);
  QPushButton* make_card(const QString& name, const QString& title, const QString& words);

  QVBoxLayout* entries_ = nullptr;
  QHBoxLayout* patients_ = nullptr;
  QLabel* line_ = nullptr;
  QWidget* recovered_ = nullptr;
  QLabel* recovered_words_ = nullptr;
  QString recovered_file_;
  QWidget* plan_ = nullptr;
  QLabel* plan_words_ = nullptr;
};

}  // namespace bodkin::app
