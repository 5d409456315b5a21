#pragma once

#include <QKeySequence>
#include <QWidget>
#include <cstdint>
#include <memory>

#include "app/key_table.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// The pages of the window below the bar.
enum class PageId : std::uint8_t {
  start,
  practise,
  plan,
  scan,
  review,
  models,
  devices,
  atlas,
  volume,
  ultrasound,
  segment,
  training,
  camera
};
inline constexpr int page_count = 13;

const char* name_of(PageId id) noexcept;  // "plan", as in scripts and objectName

// A page besides the start and the practice page. The window owns it, shows it alone, and pauses an attempt
// meanwhile. It draws and computes only between enter() and leave().
class Page : public QWidget {
  Q_OBJECT
 public:
  // `scope`: of its keys in the key table. `needs_patient`: the window opens one before it shows the page.
  Page(PageId id, KeyScope scope, bool needs_patient, QWidget* parent = nullptr);

  PageId id() const noexcept { return id_; }
  KeyScope scope() const noexcept { return scope_; }
  bool needs_patient() const noexcept { return needs_patient_; }

  // Another patient, or none; called also while the page is hidden.
  virtual void set_case(std::shared_ptr<const OpenCase> patient);
  virtual void enter() {}
  virtual void leave() {}
  // Once a frame while visible, `clock` s after the window opened.
  virtual void advance(double clock);
  // A key of its scope whose command is of_the_page; false: it has no effect now.
  virtual bool press(const QKeySequence& keys);

 signals:
  void page_requested(bodkin::app::PageId id);
  // Open a folder of a case, a DICOM folder or an image, and practise on it.
  void patient_requested(const QString& path);
  // Return to the practice page.
  void practise_requested();

 private:
  PageId id_;
  KeyScope scope_;
  bool needs_patient_;
};

}  // namespace bodkin::app
