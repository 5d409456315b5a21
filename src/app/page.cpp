#include "app/page.h"

namespace bodkin::app {

const char* name_of(PageId id) noexcept {
  switch (id) {
    case PageId::start:
      return "start";
    case PageId::practise:
      return "practise";
    case PageId::plan:
      return "plan";
    case PageId::scan:
      return "scan";
    case PageId::review:
      return "review";
    case PageId::models:
      return "models";
    case PageId::devices:
      return "devices";
    case PageId::atlas:
      return "atlas";
    case PageId::volume:
      return "volume";
    case PageId::ultrasound:
      return "ultrasound";
    case PageId::segment:
      return "segment";
    case PageId::training:
      return "training";
    case PageId::camera:
      return "camera";
  }
  return "";
}

Page::Page(PageId id, KeyScope scope, bool needs_patient, QWidget* parent)
    : QWidget(parent), id_(id), scope_(scope), needs_patient_(needs_patient) {
  setObjectName(QString::fromLatin1(name_of(id)));
}

// By value, for the pages that keep it.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
void Page::set_case(std::shared_ptr<const OpenCase> /*patient*/) {}

void Page::advance(double /*clock*/) {}

bool Page::press(const QKeySequence& /*keys*/) {
  return false;
}

}  // namespace bodkin::app
