# Steps that demo.sh and test.sh share. Sourced, from the project's folder.
# shellcheck shell=bash

# Installs the Debian packages named in the given files, one a line, that are not there yet.
install_missing() {
  local missing=() package as_root=()
  while read -r package; do
    if [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
      missing+=("$package")
    fi
  done < <(cat "$@")
  ((${#missing[@]})) || return 0

  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "Packages are missing and sudo is not there to install them. As root, please run:" >&2
      echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# Compilers that may run at once: one a processor, and 1.5 GB of memory for each.
jobs() {
  local processors memory_kb by_memory
  processors=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo)
  by_memory=$((memory_kb / 1500000))
  ((by_memory >= 1)) || by_memory=1
  echo $((processors < by_memory ? processors : by_memory))
}

# configure PRESET [CMAKE-OPTION...]
configure() {
  local preset=$1 launcher=
  shift
  if command -v ccache >/dev/null; then launcher=ccache; fi
  cmake --preset "$preset" -DCMAKE_CXX_COMPILER_LAUNCHER=$launcher "$@"
}

# build PRESET [BUILD-OPTION...]
build() {
  cmake --build --preset "$1" --parallel "$(jobs)" "${@:2}"
}
