#!/usr/bin/env bash
# Measures what docs/what-ants-are-worth.md and docs/compare.md tell, and puts the figures into them:
#   studies/measure.sh [study] [maps] [scaling]      (default: these three; some ten minutes on four idle cores)
#   studies/measure.sh compare                       (six minutes a world, THREADS of them at a time)
# Nothing else should run beside it. THREADS: cores to use, default 4, no more than are idle. `maps` and `compare` want
# the bench preset built, `scaling` wants mpirun, `compare` OMPL. TERRAIN: folder of the rasters that worlds name.
# WORLDS, SECONDS_EACH, SEEDS: of `compare`; default all in examples/worlds, 10 and 5.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
readonly alate=build/release/bin/alate out=out/worth
page=docs/what-ants-are-worth.md
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

# rows.csv of one world as a line of the table; ratios of wide worlds are added to a file for the mean.
world_line() {
  awk -F, -v world="$1" -v whole="$2" -v ratios="$3" '
    function median(costs, count, i, j, swap) {
      for (i = 2; i <= count; ++i)
        for (j = i; j > 1 && costs[j] < costs[j - 1]; --j) { swap = costs[j]; costs[j] = costs[j - 1]; costs[j - 1] = swap }
      return costs[int((count + 1) / 2)]
    }
    function cost_of(planner, share, i, list) {
      split("", list)
      for (i = 1; i <= runs[planner, share]; ++i) list[i] = cost[planner, share, i]
      return median(list, runs[planner, share])
    }
    # The best of ours is interval-astar; that of the others the one with the lowest median.
    function rival(share, planner, c, best) {
      best = 1e300
      for (planner in peers) { c = cost_of(planner, share); if (c < best) { best = c; name[share] = planner } }
      return best
    }
    function shown(c) { return c < 1e300 ? sprintf("%.0f", c) : "–" }
    function ratio(a, b) { return a < 1e300 && b < 1e300 ? sprintf("%.3f", a / b) : a < 1e300 ? "rival unsolved" : "–" }
    NR > 1 {
      share = $5 / whole
      if ($3 == "true") peers[$1] = 1
      cost[$1, share, ++runs[$1, share]] = $6 == "passed" ? $7 + 0 : 1e300
    }
    END {
      o1 = cost_of("interval-astar", 0.01); o2 = cost_of("interval-astar", 0.1); o3 = cost_of("interval-astar", 1)
      r1 = rival(0.01); r2 = rival(0.1); r3 = rival(1)
      printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", world, shown(o1), shown(o2), shown(o3),
        shown(r1), shown(r2), shown(r3), r3 < 1e300 ? name[1] : "–", ratio(o1, r1), ratio(o1, r3), ratio(o3, r3)
      if (world ~ /-wide$/ && o1 < 1e300 && o3 < 1e300 && r1 < 1e300 && r3 < 1e300) print o1 / r1, o1 / r3, o3 / r3 >> ratios
    }' "out/compare/$1/rows.csv"
}

# All planners in one world, one after another on one core.
compare_in() {
  local world=$1 dem peer
  local -a arguments=(--seconds "$2" --seeds "$3" --only interval-astar)
  for peer in rrtconnect-restarts rrtconnect-elites anytime-path-shortening rrt-star informed-rrt-star bit-star; do
    arguments+=(--only "$peer")
  done
  dem=$(sed -n 's/.*dem: *\([^,} ]*\).*/\1/p' "examples/worlds/$world.yaml" | head -n 1)
  if [[ -n $dem && ! -e examples/worlds/$dem ]]; then
    dem=$(find "${TERRAIN:?names the folder of $dem}" -name "$dem" | head -n 1)
    arguments+=(--override "terrain.dem=$dem")
  fi
  build/bench/bin/alate compare "examples/worlds/$world.yaml" "${arguments[@]}" --out "out/compare/$world" >&2
}

# As many worlds at a time as there are threads.
compare() {
  local seconds=${SECONDS_EACH:-10} seeds=${SEEDS:-5} ratios world
  page=docs/compare.md
  ratios=$(mktemp)
  for world in ${WORLDS:-$(basename -s .yaml examples/worlds/*.yaml)}; do
    while (($(jobs -rp | wc -l) >= threads)); do wait -n; done
    compare_in "$world" "$seconds" "$seeds" &
  done
  while (($(jobs -rp | wc -l) > 0)); do wait -n; done
  {
    echo "Median cost of routes that pass the check, $seeds seeds, one core, $(machine). Ratios below 1: ours is cheaper."
    echo
    awk -v s="$seconds" 'BEGIN {
      printf "| world | ours %g s | %g s | %g s | rival %g s | %g s | %g s | the rival | ours / rival, %g s | ours %g s / rival %g s | ours / rival, %g s |\n",
        s / 100, s / 10, s, s / 100, s / 10, s, s / 100, s / 100, s, s }'
    echo "|---|---:|---:|---:|---:|---:|---:|---|---:|---:|---:|"
    for world in ${WORLDS:-$(basename -s .yaml examples/worlds/*.yaml)}; do world_line "$world" "$seconds" "$ratios"; done
    awk -v s="$seconds" '{ for (i = 1; i <= 3; ++i) sum[i] += log($i) }
      END { if (NR) printf "\nGeometric mean over %d wide worlds: %.3f at %g s, %.3f for ours at %g s against the rival at %g s, %.3f at %g s.\n",
        NR, exp(sum[1] / NR), s / 100, exp(sum[2] / NR), s / 100, s, exp(sum[3] / NR), s }' "$ratios"
  } | put compare
  rm "$ratios"
}

mkdir -p "$out"
(($#)) || set -- study maps scaling
for part in "$@"; do
  case $part in
    study | maps | scaling | compare) "$part" ;;
    *)
      echo "usage: studies/measure.sh [study] [maps] [scaling] [compare]" >&2
      exit 2
      ;;
  esac
done
