#!/usr/bin/env bash
# Installs what drt needs on Debian 12, Debian 13 or Ubuntu 24.04, bare machines included. Asks nothing, and does
# nothing at all when everything is there.
#
#   third_party/setup.sh [--optional] [--list]
#
#   --optional  also what benchmarks and static analysis use
#   --list      print the packages for this machine and exit
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

lists=("$here/packages.txt")
list_only=false
for argument in "$@"; do
    case $argument in
        --optional) lists+=("$here/packages-optional.txt") ;;
        --list) list_only=true ;;
        *) echo "setup.sh: unknown option '$argument' (known: --optional, --list)" >&2; exit 2 ;;
    esac
done

release_id=$(. /etc/os-release && echo "${ID:-unknown}")
release=$(. /etc/os-release && echo "${ID:-unknown}-${VERSION_ID:-}")

# The names in the lists that concern this release.
packages_for_this_release() {
    local name only
    sed -e 's/#.*//' "${lists[@]}" | while read -r name only; do
        [[ -n $name ]] || continue
        [[ -z $only || " ${only//[\[\]]/ } " == *" $release "* || " ${only//[\[\]]/ } " == *" $release_id "* ]] || continue
        echo "$name"
    done
}

is_installed() { [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }

mapfile -t packages < <(packages_for_this_release)
if $list_only; then
    printf '%s\n' "${packages[@]}"
    exit 0
fi
if ! command -v apt-get >/dev/null; then
    echo "setup.sh: no apt-get here; install the equivalents of these packages by hand:" "${packages[@]}" >&2
    exit 1
fi
case $release in
    debian-12 | debian-13 | ubuntu-24.04) ;;
    *) echo "setup.sh: $release is not one of debian-12, debian-13, ubuntu-24.04; trying their package names" >&2 ;;
esac

missing=()
for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
    echo "setup.sh: all ${#packages[@]} packages are installed"
    exit 0
fi

as_root=()
if ((EUID != 0)); then
    command -v sudo >/dev/null || { echo "setup.sh: run as root, or install sudo" >&2; exit 1; }
    as_root=(sudo)
fi
echo "setup.sh: installing" "${missing[@]}"
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o Acquire::Retries=3 "$@"; }
# An index from another repository that cannot be reached is no reason to stop: the installation will tell.
apt update || echo "setup.sh: some package lists could not be updated" >&2
apt install --yes --no-install-recommends "${missing[@]}"
