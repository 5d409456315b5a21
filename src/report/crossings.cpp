#include "report/crossings.h"

#include <algorithm>

#include <fmt/format.h>

namespace bodkin::report {

namespace {

// The largest resistance of a crossing. A rise until the next tissue gives way belongs to that tissue, so it counts
// only when it is over; and a fall after a tissue has given way still belongs to that tissue.
class PeakOfCrossing {
 public:
  static constexpr int ticks_to_fall = 4;  // after a tissue has given way

  void see(const simulation::TickOutput& output, TissueCrossing& crossing) {
    if (to_fall_ > 0 || (falls_ && output.resistance < last_)) {
      to_fall_ = output.resistance < last_ ? 0 : to_fall_ - 1;
      last_ = output.resistance;
      return;
    }
    falls_ = false;
    if (output.resistance < last_) settle(crossing);
    last_ = output.resistance;
    if (output.resistance > rise_) {
      rise_ = output.resistance;
      rise_depth_ = output.depth;
    }
  }
  void settle(TissueCrossing& crossing) {
    if (rise_ > crossing.peak_force) {
      crossing.peak_force = rise_;
      crossing.peak_depth = rise_depth_;
    }
    rise_ = 0.0;
  }
  // The rise, minus `others` N, belongs to a tissue that gave way.
  void leave(double others) { rise_ = std::min(rise_, std::max(0.0, others)); }
  void begin() {
    rise_ = 0.0;
    if (!falls_) last_ = 0.0;
  }
  // A tissue has given way at `felt` N.
  void begin_to_fall(double felt) {
    rise_ = 0.0;
    last_ = felt;
    falls_ = true;
    to_fall_ = ticks_to_fall;
  }

 private:
  double rise_ = 0.0, rise_depth_ = 0.0, last_ = 0.0;
  bool falls_ = false;
  int to_fall_ = 0;  // ticks left in which the fall may begin
};

}  // namespace

std::vector<TissueCrossing> tissues_crossed(std::span<const simulation::TickRecord> ticks, double dt) {
  std::vector<TissueCrossing> crossings;
  PeakOfCrossing peak;
  double deepest = 0.0;
  for (const simulation::TickRecord& record : ticks) {
    const simulation::TickOutput& output = record.output;
    if (!output.in_contact || output.depth < deepest || output.tissue == anatomy::tissue::air) continue;
    const double advance = output.depth - deepest;
    if (crossings.empty()) crossings.push_back({output.tissue, 0.0, output.depth, 0.0, output.depth, 0.0});
    for (const forces::Event& event : output.events) {
      // By the force at the hand then, the tip was before the tissue until now, and the previous force was its own.
      if (event.kind != forces::EventKind::puncture || event.felt == 0.0) continue;
      if (crossings.back().tissue != event.tissue) {
        peak.leave(event.felt - event.value);
        peak.settle(crossings.back());
        crossings.back().to = deepest;
        crossings.push_back({event.tissue, deepest, output.depth, 0.0, output.depth, 0.0});
      }
      crossings.back().peak_force = std::max(crossings.back().peak_force, event.felt);
      crossings.back().peak_depth = output.depth;
      peak.begin_to_fall(std::max(event.felt, output.resistance));
    }
    if (crossings.back().tissue != output.tissue) {
      // The face lies between the last tick in the old tissue and this one.
      const double face = deepest + 0.5 * advance;
      peak.settle(crossings.back());
      peak.begin();
      crossings.back().to = face;
      crossings.push_back({output.tissue, face, output.depth, 0.0, output.depth, 0.0});
    }
    TissueCrossing& here = crossings.back();
    here.to = output.depth;
    here.time += dt;
    peak.see(output, here);
    deepest = output.depth;
  }
  if (!crossings.empty()) peak.settle(crossings.back());
  return crossings;
}

std::vector<Insertion> insertions(std::span<const simulation::TickRecord> ticks) {
  std::vector<Insertion> found;
  bool inside = false;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const simulation::TickOutput& output = ticks[i].output;
    if (output.in_contact && !inside) found.push_back({i, i, 0.0});
    inside = output.in_contact;
    if (!inside) continue;
    found.back().last = i;
    found.back().deepest = std::max(found.back().deepest, output.depth);
  }
  return found;
}

