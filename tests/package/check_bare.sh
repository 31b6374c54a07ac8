#!/usr/bin/env bash
# Installs the Debian packages into a bare Debian 12, made by debootstrap in a folder, and runs there every command of the
# README's tour; then builds the consumer project against the library's package.
#
#   tests/package/check_bare.sh [PACKAGES [MIRROR]]    PACKAGES: the folder of the packages; default: build/package
#
# As root, on Debian, with a connection to a mirror.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
packages=$(realpath "${1:-$here/../../build/package}")
mirror=${2:-http://deb.debian.org/debian}
# shellcheck source=scripts/setup.sh
source "$here/../../scripts/setup.sh"
require_packages debootstrap python3

root=$(mktemp -d -t brdfplot-bare.XXXXXX)
clean_up() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap clean_up EXIT
chmod 755 "$root"

step "A bare Debian 12 in $root"
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { tail -n 20 "$root.log"; exit 1; }
rm "$root.log"
mount -t proc proc "$root/proc"
cp /etc/resolv.conf "$root/etc/"
mkdir "$root/root/packages"
cp "$packages"/*.deb "$root/root/packages/"
apt="-qq -o APT::Sandbox::User=root -o Dpkg::Use-Pty=0" # _apt, by whom it reads files, may not enter /root
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive apt="$apt" bash -c "$1"; }

step "apt install ./brdfplot_*.deb"
inside 'cd /root/packages && apt-get -qq update && apt-get $apt install ./brdfplot_*.deb' 2>&1 | tail -n 3
inside 'dpkg -s brdfplot | grep -x "Status: install ok installed" && brdfplot --version'
python3 "$here/run_tour.py" "$root"

step "apt install ./libbrdfplot-dev_*.deb, and a project that uses it"
inside 'cd /root/packages && apt-get $apt install --no-install-recommends ./libbrdfplot-dev_*.deb g++ cmake make' 2>&1 |
  tail -n 1
mkdir "$root/root/consumer"
cp "$here/CMakeLists.txt" "$here/main.cpp" "$root/root/consumer/"
inside 'cd /root/consumer && cmake -B build . >/dev/null && cmake --build build >/dev/null && build/consumer'

step "apt purge"
inside 'apt-get $apt purge brdfplot libbrdfplot-dev && ! find /usr -path "*brdfplot*" | grep .' 2>&1 | tail -n 5
step "The packages work"
