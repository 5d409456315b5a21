#!/usr/bin/env bash
# Measures the duration of scoring, reports, simulated cohorts and the table of results, and states each requirement
# (docs/training.md, "How long it takes"). Run it on an otherwise idle machine; it takes about three minutes on 2
# cores, without building.
#
#   scripts/training_speed.sh [FOLDER]     with the programs in build/release; FOLDER (default: a temporary one) keeps the files
source "$(dirname "$0")/setup.sh"

bodkin="$root/build/release/bin/bodkin"
[ -x "$bodkin" ] || { say "build/release has no bodkin; ./run builds it"; exit 2; }
folder=${1:-$(mktemp -d)}
mkdir -p "$folder"
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 XDG_DATA_HOME="$folder/data"

calculate() { awk "BEGIN { printf \"%.3f\", $1 }"; }

# seconds COMMAND...: wall-clock time in s.
seconds() {
  local begin end
  begin=$(date +%s.%N)
  # 3: the attempt failed, as an attempt of ten minutes does by its time in the body.
  "$@" > command.log 2>&1 || [ $? -eq 3 ] || { cat command.log >&2; exit 1; }
  end=$(date +%s.%N)
  calculate "$end - $begin"
}

# row WHAT VALUE ASKED
row() { printf '| %-62s | %10s | %-16s |\n' "$1" "$2" "$3"; }

say "a patient, and a session of ten minutes"
[ -d patient ] || "$bodkin" -q case synthesize lumbar patient > command.log
sed 's|<until time_s="2" then="withdraw"/>|<until time_s="576" then="withdraw"/>|' \
  "$root/share/bodkin/operators/expert.xml" > patient_expert.xml
"$bodkin" -q run patient --operator patient_expert.xml --max-time 700 -o ten.bodkin --overwrite > command.log
cat > plan.xml << 'PLAN'
<plan version="1" name="speed" title="Speed"><stage title="Lumbar puncture" case="patient" attempts="1"/></plan>
PLAN

row "what" "measured" "asked"
row "---" "---" "---"
seconds "$bodkin" -q score ten.bodkin --csv ten.csv > /dev/null
row "session of ten minutes, s" \
  "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "duration_s") column = i } NR == 2 { print $column }' ten.csv)" \
  "about 600"
for attempt in 1 2 3; do row "score of it, run $attempt, s" "$(seconds "$bodkin" -q score ten.bodkin)" "under 1"; done
for attempt in 1 2 3; do row "report of it, run $attempt, s" "$(seconds "$bodkin" -q report ten.bodkin)" "under 3"; done
rm -f all.csv all.csv.partial* one.csv* two.csv*
row "1000 lumbar punctures on all $(nproc) cores, s" \
  "$(seconds "$bodkin" -q cohort plan.xml --trainees 1000 --seed 7 -o all.csv)" "under 120 on 2"
one=$(seconds mpirun -n 1 "$bodkin" -q cohort plan.xml --trainees 1000 --seed 7 -o one.csv)
two=$(seconds mpirun -n 2 "$bodkin" -q cohort plan.xml --trainees 1000 --seed 7 -o two.csv)
row "the same with one rank, s" "$one" ""
row "the same with two ranks, s" "$two" ""
row "efficiency of two ranks, percent" "$(calculate "100 * $one / (2 * $two)")" "at least 90"
cmp all.csv one.csv && cmp one.csv two.csv && row "all three tables have the same bytes" "yes" "yes"
if [ -x "$root/build/release/bench/training_store_bench" ]; then
  row "table of 100000 attempts from SQLite, s" \
    "$("$root/build/release/bench/training_store_bench" --benchmark_format=csv 2> /dev/null |
      awk -F, '/^"cohort_table/ { printf "%.3f", $3 / 1000; exit }')" "under 0.5"
else
  say "build/release has no training_store_bench: the table of results was not measured (ninja -C build/release training_store_bench)"
fi
say "the files are in $folder"
