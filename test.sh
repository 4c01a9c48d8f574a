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

sources() { find apps bench examples include src tests "$@" -print0; }

check_format() {
  sources \( -name '*.cpp' -o -name '*.hpp' \) | xargs -0 clang-format-19 --dry-run -Werror
}

# test_preset PRESET: configure, build, run.
test_preset() {
  configure "$1"
  build "$1"
  ctest --preset "$1" --parallel "$(nproc)"
}

# Needs the compile commands of a build that knows every source, benchmarks included.
check_tidy() {
  configure tidy
  sources -name '*.cpp' -not -path 'tests/install/*' |
    xargs -0 -n 1 -P "$(jobs)" clang-tidy-19 -p build/tidy --quiet
}

install_missing cmake/packages.txt cmake/packages-test.txt
check_format
if [[ $all == yes ]]; then
  configure bench
  build bench
  check_tidy
  test_preset asan
  test_preset tsan
fi
test_preset release
