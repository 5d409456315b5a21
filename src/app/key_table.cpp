#include "app/key_table.h"

#include <QCoreApplication>
#include <array>

namespace bodkin::app {

namespace {

// Texts are marked for translation here and translated in text_of().
#define BODKIN_TEXT_OF(text) QT_TRANSLATE_NOOP("Keys", text)

constexpr std::array table = {
    KeyBinding{KeyScope::window, "F1", Command::show_keys, BODKIN_TEXT_OF("the keys of this screen"), true},
    KeyBinding{KeyScope::window, "?", Command::show_keys, BODKIN_TEXT_OF("the keys of this screen"), true},
    KeyBinding{KeyScope::window, "Esc", Command::back, BODKIN_TEXT_OF("back, or pause"), true},
    KeyBinding{KeyScope::window, "Ctrl+O", Command::open_patient, BODKIN_TEXT_OF("open a patient"), true},
    KeyBinding{KeyScope::window, "Ctrl+S", Command::save_picture, BODKIN_TEXT_OF("save a picture of the window"),
               true},
    KeyBinding{KeyScope::window, "F6", Command::next_view, BODKIN_TEXT_OF("next view"), true},
    KeyBinding{KeyScope::window, "Shift+F6", Command::previous_view, BODKIN_TEXT_OF("previous view"), true},
    KeyBinding{KeyScope::window, "F11", Command::full_screen, BODKIN_TEXT_OF("full screen"), true},
    KeyBinding{KeyScope::window, "Ctrl+T", Command::toggle_theme, BODKIN_TEXT_OF("light or dark"), true},
    KeyBinding{KeyScope::window, "Ctrl+K", Command::show_palette, BODKIN_TEXT_OF("find a command by its name"), true},
    KeyBinding{KeyScope::window, "Ctrl+M", Command::toggle_sound, BODKIN_TEXT_OF("sound on, off"), true},
    KeyBinding{KeyScope::window, "Ctrl+Q", Command::leave_program, BODKIN_TEXT_OF("quit Bodkin"), true},
    KeyBinding{KeyScope::start, "Return", Command::begin, BODKIN_TEXT_OF("start"), false},
    KeyBinding{KeyScope::start, "T", Command::tour, BODKIN_TEXT_OF("two-minute tour"), false},
    KeyBinding{KeyScope::start, "Enter", Command::begin, BODKIN_TEXT_OF("start"), false},
    KeyBinding{KeyScope::practise, "Space", Command::hold, BODKIN_TEXT_OF("hold the needle, take it up again"), true},
    KeyBinding{KeyScope::practise, "PgDown", Command::push_in, BODKIN_TEXT_OF("push in"), true},
    KeyBinding{KeyScope::practise, "PgUp", Command::draw_out, BODKIN_TEXT_OF("draw back"), true},
    KeyBinding{KeyScope::practise, "Shift+PgDown", Command::push_in_finely, BODKIN_TEXT_OF("push in slowly"), true},
    KeyBinding{KeyScope::practise, "Shift+PgUp", Command::draw_out_finely, BODKIN_TEXT_OF("draw back slowly"), true},
    KeyBinding{KeyScope::practise, ",", Command::turn_back,
               BODKIN_TEXT_OF("turn the needle about its axis, while held"), true},
    KeyBinding{KeyScope::practise, ".", Command::turn_clockwise,
               BODKIN_TEXT_OF("turn the needle about its axis, while held"), true},
    KeyBinding{KeyScope::practise, "W", Command::withdraw, BODKIN_TEXT_OF("withdraw to above the skin"), true},
    KeyBinding{KeyScope::practise, "Shift+Space", Command::leave_needle,
               BODKIN_TEXT_OF("leave the needle in the body, and take another"), true},
    KeyBinding{KeyScope::practise, "Shift+W", Command::take_out_needle,
               BODKIN_TEXT_OF("take out the needle that was left last"), true},
    KeyBinding{KeyScope::practise, "B", Command::press_plunger,
               BODKIN_TEXT_OF("press the plunger of the syringe, while held"), true},
    KeyBinding{KeyScope::practise, "H", Command::turn_finger,
               BODKIN_TEXT_OF("feel the skin with a finger, take the needle again"), true},
    KeyBinding{KeyScope::practise, "S", Command::turn_stylet, BODKIN_TEXT_OF("stylet out, in"), true},
    KeyBinding{KeyScope::practise, "R", Command::turn_manometer, BODKIN_TEXT_OF("manometer on, off"), true},
    KeyBinding{KeyScope::practise, "Z", Command::turn_breath,
               BODKIN_TEXT_OF("ask the patient to hold the breath, or to breathe again"), true},
    KeyBinding{KeyScope::practise, "A", Command::again, BODKIN_TEXT_OF("save and try again"), true},
    KeyBinding{KeyScope::practise, "E", Command::end, BODKIN_TEXT_OF("end, and see the result"), true},
    KeyBinding{KeyScope::practise, "V", Command::arm, BODKIN_TEXT_OF("arm again after a fault"), true},
    KeyBinding{KeyScope::practise, "G", Command::move_body,
               BODKIN_TEXT_OF("turn and move the body, or stop moving it"), false},
    KeyBinding{KeyScope::practise, "Ctrl+Z", Command::undo_body, BODKIN_TEXT_OF("undo the last move of the body"),
               true},
    KeyBinding{KeyScope::practise, "Ctrl+Home", Command::reset_body,
               BODKIN_TEXT_OF("put the body back where it was at first"), true},
    KeyBinding{KeyScope::practise, "F2", Command::show_numbers, BODKIN_TEXT_OF("numbers on, off"), false},
    KeyBinding{KeyScope::practise, "F3", Command::show_ladder, BODKIN_TEXT_OF("depth ladder on, off"), false},
    KeyBinding{KeyScope::practise, "F4", Command::show_dock, BODKIN_TEXT_OF("researchers' numbers on, off"), false},
    KeyBinding{KeyScope::practise, "U", Command::toggle_ultrasound, BODKIN_TEXT_OF("ultrasound on, off"), false},
    KeyBinding{KeyScope::practise, "I", Command::toggle_volume,
               BODKIN_TEXT_OF("volume on, off: the inside of the patient"), false},
    KeyBinding{KeyScope::practise, "Return", Command::fill, BODKIN_TEXT_OF("enlarge this view, or restore it"),
               false},
    KeyBinding{KeyScope::practise, "Enter", Command::fill, BODKIN_TEXT_OF("enlarge this view, or restore it"), false},
    KeyBinding{KeyScope::plan, "Ctrl+Z", Command::of_the_page, BODKIN_TEXT_OF("undo the last change"), true},
    KeyBinding{KeyScope::plan, "Ctrl+Shift+Z", Command::of_the_page, BODKIN_TEXT_OF("do it again"), true},
    KeyBinding{KeyScope::plan, "Tab", Command::of_the_page, BODKIN_TEXT_OF("take the next proposal"), true},
    KeyBinding{KeyScope::plan, "Del", Command::of_the_page, BODKIN_TEXT_OF("remove the path"), true},
    KeyBinding{KeyScope::plan, "Return", Command::of_the_page, BODKIN_TEXT_OF("practise this path"), true},
    KeyBinding{KeyScope::plan, "Enter", Command::of_the_page, BODKIN_TEXT_OF("practise this path"), true},
    KeyBinding{KeyScope::view3d, "0", Command::of_the_view, BODKIN_TEXT_OF("the view of the procedure"), false},
    KeyBinding{KeyScope::view3d, "1", Command::of_the_view, BODKIN_TEXT_OF("from behind"), false},
    KeyBinding{KeyScope::view3d, "2", Command::of_the_view, BODKIN_TEXT_OF("from the front"), false},
    KeyBinding{KeyScope::view3d, "3", Command::of_the_view, BODKIN_TEXT_OF("from the left"), false},
    KeyBinding{KeyScope::view3d, "4", Command::of_the_view, BODKIN_TEXT_OF("from the right"), false},
    KeyBinding{KeyScope::view3d, "5", Command::of_the_view, BODKIN_TEXT_OF("from the head"), false},
    KeyBinding{KeyScope::view3d, "6", Command::of_the_view, BODKIN_TEXT_OF("from the feet"), false},
    KeyBinding{KeyScope::view3d, "P", Command::of_the_view, BODKIN_TEXT_OF("skin, cut-away, bones, see-through"),
               false},
    KeyBinding{KeyScope::view3d, "O", Command::of_the_view,
               BODKIN_TEXT_OF("organs and other parts: what is shown, opacity, colour"), false},
    KeyBinding{KeyScope::view3d, "Left", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "Right", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "Up", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "Down", Command::of_the_view, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::view3d, "+", Command::of_the_view, BODKIN_TEXT_OF("nearer"), false},
    KeyBinding{KeyScope::view3d, "-", Command::of_the_view, BODKIN_TEXT_OF("farther"), false},
    KeyBinding{KeyScope::view3d, "Y", Command::of_the_view,
               BODKIN_TEXT_OF("stereo: off, side by side, coloured glasses"), false},
    KeyBinding{KeyScope::slice, "Up", Command::of_the_view, BODKIN_TEXT_OF("next slice"), false},
    KeyBinding{KeyScope::slice, "Down", Command::of_the_view, BODKIN_TEXT_OF("previous slice"), false},
    KeyBinding{KeyScope::slice, "Home", Command::of_the_view, BODKIN_TEXT_OF("the whole procedure in the slice"),
               false},
    KeyBinding{KeyScope::slice, "[", Command::of_the_view, BODKIN_TEXT_OF("previous window"), false},
    KeyBinding{KeyScope::slice, "]", Command::of_the_view, BODKIN_TEXT_OF("next window"), false},
    KeyBinding{KeyScope::slice, "M", Command::of_the_view, BODKIN_TEXT_OF("measure a distance"), false},
    KeyBinding{KeyScope::slice, "Q", Command::of_the_view, BODKIN_TEXT_OF("measure an angle"), false},
    KeyBinding{KeyScope::slice, "X", Command::of_the_view, BODKIN_TEXT_OF("delete the measure under the pointer"),
               false},
    KeyBinding{KeyScope::slice, "C", Command::of_the_view, BODKIN_TEXT_OF("run through the slices"), false},
    KeyBinding{KeyScope::slice, "F", Command::of_the_view, BODKIN_TEXT_OF("follow the tip, or stay"), false},
    KeyBinding{KeyScope::slice, "N", Command::of_the_view, BODKIN_TEXT_OF("along the needle, on or off"), false},
    KeyBinding{KeyScope::slice, "T", Command::of_the_view, BODKIN_TEXT_OF("thickness of the slab"), false},
    KeyBinding{KeyScope::review, "Space", Command::of_the_page, BODKIN_TEXT_OF("play, pause"), true},
    KeyBinding{KeyScope::review, "Left", Command::of_the_page, BODKIN_TEXT_OF("one frame back, forward"), true},
    KeyBinding{KeyScope::review, "Right", Command::of_the_page, BODKIN_TEXT_OF("one frame back, forward"), true},
    KeyBinding{KeyScope::review, "Shift+Left", Command::of_the_page, BODKIN_TEXT_OF("previous event, next event"),
               true},
    KeyBinding{KeyScope::review, "Shift+Right", Command::of_the_page, BODKIN_TEXT_OF("previous event, next event"),
               true},
    KeyBinding{KeyScope::review, ",", Command::of_the_page, BODKIN_TEXT_OF("slower, faster"), false},
    KeyBinding{KeyScope::review, ".", Command::of_the_page, BODKIN_TEXT_OF("slower, faster"), false},
    KeyBinding{KeyScope::review, "G", Command::of_the_page, BODKIN_TEXT_OF("write the report"), false},
    KeyBinding{KeyScope::atlas, "N", Command::of_the_page, BODKIN_TEXT_OF("name a point to find"), false},
    KeyBinding{KeyScope::atlas, "A", Command::of_the_page, BODKIN_TEXT_OF("the same point again"), false},
    KeyBinding{KeyScope::atlas, "T", Command::of_the_page,
               BODKIN_TEXT_OF("touch with the device's needle, on or off"), false},
    KeyBinding{KeyScope::atlas, "0", Command::of_the_page, BODKIN_TEXT_OF("the whole body"), false},
    KeyBinding{KeyScope::scan, "S", Command::of_the_page, BODKIN_TEXT_OF("scan, stop"), false},
    KeyBinding{KeyScope::scan, "C", Command::of_the_page, BODKIN_TEXT_OF("run through the slices"), false},
    KeyBinding{KeyScope::scan, "Up", Command::of_the_view, BODKIN_TEXT_OF("next slice"), false},
    KeyBinding{KeyScope::scan, "Down", Command::of_the_view, BODKIN_TEXT_OF("previous slice"), false},
    KeyBinding{KeyScope::scan, "Home", Command::of_the_view, BODKIN_TEXT_OF("first slice"), false},
    KeyBinding{KeyScope::scan, "End", Command::of_the_view, BODKIN_TEXT_OF("last slice"), false},
    KeyBinding{KeyScope::volume, "0", Command::of_the_page, BODKIN_TEXT_OF("the view of the procedure"), false},
    KeyBinding{KeyScope::volume, "1", Command::of_the_page, BODKIN_TEXT_OF("from behind"), false},
    KeyBinding{KeyScope::volume, "2", Command::of_the_page, BODKIN_TEXT_OF("from the front"), false},
    KeyBinding{KeyScope::volume, "3", Command::of_the_page, BODKIN_TEXT_OF("from the left"), false},
    KeyBinding{KeyScope::volume, "4", Command::of_the_page, BODKIN_TEXT_OF("from the right"), false},
    KeyBinding{KeyScope::volume, "5", Command::of_the_page, BODKIN_TEXT_OF("from the head"), false},
    KeyBinding{KeyScope::volume, "6", Command::of_the_page, BODKIN_TEXT_OF("from the feet"), false},
    KeyBinding{KeyScope::volume, "M", Command::of_the_page, BODKIN_TEXT_OF("colour, grey, maximum, X-ray"), false},
    KeyBinding{KeyScope::volume, "P", Command::of_the_page, BODKIN_TEXT_OF("bone, soft tissue, skin, vessels"),
               false},
    KeyBinding{KeyScope::volume, "Left", Command::of_the_page, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::volume, "Right", Command::of_the_page, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::volume, "Up", Command::of_the_page, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::volume, "Down", Command::of_the_page, BODKIN_TEXT_OF("turn"), false},
    KeyBinding{KeyScope::volume, "+", Command::of_the_page, BODKIN_TEXT_OF("nearer"), false},
    KeyBinding{KeyScope::volume, "-", Command::of_the_page, BODKIN_TEXT_OF("farther"), false},
    KeyBinding{KeyScope::models, "Left", Command::of_the_page, BODKIN_TEXT_OF("previous step"), false},
    KeyBinding{KeyScope::models, "Right", Command::of_the_page, BODKIN_TEXT_OF("next step"), false},
    KeyBinding{KeyScope::models, "Up", Command::of_the_page, BODKIN_TEXT_OF("increase by one unit of the last digit"),
               false},
    KeyBinding{KeyScope::models, "Down", Command::of_the_page, BODKIN_TEXT_OF("decrease by one unit"), false},
    KeyBinding{KeyScope::models, "Shift+Up", Command::of_the_page, BODKIN_TEXT_OF("increase by ten units"), false},
    KeyBinding{KeyScope::models, "Shift+Down", Command::of_the_page, BODKIN_TEXT_OF("decrease by ten units"), false},
    KeyBinding{KeyScope::models, "Ctrl+Z", Command::of_the_page, BODKIN_TEXT_OF("undo"), false},
    KeyBinding{KeyScope::models, "Ctrl+Shift+Z", Command::of_the_page, BODKIN_TEXT_OF("redo"), false},
    KeyBinding{KeyScope::segment, "Ctrl+Z", Command::of_the_page, BODKIN_TEXT_OF("undo the last step"), false},
    KeyBinding{KeyScope::segment, "Ctrl+Shift+Z", Command::of_the_page, BODKIN_TEXT_OF("do it again"), false},
    KeyBinding{KeyScope::segment, "L", Command::of_the_page, BODKIN_TEXT_OF("the left button moves the crosshair"),
               false},
    KeyBinding{KeyScope::segment, "P", Command::of_the_page, BODKIN_TEXT_OF("the left button paints"), false},
    KeyBinding{KeyScope::segment, "E", Command::of_the_page, BODKIN_TEXT_OF("the left button erases"), false},
    KeyBinding{KeyScope::segment, "G", Command::of_the_page, BODKIN_TEXT_OF("a click grows a region"), false},
    KeyBinding{KeyScope::segment, "[", Command::of_the_page, BODKIN_TEXT_OF("a smaller brush"), false},
    KeyBinding{KeyScope::segment, "]", Command::of_the_page, BODKIN_TEXT_OF("a larger brush"), false},
    KeyBinding{KeyScope::segment, "V", Command::of_the_page,
               BODKIN_TEXT_OF("structures over the CT, or the CT alone"), false},
    KeyBinding{KeyScope::segment, "Up", Command::of_the_view, BODKIN_TEXT_OF("next slice"), false},
    KeyBinding{KeyScope::segment, "Down", Command::of_the_view, BODKIN_TEXT_OF("previous slice"), false},
    KeyBinding{KeyScope::training, "Return", Command::of_the_page, BODKIN_TEXT_OF("begin, or continue"), false},
    KeyBinding{KeyScope::training, "Enter", Command::of_the_page, BODKIN_TEXT_OF("begin, or continue"), false},
    KeyBinding{KeyScope::ultrasound, "I", Command::of_the_view, BODKIN_TEXT_OF("slide the probe, away"), false},
    KeyBinding{KeyScope::ultrasound, "J", Command::of_the_view, BODKIN_TEXT_OF("slide the probe, left"), false},
    KeyBinding{KeyScope::ultrasound, "K", Command::of_the_view, BODKIN_TEXT_OF("slide the probe, near"), false},
    KeyBinding{KeyScope::ultrasound, "L", Command::of_the_view, BODKIN_TEXT_OF("slide the probe, right"), false},
    KeyBinding{KeyScope::ultrasound, "Left", Command::of_the_view, BODKIN_TEXT_OF("rotate the probe"), false},
    KeyBinding{KeyScope::ultrasound, "Right", Command::of_the_view, BODKIN_TEXT_OF("rotate the probe"), false},
    KeyBinding{KeyScope::ultrasound, "Up", Command::of_the_view, BODKIN_TEXT_OF("tilt the probe"), false},
    KeyBinding{KeyScope::ultrasound, "Down", Command::of_the_view, BODKIN_TEXT_OF("tilt the probe"), false},
    KeyBinding{KeyScope::ultrasound, "Shift+Left", Command::of_the_view, BODKIN_TEXT_OF("rock the probe"), false},
    KeyBinding{KeyScope::ultrasound, "Shift+Right", Command::of_the_view, BODKIN_TEXT_OF("rock the probe"), false},
    KeyBinding{KeyScope::ultrasound, "D", Command::of_the_view, BODKIN_TEXT_OF("depth; with Shift less"), false},
    KeyBinding{KeyScope::ultrasound, "G", Command::of_the_view, BODKIN_TEXT_OF("gain; with Shift less"), false},
    KeyBinding{KeyScope::ultrasound, "R", Command::of_the_view, BODKIN_TEXT_OF("dynamic range; with Shift less"),
               false},
    KeyBinding{KeyScope::ultrasound, "O", Command::of_the_view, BODKIN_TEXT_OF("focus; with Shift nearer"), false},
    KeyBinding{KeyScope::ultrasound, "Q", Command::of_the_view, BODKIN_TEXT_OF("frequency; with Shift lower"), false},
    KeyBinding{KeyScope::ultrasound, "T", Command::of_the_view,
               BODKIN_TEXT_OF("sliders of the time-gain compensation; 1 to 8 move them, 0 sets all to the middle"),
               false},
    KeyBinding{KeyScope::ultrasound, "F", Command::of_the_view, BODKIN_TEXT_OF("freeze"), false},
    KeyBinding{KeyScope::ultrasound, "Space", Command::of_the_view, BODKIN_TEXT_OF("freeze"), false},
    KeyBinding{KeyScope::ultrasound, "C", Command::of_the_view, BODKIN_TEXT_OF("calipers: two clicks each"), false},
    KeyBinding{KeyScope::ultrasound, "M", Command::of_the_view, BODKIN_TEXT_OF("mark the place under the pointer"),
               false},
    KeyBinding{KeyScope::ultrasound, "X", Command::of_the_view, BODKIN_TEXT_OF("clear calipers and marks"), false},
    KeyBinding{KeyScope::ultrasound, "N", Command::of_the_view, BODKIN_TEXT_OF("needle in or out of the patient"),
               false},
    KeyBinding{KeyScope::ultrasound, "PgDown", Command::of_the_view, BODKIN_TEXT_OF("needle deeper"), false},
    KeyBinding{KeyScope::ultrasound, "PgUp", Command::of_the_view, BODKIN_TEXT_OF("needle shallower"), false},
    KeyBinding{KeyScope::ultrasound, "S", Command::of_the_view, BODKIN_TEXT_OF("save the picture"), false},
    KeyBinding{KeyScope::ultrasound, "H", Command::of_the_view, BODKIN_TEXT_OF("show these keys in the image"),
               false},
    KeyBinding{KeyScope::camera, "Space", Command::of_the_page, BODKIN_TEXT_OF("start, pause, continue"), false},
    KeyBinding{KeyScope::camera, "R", Command::of_the_page,
               BODKIN_TEXT_OF("record a session with the tracked needle, end it"), false},
    KeyBinding{KeyScope::camera, "P", Command::of_the_page, BODKIN_TEXT_OF("bone, soft tissue, skin, vessels"),
               false},
    KeyBinding{KeyScope::camera, "+", Command::of_the_page, BODKIN_TEXT_OF("a larger view into the mannequin"),
               false},
    KeyBinding{KeyScope::camera, "-", Command::of_the_page, BODKIN_TEXT_OF("a smaller one"), false},
};

constexpr std::array window_chain = {KeyScope::window};
constexpr std::array start_chain = {KeyScope::start, KeyScope::window};
constexpr std::array practise_chain = {KeyScope::practise, KeyScope::window};
constexpr std::array view3d_chain = {KeyScope::view3d, KeyScope::practise, KeyScope::window};
constexpr std::array slice_chain = {KeyScope::slice, KeyScope::practise, KeyScope::window};
constexpr std::array chart_chain = {KeyScope::chart, KeyScope::practise, KeyScope::window};
constexpr std::array plan_chain = {KeyScope::plan, KeyScope::window};
constexpr std::array scan_chain = {KeyScope::scan, KeyScope::window};
constexpr std::array review_chain = {KeyScope::review, KeyScope::window};
constexpr std::array models_chain = {KeyScope::models, KeyScope::window};
constexpr std::array devices_chain = {KeyScope::devices, KeyScope::window};
constexpr std::array atlas_chain = {KeyScope::atlas, KeyScope::window};
constexpr std::array volume_chain = {KeyScope::volume, KeyScope::window};
constexpr std::array segment_chain = {KeyScope::segment, KeyScope::window};
constexpr std::array training_chain = {KeyScope::training, KeyScope::window};
constexpr std::array camera_chain = {KeyScope::camera, KeyScope::window};
constexpr std::array ultrasound_chain = {KeyScope::ultrasound, KeyScope::window};

const KeyBinding* find(KeyScope scope, const QKeySequence& keys) {
  for (const KeyBinding& binding : table) {
    if (binding.scope == scope && keys.matches(QKeySequence(QLatin1String(binding.keys))) == QKeySequence::ExactMatch)
      return &binding;
  }
  return nullptr;
}

}  // namespace

std::span<const KeyBinding> key_table() noexcept {
  return table;
}

std::span<const KeyScope> chain_of(KeyScope scope) noexcept {
  switch (scope) {
    case KeyScope::start:
      return start_chain;
    case KeyScope::practise:
      return practise_chain;
    case KeyScope::view3d:
      return view3d_chain;
    case KeyScope::slice:
      return slice_chain;
    case KeyScope::chart:
      return chart_chain;
    case KeyScope::plan:
      return plan_chain;
    case KeyScope::scan:
      return scan_chain;
    case KeyScope::review:
      return review_chain;
    case KeyScope::models:
      return models_chain;
    case KeyScope::devices:
      return devices_chain;
    case KeyScope::atlas:
      return atlas_chain;
    case KeyScope::volume:
      return volume_chain;
    case KeyScope::ultrasound:
      return ultrasound_chain;
    case KeyScope::segment:
      return segment_chain;
    case KeyScope::training:
      return training_chain;
    case KeyScope::camera:
      return camera_chain;
    case KeyScope::window:
      break;
  }
  return window_chain;
}

std::optional<Command> command_of(KeyScope scope, const QKeySequence& keys) {
  const KeyBinding* const binding = find(scope, keys);
  if (binding == nullptr) return std::nullopt;
  return binding->command;
}

std::optional<Command> reserved_command(KeyScope page, const QKeySequence& keys) {
  for (const KeyScope scope : {page, KeyScope::window}) {
    if (const KeyBinding* const binding = find(scope, keys); binding != nullptr && binding->reserved)
      return binding->command;
  }
  return std::nullopt;
}

QString text_of(const KeyBinding& binding) {
  return QCoreApplication::translate("Keys", binding.text);
}

QString name_of(KeyScope scope) {
  switch (scope) {
    case KeyScope::window:
      return QCoreApplication::translate("Keys", "Everywhere");
    case KeyScope::start:
      return QCoreApplication::translate("Keys", "Start");
    case KeyScope::practise:
      return QCoreApplication::translate("Keys", "Needle");
    case KeyScope::view3d:
      return QCoreApplication::translate("Keys", "Patient in 3-D");
    case KeyScope::slice:
      return QCoreApplication::translate("Keys", "Slices");
    case KeyScope::chart:
      return QCoreApplication::translate("Keys", "Chart");
    case KeyScope::plan:
      return QCoreApplication::translate("Keys", "Plan");
    case KeyScope::scan:
      return QCoreApplication::translate("Keys", "Scanner");
    case KeyScope::review:
      return QCoreApplication::translate("Keys", "Review");
    case KeyScope::models:
      return QCoreApplication::translate("Keys", "Model settings");
    case KeyScope::devices:
      return QCoreApplication::translate("Keys", "Devices");
    case KeyScope::atlas:
      return QCoreApplication::translate("Keys", "Atlas");
    case KeyScope::volume:
      return QCoreApplication::translate("Keys", "Volume");
    case KeyScope::ultrasound:
      return QCoreApplication::translate("Keys", "Ultrasound");
    case KeyScope::segment:
      return QCoreApplication::translate("Keys", "Structures");
    case KeyScope::training:
      return QCoreApplication::translate("Keys", "Training plan");
    case KeyScope::camera:
      return QCoreApplication::translate("Keys", "Augmented reality");
  }
  return {};
}

}  // namespace bodkin::app
