#pragma once

#include <QKeySequence>
#include <QWidget>
#include <cstdint>
#include <memory>

#include "app/key_table.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// What can fill the window below the bar.
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

const char* name_of(PageId id) noexcept;  // "plan", as scripts and objectName have it

// A page beside the start and the practise page. The window owns it, shows it alone, and pauses an attempt meanwhile.
// It draws and computes only between enter() and leave().
class Page : public QWidget {
  Q_OBJECT
 public:
  // `scope`: where its keys stand in the key table. `needs_patient`: the window opens one before it shows the page.
  Page(PageId id, KeyScope scope, bool needs_patient, QWidget* parent = nullptr);

  PageId id() const noexcept { return id_; }
  KeyScope scope() const noexcept { return scope_; }
  bool needs_patient() const noexcept { return needs_patient_; }

  // Another patient, or none; also while the page is not shown.
  virtual void set_case(std::shared_ptr<const OpenCase> patient);
  virtual void enter() {}
  virtual void leave() {}
  // Once a frame while it is shown, `clock` s after the window opened.
  virtual void advance(double clock);
  // A key of its scope whose command is of_the_page; false: nothing is done with it now.
  virtual bool press(const QKeySequence& keys);

 signals:
  void page_requested(bodkin::app::PageId id);
  // A folder of a case, a DICOM folder or an image is opened, and practised on.
  void patient_requested(const QString& path);
  // Back to the needle.
  void practise_requested();

 private:
  PageId id_;
  KeyScope scope_;
  bool needs_patient_;
};

}  // namespace bodkin::app
