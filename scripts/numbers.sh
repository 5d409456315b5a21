#!/usr/bin/env bash
# Measures Bodkin's speed and writes docs/numbers.md: runs the programs of bench/ (preset release, built when out of
# date) one after the other and tabulates their results. Run it on an otherwise idle machine; it takes about five
# minutes on 2 cores. With BODKIN_LARGE_BODIES=1 bodies of 100,000 nodes are measured too (an hour).
#
#   scripts/numbers.sh             build, measure, write the page
#   scripts/numbers.sh --print     write the page again from the last measurement (build/numbers)
source "$(dirname "$0")/setup.sh"

programs=(tick_bench models_bench servo_bench haply_bench run_bench fem_tick_bench fem_body_bench fem_preparation_bench
          patient_stream_bench corotational_bench ultrasound_bench case_load_bench scene_bench
          training_bench training_store_bench)
results=build/numbers

if [ "${1:-}" != --print ]; then
  build_preset release "${programs[@]}" bodkin bodkin-mesher
  rm -rf "$results" && mkdir -p "$results"
  # Patients for patient_stream_bench.
  for nodes in 20000 ${BODKIN_LARGE_BODIES:+100000}; do
    build/release/bin/bodkin --quiet case synthesize lumbar "$results/lumbar_$nodes" >&2
    build/release/bin/bodkin --quiet case mesh "$results/lumbar_$nodes" --nodes "$nodes" >&2
    BODKIN_MESHED_PATIENTS="${BODKIN_MESHED_PATIENTS:+$BODKIN_MESHED_PATIENTS:}$results/lumbar_$nodes"
  done
  export BODKIN_MESHED_PATIENTS
  for program in "${programs[@]}"; do
    say "$program"
    "build/release/bench/$program" --benchmark_out="$results/$program.json" --benchmark_out_format=json >&2
  done
  {
    date -u +%Y-%m-%d
    git describe --always --dirty --exclude '*'
    sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -1
    nproc
    "$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' build/release/CMakeCache.txt)" --version | head -1
    cut -d' ' -f1-3 /proc/loadavg
  } > "$results/machine"
fi
[ -s "$results/machine" ] || { say "no measurement in $results; run scripts/numbers.sh without --print"; exit 2; }

# PROGRAM:BENCHMARK TEXT: the name of a row. A benchmark without a line here keeps its own name; one whose text is "-"
# is omitted.
names() {
  cat << 'NAMES'
tick_bench:lumbar_single_tick tick on the synthetic lumbar patient, `layered`, tissue look-up and clock included
tick_bench:lumbar_batch tick on the synthetic lumbar patient, without reading the clock
tick_bench:described_lumbar_single_tick tick on the same patient with forces that follow from the needle, clock included
tick_bench:described_lumbar_batch tick with forces that follow from the needle, without reading the clock
tick_bench:slabs_single_tick tick through 17 layers of skin, fat and muscle, clock included
tick_bench:slabs_batch tick through 17 layers, without reading the clock
models_bench:all_models_together one tick of all models together
models_bench:volume_proxy_with_rail `volume_proxy` with `rail`
models_bench:surface_proxy `surface_proxy`
models_bench:surface_proxy_stroking `surface_proxy`, stroking the skin
servo_bench:servo_single_tick servo, governor and guard around a spring, clock included
servo_bench:servo_batch servo, governor and guard around a spring, without reading the clock
servo_bench:guard_alone guard alone
servo_bench:newest_value `LatestValue`, one write and one read
haply_bench:json_of_one_round Haply driver: JSON in and out of one exchange
run_bench:expert_without_recording a whole procedure by the simulated expert
run_bench:expert_recorded the same, recorded
fem_tick_bench:machine_itself a fixed sum of about 6 us: what the machine adds
fem_tick_bench:factor_tick constraint factor: solve and update, k constraints
fem_tick_bench:needle_tick needle in the deformable body, k contact points
fem_tick_bench:relaxing_tick the same in tissue that relaxes, k contact points
fem_tick_bench:changeover_tick the slowest tick while k contact points go over to another compliance
fem_tick_bench:display_field displacement field for the display, k contact nodes
fem_body_bench:machine_itself -
fem_body_bench:prepare mesh to condensed body, nodes along an edge (0: fine near an oblique path)
fem_body_bench:prepare_from_cache condensed body read from its file, nodes along an edge
fem_body_bench:display_field displacement field for the display
fem_preparation_bench:prepare preparation, nodes along an edge,
fem_preparation_bench:only_check check of the mesh, nodes along an edge
fem_preparation_bench:only_plan order of elimination, nodes along an edge
fem_preparation_bench:only_factorise factorisation and condensation, nodes along an edge
fem_preparation_bench:field_of_corridor displacement of all nodes, nodes along an edge
fem_preparation_bench:contact_body a body that a needle can enter anywhere, nodes along an edge
patient_stream_bench:enter_patient contact points of a line, on one core, synthetic patient
corotational_bench:step one step, nodes along an edge
ultrasound_bench:paper feature set of Sutherland et al. 2013, 300 x 300, one thread
ultrasound_bench:everything everything, 300 x 300, threads
ultrasound_bench:everything_displaced the same with displaced tissue and a needle, threads
ultrasound_bench:thin_slice everything, one ray through the slice, threads
ultrasound_bench:large everything, 820 x 616, threads
ultrasound_bench:on_path everything, 300 x 300, one thread, processor path
case_load_bench:whole_case case.xml, tissue library and all volumes, digests verified
case_load_bench:description_alone case.xml and tissue library
case_load_bench:ct_alone the CT, decompressed
case_load_bench:structures_alone the labels, decompressed
case_load_bench:tissues_alone the tissues, decompressed
case_load_bench:digest_of_the_ct digest of the CT
scene_bench:needle_moves a needle that moves, pixels
scene_bench:skin_dimples a needle and the skin that it dents, pixels
scene_bench:camera_turns another camera, pixels, samples along a side of each
scene_bench:surfaces_are_made surfaces of the lumbar torso, all cores
training_bench:score_ten_minutes a session of ten minutes judged, already in memory
training_bench:simulated_lumbar_puncture a lumbar puncture by the simulated expert, performed and judged, one thread
training_store_bench:cohort_table_of_100000_attempts table of 1000 trainees at 2 procedures, 100 000 attempts, from SQLite
NAMES
}

