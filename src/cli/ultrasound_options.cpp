#include "cli/ultrasound_options.h"

namespace bodkin::cli {

void add_ultrasound_options(CLI::App& command, UltrasoundOptions& options) {
  add_text(command, "--probe", options.wanted.probe, "Name of the probe");
  add_text(command, "--probes", options.wanted.probes, "A file of probes (default: those that come with Bodkin)");
  add_text(command, "--view", options.wanted.view,
           "How it is put on the skin: " + imaging::scan_view_names() + " (default: paramedian)");
  add_text(command, "--at", options.wanted.at,
           "What it looks at: x,y,z in LPS mm, a landmark or a structure (default: the planned target)");
  add_text(command, "--from", options.wanted.from, "The side that it looks from: back, front, left, right");
  add_text(command, "--face", options.wanted.face, "The middle of its face, x,y,z in LPS mm, instead of a view");
  add_text(command, "--look", options.wanted.look, "Direction into the patient, x,y,z");
  add_text(command, "--marked", options.wanted.marked,
           "Direction of its marked side, x,y,z (default: 0,0,1, the head)");
  add_text(command, "--pose", options.wanted.pose,
           "12 or 16 numbers row by row, probe to LPS mm, instead of the options above");
  options.press_given = add_number(command, "--press", options.press, -60.0, 40.0,
                                   "mm that it is pressed in, -60 to 40 (default: 3, or 0 with --face or --pose)")
                            .without_default();
  options.depth_given =
      add_number(command, "--depth", options.depth, 10.0, 400.0, "mm shown, 10 to 400 (default: the probe's)")
          .without_default();
  add_number(command, "--gain", options.wanted.gain, -40.0, 40.0, "dB, -40 to 40");
  add_number(command, "--dynamic-range", options.wanted.dynamic_range, 20.0, 120.0,
             "dB from black to white, 20 to 120");
  options.focus_given =
      add_number(command, "--focus", options.focus, 5.0, 400.0, "mm, 5 to 400 (default: half the depth)")
          .without_default();
  options.frequency_given = add_number(command, "--frequency", options.frequency, 1.0, 30.0,
                                       "MHz in the probe's band (default: its centre)")
                                .without_default();
  add_text(command, "--tgc", options.wanted.tgc,
           "The eight sliders of the time-gain compensation, dB: a,b,c,d,e,f,g,h");
  add_switch(command, "--no-gel", options.wanted.no_gel, "Nothing fills the gaps between face and skin");
  add_whole_number(command, "--lines", options.wanted.lines, 16, 2048, "Scanlines, 16 to 2048");
  add_whole_number(command, "--samples", options.wanted.samples, 32, 4096, "Samples along a line, 32 to 4096");
  options.size_given = add_text(command, "--size", options.wanted.size, "Pixels of the picture, WIDTHxHEIGHT");
  add_whole_number(command, "--slices", options.wanted.slices, 1, 7,
                   "Rays across the thickness of the slice: 1, 3, 5 or 7");
  add_whole_number(command, "--threads", options.wanted.threads, 1, 64, "Threads, 1 to 64");
  add_text(command, "--mark", options.wanted.mark, "Where the marked side stands in the picture: left, right");
  add_switch(command, "--needle", options.wanted.needle, "The case's needle along the planned path");
  options.needle_depth_given = add_number(command, "--needle-depth", options.needle_depth, 0.0, 300.0,
                                          "mm from the entry to its tip, 0 to 300 (default: to the target)")
                                   .without_default();
}

station::UltrasoundRequest request_of(const UltrasoundOptions& options) {
  const auto number = [](const Argument& argument, double value) {
    return argument.given() ? std::optional(value) : std::nullopt;
  };
  station::UltrasoundRequest request = options.wanted;
  request.press = number(options.press_given, options.press);
  request.depth = number(options.depth_given, options.depth);
  request.focus = number(options.focus_given, options.focus);
  request.frequency = number(options.frequency_given, options.frequency);
  request.needle_depth = number(options.needle_depth_given, options.needle_depth);
  return request;
}

}  // namespace bodkin::cli
