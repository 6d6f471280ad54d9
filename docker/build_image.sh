#!/usr/bin/env bash
# Builds the image of docker/Dockerfile where no Docker daemon runs, with buildah
# on a base system made by debootstrap; nothing is pulled from a registry of
# images.
#
# usage: docker/build_image.sh [--try] [IMAGE]
#
# As root, on Debian 12. IMAGE is the image's name (default: pitbench). --try
# then runs the two commands in a container of it, briefly: a report of the
# profile tiny and the C++ tests. Installs buildah and debootstrap if they are
# missing. About 3 GB in buildah's store.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly base=localhost/debian:bookworm-slim
try=0
if [[ ${1-} == --try ]]; then
  try=1
  shift
fi
if (($# > 1)) || [[ ${1-} == -* ]]; then
  sed -n '2,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
readonly image=${1-pitbench}
if ((EUID != 0)); then
  echo "build_image: debootstrap needs root" >&2
  exit 2
fi

missing=()
for package in buildah debootstrap; do
  command -v "$package" >/dev/null || missing+=("$package")
done
if ((${#missing[@]})); then
  echo "==> installing ${missing[*]}"
  apt-get -q -o DPkg::Lock::Timeout=600 update >/dev/null
  DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600 \
    install --no-install-recommends "${missing[@]}" >/dev/null
fi

# Works inside containers and without overlayfs, where the defaults do not.
export BUILDAH_ISOLATION=chroot STORAGE_DRIVER=${STORAGE_DRIVER-vfs}

# The base that the Dockerfile names, from the host's own mirror.
if ! buildah inspect --type image "$base" >/dev/null 2>&1; then
  echo "==> $base, by debootstrap"
  root=$(mktemp -d)
  trap 'rm -rf --one-file-system "$root"' EXIT
  tests/fresh_machine.sh --base "$root"
  container=$(buildah from scratch)
  buildah copy -q "$container" "$root" / >/dev/null
  buildah commit -q --rm "$container" "$base" >/dev/null
  rm -rf --one-file-system "$root"
fi

echo "==> $image, by docker/Dockerfile"
buildah build -q --pull=never --from "$base" --network host \
  --ignorefile docker/Dockerfile.dockerignore -f docker/Dockerfile \
  -t "$image" . >/dev/null
echo "built: $image"

if ((try)); then
  container=$(buildah from --pull=never "$image")
  trap 'buildah rm "$container" >/dev/null' EXIT
  # What `docker run IMAGE report …` and `… test …` start.
  buildah run "$container" -- ./reproduce report --profile tiny
  buildah run "$container" -- ./reproduce test release
fi
