#!/usr/bin/env bash
# Measures what docs/what-ants-are-worth.md tells, and puts the figures into it:
#   studies/measure.sh [study] [maps] [scaling]      (default: all three; some ten minutes on four idle cores)
# Nothing else should run beside it. THREADS: cores to use, default 4, no more than are idle. `maps` wants the bench
# preset built, `scaling` wants mpirun.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
readonly alate=build/release/bin/alate page=docs/what-ants-are-worth.md out=out/worth
readonly threads=${THREADS:-4}

# Puts standard input between the marks of a section of the page.
put() {
  local text
  text=$(mktemp)
  cat >"$text"
  grep -q "<!-- measured: $1 -->" "$page"
  awk -v mark="measured: $1" -v file="$text" '
    $0 == "<!-- /" mark " -->" { inside = 0 }
    !inside { print }
    $0 == "<!-- " mark " -->" { inside = 1; print ""; while ((getline line < file) > 0) print line; print "" }
  ' "$page" >"$page.new"
  mv "$page.new" "$page"
  rm "$text"
}

machine() { sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1; }

study() {
  rm -rf "$out/study" # a journal would bring back times of another day
  "$alate" study studies/what-ants-are-worth.yaml --out "$out/study" --threads "$threads"
  put study <"$out/study/summary.md"
}

# Columns by name: user counters come in the order of the alphabet.
maps() {
  build/bench/bin/bench_grid_search --benchmark_filter='^drawn_map/' --benchmark_format=csv >"$out/maps.csv"
  {
    echo "Processor time of a query from corner to corner, mean of three, one thread, $(machine)."
    echo
    echo "| cells | A* | jump point search | textbook A* | map | A*'s table | jump point search's table |"
    echo "|---|---:|---:|---:|---:|---:|---:|"
    awk -F, '
      function ms(value) { return sprintf(value < 100 ? "%.3g ms" : "%.0f ms", value) }
      $1 == "name" { for (i = 1; i <= NF; ++i) { gsub(/"/, "", $i); column[$i] = i } }
      /drawn_map\// {
        split($1, part, "/")
        printf "| %d x %d | %s | %s | %s | %.2f MiB | %.1f MiB | %.1f MiB |\n", part[2], part[2],
          ms($column["astar_ms"]), ms($column["jps_ms"]), ms($column["literal_ms"]), $column["bits_MiB"],
          $column["astar_MiB"], $column["jps_MiB"]
      }' "$out/maps.csv"
  } | put maps
}

# Seconds that a command takes.
seconds() {
  local start=$EPOCHREALTIME
  "$@" >/dev/null
  awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.2f", b - a }'
}

scaling() {
  local n took first=()
  {
    echo "Seconds for the whole command, $(machine)."
    echo
    echo "| | threads of one process | times as fast | processes of one thread | times as fast |"
    echo "|---|---:|---:|---:|---:|"
    for n in 1 2 4; do
      rm -rf "$out/scaling"
      took=("$(seconds "$alate" study studies/scaling.yaml --out "$out/scaling/threads" --threads "$n")")
      took+=("$(seconds mpirun --allow-run-as-root --bind-to none -n "$n" \
        "$alate" study studies/scaling.yaml --out "$out/scaling/ranks" --threads 1)")
      cmp "$out/scaling/threads/rows.csv" "$out/scaling/ranks/rows.csv"
      ((n > 1)) || first=("${took[@]}")
      awk -v n="$n" -v t="${took[0]}" -v r="${took[1]}" -v t1="${first[0]}" -v r1="${first[1]}" \
        'BEGIN { printf "| %d | %.1f | %.2f | %.1f | %.2f |\n", n, t, t1 / t, r, r1 / r }'
    done
  } | put scaling
}

mkdir -p "$out"
(($#)) || set -- study maps scaling
for part in "$@"; do
  case $part in
    study | maps | scaling) "$part" ;;
    *)
      echo "usage: studies/measure.sh [study] [maps] [scaling]" >&2
      exit 2
      ;;
  esac
done
