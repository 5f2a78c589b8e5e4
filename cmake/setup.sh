# Sourced by run.sh and test.sh: from a bare Debian 12 to a configured build. Everything it prints goes to stderr, so that
# what the programs print can be piped.
set -euo pipefail
exec </dev/null # some callers close standard input

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

# Prints the names in packages.txt that are not installed.
missing_packages() {
  local name
  while read -r name; do
    [[ $name == '' || $name == \#* ]] && continue
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null || true) == installed ]] || echo "$name"
  done <"$root/cmake/packages.txt"
}

install_packages() {
  local missing sudo=()
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null || {
      echo "run as root, or install sudo, to install: ${missing[*]}" >&2
      exit 1
    }
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update >&2
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "${missing[@]}" >&2
}

# configure PRESET
configure() {
  install_packages
  cmake -S "$root" --preset "$1" >&2
}