std::string event_text(const forces::Event& event, const anatomy::TissueLibrary& library) {
  const std::string title = library.title(event.tissue);
  switch (event.kind) {
    case forces::EventKind::contact:
      return "the tip touches the body";
    case forces::EventKind::puncture:
      if (event.felt > event.value + 0.005)
        return fmt::format("{} gives way at {:.2f} N, of which {:.2f} N are its own", title, event.felt, event.value);
      return fmt::format("{} gives way at {:.2f} N", title, event.value);
    case forces::EventKind::loss_of_resistance:
      return fmt::format("loss of resistance, the force falls by {:.2f} N", event.value);
    case forces::EventKind::bone_contact:
      return fmt::format("the tip meets bone ({})", title);
    case forces::EventKind::bone_left:
      return "the tip comes off the bone";
    case forces::EventKind::tissue_entered:
      return fmt::format("the tip enters {}", title);
    case forces::EventKind::withdrawn:
      return "the needle has left the body";
    case forces::EventKind::force_limited:
      return fmt::format("force limited, {:.1f} N were asked for", event.value);
    case forces::EventKind::points_passed:
      return "the needle is past the contact points of its line";
    case forces::EventKind::line_taken:
      return "the needle enters on another line than before";
    case forces::EventKind::moving_body_met:
      return "the needle is in tissue that the probe has moved";
    case forces::EventKind::moving_body_failed:
      return "the moving body failed: the probe lost its force, the needle finds the body at rest";
    case forces::EventKind::fluid_returned:
      return fmt::format("fluid comes back through the needle, {:.2f} mm^3/s", event.value);
    case forces::EventKind::pressure_lost:
      return fmt::format("the plunger gives way, the pressure falls by {:.0f} kPa", 1000.0 * event.value);
    case forces::EventKind::hub_contact:
      return "the hub meets the skin: the needle is inserted to its full length";
    case forces::EventKind::needle_buckled:
      return fmt::format("the needle buckles at {:.2f} N, its tip stays", event.value);
    case forces::EventKind::points_taken:
      return "contact points of the needle's line are computed";
    case forces::EventKind::points_coupled:
      return "the needle's contact points are coupled with the nodes that the probe holds now";
    case forces::EventKind::points_late:
      return fmt::format("the tip is {:.1f} mm past a contact point that is still being computed", event.value);
    case forces::EventKind::palpated:
      return fmt::format("a place on the skin is felt{}, stiffness {:.2f} N/mm",
                         event.tissue == anatomy::tissue::skin ? "" : " with bone under it", event.value);
    case forces::EventKind::stylet_out:
      return "the stylet is taken out";
    case forces::EventKind::stylet_in:
      return "the stylet is put back";
    case forces::EventKind::manometer_on:
      return "the manometer is connected";
    case forces::EventKind::manometer_off:
      return fmt::format("the manometer is taken off at {:.1f} cm", 0.1 * event.value);
    case forces::EventKind::pressure_read:
      return fmt::format("the manometer shows {:.1f} cm of fluid", 0.1 * event.value);
    case forces::EventKind::fluid_collected:
      return fmt::format("{:.1f} mL of fluid are collected", 0.001 * event.value);
    case forces::EventKind::hand_lost:
      return "the needle is not seen any more, it rests where it was";
    case forces::EventKind::hand_seen:
      return fmt::format("the needle is seen again, after {:.2f} s", event.value);
    case forces::EventKind::fault:
      break;
  }
  return "fault: the force was ramped to zero";
}

bool is_notable(forces::EventKind kind) {
  return kind == forces::EventKind::puncture || kind == forces::EventKind::loss_of_resistance ||
         kind == forces::EventKind::bone_contact || kind == forces::EventKind::force_limited ||
         kind == forces::EventKind::fault || kind == forces::EventKind::points_passed ||
         kind == forces::EventKind::line_taken || kind == forces::EventKind::moving_body_met ||
         kind == forces::EventKind::moving_body_failed || kind == forces::EventKind::fluid_returned ||
         kind == forces::EventKind::hub_contact || kind == forces::EventKind::needle_buckled ||
         kind == forces::EventKind::pressure_lost || kind == forces::EventKind::points_late ||
         kind == forces::EventKind::palpated || kind == forces::EventKind::pressure_read ||
         kind == forces::EventKind::hand_seen;
}

std::vector<PlotBand> bands_of(std::span<const TissueCrossing> crossings, const anatomy::TissueLibrary& library) {
  std::vector<PlotBand> bands;
  for (const TissueCrossing& crossing : crossings) {
    const anatomy::TissueProperties* properties = library.find(crossing.tissue);
    bands.push_back({crossing.from, crossing.to, properties != nullptr ? properties->colour : 0x808080U,
                     library.title(crossing.tissue)});
  }
  return bands;
}

}  // namespace bodkin::report