page() {
  local date commit processor cores compiler load
  { read -r date; read -r commit; read -r processor; read -r cores; read -r compiler; read -r load; } < "$results/machine"
  cat << PAGE
# Measured numbers

Written by \`scripts/numbers.sh\`; do not edit. Every other page links to this one instead of stating times.

- Date: $date; commit: \`$commit\`
- Machine: $processor, $cores cores; load average at the end: $load
- Compiler: $compiler, preset \`release\`

Times are of single calls: median, and the values that 99 % and 99.9 % of the calls stay below. A mean is given where a call is
too short to be timed alone. One tick may take 1000 us at 1 kHz.
PAGE
  local program
  for program in "${programs[@]}"; do
    [ -s "$results/$program.json" ] && printf '\n## %s\n\n' "$(heading "$program")" && note "$program" && table "$program"
  done
}

heading() {
  case "$1" in
    tick_bench) echo "Haptic tick" ;;
    models_bench) echo "Force models alone" ;;
    servo_bench) echo "Servo and guard" ;;
    haply_bench) echo "Drivers" ;;
    run_bench) echo "Whole procedures" ;;
    fem_tick_bench) echo "Needle in a deformable body" ;;
    fem_body_bench) echo "Deformable body: preparation and display by size" ;;
    fem_preparation_bench) echo "Deformable body: the steps of its preparation" ;;
    patient_stream_bench) echo "Deformable body: a needle enters the patient anywhere" ;;
    corotational_bench) echo "Moving body: one step" ;;
    ultrasound_bench) echo "Ultrasound: one image" ;;
    case_load_bench) echo "Opening a case: the lumbar torso of 1 mm" ;;
    scene_bench) echo "The patient in 3-D: one frame" ;;
    training_bench) echo "Training: scores" ;;
    training_store_bench) echo "Training: the table of a cohort" ;;
  esac
}

note() {
  case "$1" in
    fem_tick_bench) cat << 'NOTE'
k contact points; the needle moves in and out at 25 mm/s and meets a node every 20 ticks, friction reverses
every 200. Hand 1 sways by 3 mm at 2 Hz and trembles by 0.2 mm at 10 Hz, hand 2 moves at 125 mm/s, hand 3 at 500 mm/s. *Of the tick
itself*: the p99.9 over the ticks of the motion of each tick's median over its repetitions, so without the machine's interrupts.

NOTE
      ;;
    fem_body_bench | fem_preparation_bench) cat << 'NOTE'
Boxes of 100 mm with a slab of ligament, condensed to 1,000 nodes.

NOTE
      ;;
    patient_stream_bench) cat << 'NOTE'
40 lines that nobody planned, through the skin within 25 mm of the planned entry and up to 40 degrees from the planned direction,
as deep as the planned path and 15 mm more. Points are late when a needle that comes at 50 mm/s and asked 50 mm before the skin is there first.

NOTE
      ;;
    corotational_bench) cat << 'NOTE'
A box of 100 mm, pressed by 15 mm and released once a second by a face of 40 x 15 mm, 60 steps a second.

NOTE
      ;;
    ultrasound_bench) cat << 'NOTE'
The synthetic lumbar torso, C5-2, 100 mm deep, the probe moving.

NOTE
      ;;
  esac
}

# table PROGRAM: one row a benchmark, from the JSON of Google Benchmark (one key a line).
table() {
  printf '| `%s` | median or mean | p99 | p99.9 | also |\n|---|---|---|---|---|\n' "$1"
  names | awk -v program="$1" '
    function nanoseconds(value, unit) {
      return value * (unit == "ns" ? 1 : unit == "us" ? 1e3 : unit == "ms" ? 1e6 : 1e9)
    }
    # Three digits, and the unit that puts them between 1 and 1000.
    function shown(ns,    unit, value) {
      if (ns == "") return ""
      unit = "ns"; value = ns
      if (value >= 999.5) { value /= 1e3; unit = "us" }
      if (value >= 999.5) { value /= 1e3; unit = "ms" }
      if (value >= 999.5) { value /= 1e3; unit = "s" }
      return sprintf(value < 9.995 ? "%.2f %s" : value < 99.95 ? "%.1f %s" : "%.0f %s", value, unit)
    }
    function row(    base, parts, n, i, text, also, middle, p99, p999, key, unit, value) {
      if (name == "" || failed) return
      n = split(name, parts, "/")
      base = parts[1]
      text = (program ":" base) in texts ? texts[program ":" base] : known(base)
      if (text == "-") return
      for (i = 2; i <= n; ++i) if (parts[i] !~ /^(iterations|manual_time|real_time|process_time|repeats)/) {
        text = text (sub(/:/, " ", parts[i]) ? ", " : " ") parts[i]
      }
      for (i = 1; i <= keys; ++i) {
        key = order[i]; value = values[key]; unit = key
        sub(/.*_/, "", unit)
        if (key ~ /^(median|p50)_(ns|us|ms)$/) middle = nanoseconds(value, unit)
        else if (key ~ /^p99_(ns|us|ms)$/) p99 = nanoseconds(value, unit)
        else if (key ~ /^p99\.9_(ns|us|ms)$/) p999 = nanoseconds(value, unit)
        else if (key == "per_tick") { if (middle == "") middle = nanoseconds(value, "s") }
        else if (key ~ /^(real_time|cpu_time|iterations|threads|repetitions|repetition_index|family_index)$/) continue
        else if (key ~ /^(per_family_instance_index|max_|min_|times$)/) continue
        else also = also (also == "" ? "" : "; ") label(key) " " number(key, value)
      }
      if (label_text != "") text = text " (" label_text ")"
      if (middle == "") middle = nanoseconds(values["real_time"], time_unit)
      printf "| %s | %s | %s | %s | %s |\n", text, shown(middle), shown(p99), shown(p999), also
    }
    function known(base) {
      if (program == "models_bench") return "`" base "`"
      gsub(/_/, " ", base)
      return base
    }
    function label(key) {
      sub(/^tick_/, "of the tick itself, ", key)
      sub(/_(us|ms|s|MB|N)$/, "", key)
      gsub(/_/, " ", key)
      return key
    }
    function number(key, value) {
      if (key ~ /_(us|ms|s)$/) { sub(/.*_/, "", key); return shown(nanoseconds(value, key)) }
      if (key == "flops") return sprintf("%.1f Gflop/s", value / 1e9)
      if (key ~ /_MB$/) return sprintf("%.0f MB", value)
      return value == int(value) || value >= 1000 ? sprintf("%.0f", value) : sprintf("%.3g", value)
    }
    FILENAME == "-" {
      key = $1
      sub(/^[^ ]+ /, "")
      texts[key] = $0
      next
    }
    /^    \{/ { name = ""; label_text = ""; keys = 0; failed = 0; delete values }
    /"error_occurred": true/ { failed = 1 }
    match($0, /^      "[^"]+": /) {
      key = substr($0, 8, RLENGTH - 10)
      value = substr($0, RLENGTH + 1)
      sub(/,$/, "", value)
      if (value ~ /^"/) value = substr(value, 2, length(value) - 2)
      if (key == "name") name = value
      else if (key == "time_unit") time_unit = value
      else if (key == "label") label_text = value
      else if (value ~ /^[-+0-9.eE]+$/) { values[key] = value + 0; order[++keys] = key }
    }
    /^    \}/ { row() }
  ' - "$results/$1.json"
}

page > docs/numbers.md
say "docs/numbers.md is written"
