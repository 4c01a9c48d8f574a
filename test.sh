#!/usr/bin/env bash
# Installs what is missing, checks the format, builds and runs the tests. --all adds sanitizers, benchmarks, clang-tidy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source cmake/steps.sh

all=no
for argument in "$@"; do
  case $argument in
    --all) all=yes ;;
    *)
      echo "usage: ./test.sh [--all]" >&2
      exit 2
      ;;
  esac
done

check_format() {
  find apps bench examples include src tests \( -name '*.cpp' -o -name '*.hpp' \) -print0 |
    xargs -0 clang-format-19 --dry-run -Werror
}

# test_preset PRESET: configure, build, run.
test_preset() {
  configure "$1"
  build "$1"
  ctest --preset "$1" --parallel "$(nproc)"
}

install_missing cmake/packages.txt cmake/packages-test.txt
check_format
if [[ $all == yes ]]; then
  for preset in bench tidy; do
    configure $preset
    build $preset
  done
  test_preset asan
  test_preset tsan
fi
test_preset release
