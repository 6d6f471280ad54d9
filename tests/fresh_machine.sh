#!/usr/bin/env bash
# Proves on a bare Debian 12 that the two commands need nothing but what
# docker/packages.txt lists: a missing package shows here and nowhere else.
#
# usage: tests/fresh_machine.sh [--keep] [--tarball FILE] [FOLDER [COMMAND...]]
#        tests/fresh_machine.sh --base FOLDER
#
# As root. Debootstraps into FOLDER (by default a new temporary one, about
# 5 GB by the end), clones HEAD into it and runs there each COMMAND, by default
# './reproduce report' and './reproduce test'. A FOLDER that holds a system
# already is used as it is. --keep leaves the folder; --tarball caches the
# downloaded base packages in FILE. Wall times are printed at the end. --base
# only makes the system and leaves it (docker/build_image.sh makes an image of it).
# shellcheck disable=SC2317  # functions reached through timed()
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly here suite=bookworm
keep=0 base_only=0 tarball=''
while [[ ${1-} == --* ]]; do
  case $1 in
    --keep) keep=1 ;;
    --base) base_only=1 keep=1 ;;
    --tarball)
      tarball=$(realpath -m "${2:?--tarball needs a file}")
      shift
      ;;
    *)
      sed -n '2,13s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
      exit 2
      ;;
  esac
  shift
done
if ((EUID != 0)); then
  echo "fresh_machine: debootstrap and chroot need root" >&2
  exit 2
fi

root=${1:-$(mktemp -d "${TMPDIR:-/tmp}/fresh_machine.XXXXXX")}
(($# == 0)) || shift
commands=("$@")
((${#commands[@]})) || commands=('./reproduce report' './reproduce test')
mkdir -p "$root"
root=$(cd "$root" && pwd)

# Unmounts before anything is removed: a forgotten /dev would be emptied.
clean_up() {
  local place
  for place in dev/pts dev/shm dev sys proc; do
    mountpoint -q "$root/$place" && umount -l "$root/$place"
  done
  if ((!keep)) && ! grep -q " $root/" /proc/mounts; then
    rm -rf --one-file-system "$root"
  fi
}
trap clean_up EXIT
trap 'exit 130' INT TERM

report=()
timed() {
  local title=$1 started=$SECONDS status=0
  shift
  echo "##> $title"
  "$@" || status=$?
  report+=("$(printf '%-24s %5d s  exit %d' "$title" \
    $((SECONDS - started)) "$status")")
  return "$status"
}

# The mirror the host itself uses, else Debian's.
mirror() {
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} \
    2>/dev/null | sed -n -E 's/^(URIs:|deb( \[[^]]*\])?) +//p' |
    awk '{print $1}' | grep -E '/debian/?$' | head -n 1 || true
}

bootstrap() {
  [[ -x $root/usr/bin/apt-get ]] && return
  if ! command -v debootstrap >/dev/null; then
    apt-get -q -o DPkg::Lock::Timeout=600 update &&
      DEBIAN_FRONTEND=noninteractive apt-get -q -y \
        -o DPkg::Lock::Timeout=600 install --no-install-recommends debootstrap
  fi >/dev/null
  local from options=(--variant=minbase)
  from=$(mirror)
  [[ -z $tarball || ! -s $tarball ]] || options+=(--unpack-tarball="$tarball")
  if [[ -n $tarball && ! -s $tarball ]]; then
    # It needs a work folder of its own, and ends after packing.
    local work
    work=$(mktemp -d)
    debootstrap "${options[@]}" --make-tarball="$tarball" "$suite" \
      "$work/base" "${from:-http://deb.debian.org/debian}" >/dev/null
    rm -rf "$work"
    options+=(--unpack-tarball="$tarball")
  fi
  debootstrap "${options[@]}" "$suite" "$root" \
    "${from:-http://deb.debian.org/debian}" >"$root.log" 2>&1 || {
    tail -n 20 "$root.log" >&2
    return 1
  }
  rm -f "$root.log"
}

# What the host needs to reach its packages: name service, proxies, mirrors.
# Only files of Debian's own; a third party's list is no part of a bare system.
copy_apt_setup() {
  local file
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  cp /etc/hosts "$root/etc/hosts"
  for file in /etc/apt/apt.conf /etc/apt/apt.conf.d/*; do
    if [[ -f $file ]] && grep -qiE '^ *(Acquire|#clear|Dir::Etc)' "$file"; then
      cp "$file" "$root$file"
    fi
  done
  if [[ -f /etc/apt/sources.list.d/debian.sources ]]; then
    cp /etc/apt/sources.list.d/debian.sources "$root/etc/apt/sources.list.d/"
    rm -f "$root/etc/apt/sources.list"
  elif [[ -s /etc/apt/sources.list ]]; then
    cp /etc/apt/sources.list "$root/etc/apt/sources.list"
  fi
}

mount_kernel_files() {
  mount -t proc proc "$root/proc"
  mount -t sysfs -o ro sysfs "$root/sys"
  mount --bind /dev "$root/dev"
  mount --bind /dev/pts "$root/dev/pts" 2>/dev/null || true
  mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
}

copy_repository() {
  rm -rf "$root/root/pitbench"
  git -c safe.directory='*' clone -q --no-local "$here" "$root/root/pitbench"
  git -C "$root/root/pitbench" remote remove origin
}

# A login with nothing of the host's environment but the way to the network.
inside() {
  local keep_variables=() name
  for name in http_proxy https_proxy no_proxy CI; do
    [[ -z ${!name-} ]] || keep_variables+=("$name=${!name}")
  done
  chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 TERM=dumb \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    "${keep_variables[@]}" bash -c "cd /root/pitbench && $1" </dev/null
}

failed=0
timed debootstrap bootstrap
copy_apt_setup
((!base_only)) || exit 0
mount_kernel_files
timed clone copy_repository
for command in "${commands[@]}"; do
  timed "$command" inside "$command" || failed=1
done
((!keep)) || echo "kept: $root"
printf '%s\n' "${report[@]}"
exit "$failed"
