#!/usr/bin/env bash
# Runs the kernels' tests on AVX-512 where the CPU has none: as programs of a small
# Linux on a CPU that Bochs emulates. Takes about a quarter of an hour. It is about answers: a
# time taken there means nothing, and none is.
#
# usage: tests/avx512/run.sh BUILD LINUX
#        BUILD: the folder with pitbench and tests/; LINUX: the package of a Linux
#        for the emulated machine. What else it wants is in docker/packages.txt,
#        section [test-avx512].
#
# Prints "ok" or "FAILED" for each test, what is wrong above it, and the sum.
set -euo pipefail
build=$(realpath -e -- "${1:?the folder of the build}")
linux=${2:?the package of a Linux}
cd -- "$(dirname "${BASH_SOURCE[0]}")"
readonly build linux here=$PWD work=$build/avx512 minutes=40

# What the emulated machine runs, of the programs in the build: a line
# "NAME COMMAND" each. All ISAs where they are compared, else those of AVX-512.
tests() {
  local isas='scalar autovec_v2 autovec_v3 autovec_v4 ssse3 sse4 avx2 avx512'
  local brief=--gtest_brief=1 name method scalar
  local wide="$brief '--gtest_filter=*avx512*:*autovec_v4*'"
  # Guarded memory is slow there: of the kernels few.
  local few="$brief '--gtest_filter=*/exact_f*avx512_one_triangle'"
  echo "isas_test PITBENCH_EXPECTED_ISAS='$isas' ./isas_test $brief"
  echo "isa_agreement_test ./isa_agreement_test $brief"
  echo "known_verdicts_test ./known_verdicts_test $brief"
  for name in nonfinite truth symmetry points weights; do
    echo "kernel_${name}_test ./kernel_${name}_test $wide"
  done
  for scalar in f32 f64; do
    for method in exact exact_open exact_top_left; do
      echo "verify_${method}_$scalar ./pitbench verify --method $method" \
        "--scalar $scalar --isa avx512 --points 3e5"
    done
    echo "verify_rays_exact_$scalar ./pitbench verify --rays --method exact" \
      "--scalar $scalar --isa avx512 --points 1e5"
  done
  echo "kernel_contract_test ./kernel_contract_test $few"
}

# Copies a program and the libraries it wants into the emulated machine's files.
copy_program() {
  local library
  install -s "$1" "files/programs/"
  for library in $(ldd "$1" | grep -o '/[^ ]*'); do
    install -D "$library" "files$library"
  done
}

# The kernel, which is not for the system that this one runs on.
unpack_linux() {
  local newest
  [[ -e linux/vmlinuz ]] && return
  newest=$(apt-cache depends "$linux" |
    sed -n 's/^ *Depends: \(linux-image-.*\)/\1/p')
  rm -rf linux && mkdir linux
  (cd linux && apt-get -qq -o APT::Sandbox::User=root download "$newest" &&
    dpkg-deb -x ./*.deb . && cp boot/vmlinuz-* vmlinuz)
}

# Makes cd.iso, which starts the programs.
pack() {
  local program
  rm -rf files disc
  mkdir -p files/{bin,dev,proc,sys,programs} disc/isolinux
  cp /bin/busybox files/bin/
  for program in sh cat grep mount reboot sleep tail; do
    ln -s busybox "files/bin/$program"
  done
  install "$here/init" files/init
  tests >files/tests
  while read -r program; do
    if [[ -e $build/tests/$program ]]; then
      copy_program "$build/tests/$program"
    else
      copy_program "$build/$program"
    fi
  done < <(grep -o '\./[a-z_]*' files/tests | sort -u)
  (cd files && find . | cpio -o -H newc --quiet) | gzip -1 >disc/programs.gz
  cp linux/vmlinuz disc/
  cp "$here/isolinux.cfg" /usr/lib/ISOLINUX/isolinux.bin \
    /usr/lib/syslinux/modules/bios/ldlinux.c32 disc/isolinux/
  xorriso -as mkisofs -o cd.iso -b isolinux/isolinux.bin \
    -c isolinux/boot.cat -no-emul-boot -boot-load-size 4 -boot-info-table disc \
    2>disc.txt || {
    cat disc.txt >&2
    return 1
  }
}

# Bochs opens a terminal for its screen, and waits where nobody reads what it shows
# there; its debugger has to be told to go on.
emulate() {
  local emulator screen
  echo continue >go.txt
  : >screen.txt
  TERM=linux BXSHARE=/usr/share/bochs setpriv --pdeathsig TERM -- \
    timeout -k 2 $((60 * minutes)) bochs-bin -q -f "$here/bochsrc" -rc go.txt \
    >screen.txt 2>&1 </dev/null &
  emulator=$!
  until screen=$(grep -aoEm 1 '/dev/pts/[0-9]+' screen.txt) ||
    ! kill -0 "$emulator" 2>/dev/null; do
    sleep 0.2
  done
  [[ -z $screen ]] || cat "$screen" >/dev/null 2>&1 &
  wait "$emulator" || true
}

# Reads the console as it is written. A line ends with a carriage return.
judge() {
  local passed=0 failed=0 started=$SECONDS ended=no word name code
  local said=()
  while IFS= read -r line; do
    line=${line%$'\r'}
    read -r word name code <<<"$line"
    case $word in
      BEGIN) said=() ;;
      END)
        if [[ $code == 0 ]]; then
          passed=$((passed + 1))
          echo "ok $name ($((SECONDS - started)) s)"
        else
          failed=$((failed + 1))
          printf '%s\n' "${said[@]}"
          echo "FAILED $name: ended $code"
        fi
        started=$SECONDS
        ;;
      DONE) ended=yes ;;
      *) said+=("$line") ;;
    esac
  done
  # Without its end, something stopped it on its way.
  [[ $ended == yes ]] || {
    tail -n 20 console.txt
    echo "FAILED the emulated machine stopped, or ran for $minutes minutes"
    failed=$((failed + 1))
  }
  echo "$passed passed, $failed failed"
  ((failed == 0))
}

mkdir -p "$work"
cd "$work"
unpack_linux
pack
: >console.txt
emulate &
emulator=$!
trap 'kill "$emulator" 2>/dev/null || true' EXIT  # also of one interrupted
tail -n +1 -F --pid="$emulator" console.txt 2>/dev/null | judge
