#pragma once

namespace bodkin::views {

// Differences from the previous frame, so that a view draws only what is necessary.
struct Changes {
  bool needle = false;     // moved by more than 0.05 mm or 0.05 degree, or came, or went
  bool tissue = false;     // another tissue or structure at the tip
  bool dimple = false;     // the skin moved
  bool force = false;      // there are new samples
  bool state = false;      // of the station
  bool plan = false;       // path or target
  bool crosshair = false;  // moved by more than 0.05 mm
  bool warning = false;    // came, went or changed
  bool attempt = false;    // a new attempt began: discard the curves of the last one
  bool theme = false;      // light or dark

  bool any() const noexcept {
    return needle || tissue || dimple || force || state || plan || crosshair || warning || attempt || theme;
  }
  static constexpr Changes all() noexcept { return {true, true, true, true, true, true, true, true, true, true}; }
};

}  // namespace bodkin::views
