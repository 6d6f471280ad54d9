"""./reproduce in a folder where every command it calls only keeps a log."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
# What a stub does: log the call, then behave as the files in state/ say.
STUB = """#!/bin/bash
echo "${0##*/} $*" >>"$STATE/log"
case ${0##*/} in
  dpkg) [[ $1 != --print-architecture ]] || cat "$STATE/host" ;;
  dpkg-query)
    package=${!#}
    grep -qx "$package" "$STATE/missing" && exit 1
    [[ $package == *:* ]] && echo "installed ${package#*:}" && exit
    echo "installed $(cat "$STATE/host")"
    ;;
  ctest)
    echo "50% tests passed, 2 tests failed out of 4" >"$STATE/broken-summary"
    if [[ $* == *asan* && -e $STATE/asan-fails ]]; then
      cat "$STATE/broken-summary"
      exit 8
    fi
    echo "100% tests passed, 0 tests failed out of 7"
    ;;
  cmake)
    if [[ $1 == --build ]]; then
      mkdir -p build && touch build/build.ninja
      printf '%s\\n' '# a.cc' direct_cache_hit '# b.cc' cache_miss \\
        '# c.cc' preprocessed_cache_hit >>"${CCACHE_STATSLOG:-/dev/null}"
    fi
    [[ $* != *"$(cat "$STATE/cmake-fails" 2>/dev/null || echo NONE)"* ]]
    ;;
esac
"""
SWEEP = """import os, sys
if "--print-run-name" in sys.argv:
    print("quick-12345678")
else:
    os.makedirs(sys.argv[sys.argv.index("--out") + 1], exist_ok=True)
    print("sweeping", *sys.argv[1:])
"""
SUM = '#!/bin/bash\necho "$@"\necho 3 passed, 0 failed\n'


class Fake:
    def __init__(self, folder: Path) -> None:
        self.folder, self.state, self.bin = folder, folder / "state", folder / "bin"
        for place in ("docker", "harness", "analysis", "tests", "state", "bin"):
            (folder / place).mkdir()
        shutil.copy(ROOT / "reproduce", folder)
        for packages in ("packages.txt", "packages-peers.txt"):
            shutil.copy(ROOT / "docker" / packages, folder / "docker")
        (folder / "harness" / "sweep.py").write_text(SWEEP)
        (folder / "analysis" / "__main__.py").write_text("print('reporting')")
        (folder / "tests" / "test_one.py").write_text("def test_one(): pass\n")
        (folder / "tests" / "avx512").mkdir()
        for script in ("lint.sh", "end_to_end.sh", "avx512/run.sh"):
            (folder / "tests" / script).write_text(SUM)
        for name in ("dpkg", "dpkg-query", "apt-get", "sudo", "cmake", "ctest"):
            (self.bin / name).write_text(STUB)
            (self.bin / name).chmod(0o755)
        self.missing()
        (self.state / "host").write_text("amd64\n")

    def missing(self, *packages: str) -> None:
        (self.state / "missing").write_text("\n".join(packages) + "\n")

    def run(self, *arguments: str) -> tuple[int, list[str], str]:
        """Exit code, lines of stdout, stderr."""
        (self.state / "log").write_text("")
        done = subprocess.run(
            ["./reproduce", *arguments],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            env={
                **os.environ,
                "PATH": f"{self.bin}:/usr/bin:/bin",
                "STATE": str(self.state),
            },
        )
        return done.returncode, done.stdout.splitlines(), done.stderr

    def called(self, *commands: str) -> list[str]:
        lines = (self.state / "log").read_text().splitlines()
        return [line for line in lines if line.split()[0] in commands]


@pytest.fixture
def fake(tmp_path: Path) -> Fake:
    return Fake(tmp_path)


def test_report_ends_with_the_path_of_the_page(fake: Fake) -> None:
    code, output, errors = fake.run("report")
    assert (code, errors) == (0, "")
    assert output[-1] == "results/quick-12345678/report/index.html"
    assert "reporting" in output


def test_a_run_has_how_long_the_first_build_took(fake: Fake) -> None:
    assert fake.run("report", "--run", "mine")[0] == 0
    built = fake.folder / "results" / "mine" / "build.json"
    document = json.loads(built.read_text())
    assert document.pop("seconds") >= 0
    first = {"schema": "pitbench-build-1", "compiled": 1, "from_cache": 2}
    assert document == first
    (fake.folder / "build" / "build.json").write_text("the first")
    assert fake.run("report", "--run", "mine")[0] == 0
    assert built.read_text() == "the first"


def test_a_build_with_the_tests_is_not_taken_for_the_programs(fake: Fake) -> None:
    assert fake.run("test", "lint")[0] == 0
    assert fake.run("report", "--run", "mine")[0] == 0
    assert not (fake.folder / "results" / "mine" / "build.json").exists()


def test_report_takes_profile_and_run(fake: Fake) -> None:
    code, output, _ = fake.run("report", "--profile", "tiny", "--run", "mine")
    assert (code, output[-1]) == (0, "results/mine/report/index.html")
    assert any("--profile tiny --out results/mine" in line for line in output)


def test_report_leaves_out_wider_isas_when_told(fake: Fake) -> None:
    code, output, _ = fake.run("report", "--isa-up-to", "avx2")
    assert code == 0
    swept = "--profile quick --isa-up-to avx2 --out results/quick-12345678"
    assert any(swept in line for line in output)


def test_peers_are_installed_built_and_named(fake: Fake) -> None:
    fake.missing("libgeos-dev", "mypy")
    code, output, _ = fake.run("report", "--peers")
    assert (code, output[-1]) == (0, "results/quick-12345678-peers/report/index.html")
    assert fake.called("apt-get")[-1].endswith(" libgeos-dev")
    assert "cmake --preset peers" in fake.called("cmake")
    assert any("--pitbench build-peers/pitbench" in line for line in output)


def test_a_run_with_peers_keeps_the_name_given(fake: Fake) -> None:
    output = fake.run("report", "--peers", "--run", "mine")[1]
    assert output[-1] == "results/mine/report/index.html"


def test_nothing_of_peers_is_touched_without_the_word(fake: Fake) -> None:
    fake.missing("libgeos-dev")
    assert fake.run("report")[0] == 0
    assert fake.run("test")[0] == 0
    assert fake.called("apt-get") == []
    assert not any("peers" in line for line in fake.called("cmake", "ctest"))


def test_peers_are_tested_when_named(fake: Fake) -> None:
    fake.missing("libgeos-dev")
    code, output, _ = fake.run("test", "peers")
    assert (code, output[-1]) == (0, "7 passed, 0 failed")
    assert fake.called("apt-get")[-1].endswith(" libgeos-dev")
    (test,) = fake.called("ctest")
    assert test.startswith("ctest --preset peers-tests")
    assert not any("--preset tests" in line for line in fake.called("cmake"))


def test_avx512_is_emulated_where_the_cpu_has_none(fake: Fake) -> None:
    fake.missing("bochs", "linux-image-cloud-amd64")
    code, output, _ = fake.run("test", "avx512")
    assert code == 0
    # The Linux is unpacked, and this system does not get another.
    assert fake.called("apt-get")[-1].endswith(" bochs")
    if "avx512vl" in Path("/proc/cpuinfo").read_text():
        assert output[-1] == "0 passed, 0 failed"
    else:
        assert "build linux-image-cloud-amd64" in output
        assert output[-1] == "3 passed, 0 failed"


def test_nothing_is_installed_where_nothing_is_missing(fake: Fake) -> None:
    assert fake.run("install", "test")[0] == 0
    assert fake.called("apt-get", "sudo") == []
    assert "dpkg --add-architecture arm64" not in fake.called("dpkg")


def test_only_what_is_missing_is_installed(fake: Fake) -> None:
    fake.missing("cmake", "python3-rich", "mypy")
    assert fake.run("install", "report")[0] == 0
    update, install = fake.called("apt-get")
    assert update.endswith(" update")
    assert install.endswith("install -y --no-install-recommends cmake python3-rich")
    assert "dpkg --add-architecture arm64" not in fake.called("dpkg")


def test_the_foreign_architecture_is_added_for_its_packages(fake: Fake) -> None:
    fake.missing("libhwy-dev:arm64")
    assert fake.run("install", "test")[0] == 0
    assert "dpkg --add-architecture arm64" in fake.called("dpkg")
    assert fake.called("apt-get")[1].endswith(" libhwy-dev:arm64")


def test_an_arm64_host_does_not_cross_build(fake: Fake) -> None:
    (fake.state / "host").write_text("arm64\n")
    fake.missing("g++-aarch64-linux-gnu", "qemu-user")
    code, output, _ = fake.run("test", "arm64")
    assert (code, output[-1]) == (0, "0 passed, 0 failed")
    assert fake.called("apt-get") == []


def test_a_host_of_arm64_does_not_emulate_avx512(fake: Fake) -> None:
    (fake.state / "host").write_text("arm64\n")
    fake.missing("bochs")
    code, output, _ = fake.run("test", "avx512")
    assert (code, output[-1]) == (0, "0 passed, 0 failed")
    assert fake.called("apt-get") == []


def test_test_runs_every_suite_and_sums(fake: Fake) -> None:
    code, output, _ = fake.run("test")
    # ctest thrice, pytest, lint, end to end
    assert (code, output[-1]) == (0, "28 passed, 0 failed")
    presets = [line.split()[-1] for line in fake.called("ctest")]
    assert presets == ["tests", "asan", "arm64"]


def test_a_failing_suite_does_not_stop_the_others(fake: Fake) -> None:
    (fake.state / "asan-fails").touch()
    (fake.folder / "tests" / "test_one.py").write_text("def test_one(): assert 0\n")
    code, output, _ = fake.run("test")
    assert code == 1
    assert output[-2:] == ["FAILED suites: python asan", "22 passed, 3 failed"]
    assert "ctest --preset arm64" in fake.called("ctest")


def test_a_suite_that_does_not_build_counts_as_failed(fake: Fake) -> None:
    (fake.state / "cmake-fails").write_text("--build --preset asan")
    code, output, _ = fake.run("test", "asan", "lint")
    assert (code, output[-1]) == (1, "3 passed, 1 failed")


def test_report_stops_where_the_build_fails(fake: Fake) -> None:
    (fake.state / "cmake-fails").write_text("--build")
    code, output, errors = fake.run("report")
    assert code == 1
    assert "build: FAILED" in errors
    assert not any("sweep" in line for line in output)


@pytest.mark.parametrize(
    "exit_code, ends_with, last",
    [
        (1, 1, "results/quick-12345678/report/index.html"),
        (2, 2, "==> sweep into results/quick-12345678"),
        (130, 130, "==> sweep into results/quick-12345678"),
    ],
)
def test_failed_shards_still_give_a_report_but_not_success(
    fake: Fake, exit_code: int, ends_with: int, last: str
) -> None:
    failing = SWEEP.replace('print("sweeping"', f"sys.exit({exit_code}) #")
    (fake.folder / "harness" / "sweep.py").write_text(failing)
    code, output, _ = fake.run("report")
    assert (code, output[-1]) == (ends_with, last)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (["reprot"], "unknown command 'reprot'"),
        (["report", "--fast"], "unknown argument '--fast'"),
        (["report", "--profile"], "--profile needs a value"),
        (["report", "--profile", "quik"], "unknown profile 'quik'"),
        (["report", "--run", "../elsewhere"], "run name '../elsewhere'"),
        (["test", "fast"], "unknown suite 'fast'"),
        (["install", "everything"], "install what?"),
        ([], "usage:"),
    ],
)
def test_a_wrong_call_is_refused(
    fake: Fake, arguments: list[str], message: str
) -> None:
    code, output, errors = fake.run(*arguments)
    assert (code, output) == (2, [])
    assert message in errors
    assert fake.called("apt-get", "cmake") == []


def test_a_system_without_dpkg_is_told_what_to_do(fake: Fake) -> None:
    script = (fake.folder / "reproduce").read_text()
    script = script.replace("command -v dpkg-query", "command -v dpkg-missing")
    (fake.folder / "reproduce").write_text(script)
    code, _, errors = fake.run("report")
    assert code == 2
    assert "not a Debian system" in errors and "docker/README.md" in errors


def test_the_package_list_has_no_package_twice() -> None:
    lines = (ROOT / "docker" / "packages.txt").read_text().splitlines()
    packages = [line for line in lines if line and not line.startswith("#")]
    assert len(packages) == len(set(packages)) > 20


def a_run(fake: Fake) -> Path:
    folder = fake.folder / "results" / "theirs"
    folder.mkdir(parents=True)
    (folder / "machine.json").write_text("{}")
    return folder


def test_a_report_of_given_results_neither_builds_nor_measures(fake: Fake) -> None:
    folder = a_run(fake)
    (fake.folder / "analysis" / "__main__.py").write_text(
        "import sys; print(sys.argv[-1] + '/report/index.html')"
    )
    fake.missing("g++", "weasyprint", "qemu-user")
    code, output, errors = fake.run("report", "--from", "results/theirs")
    assert (code, errors) == (0, "")
    assert output[-1] == f"{folder}/report/index.html"
    assert fake.called("cmake") == []
    assert not any("sweeping" in line for line in output)
    # Of what is missing, only what a report needs.
    assert fake.called("apt-get")[-1].endswith("--no-install-recommends weasyprint")


def test_from_ends_with_what_the_report_ends_with(fake: Fake) -> None:
    a_run(fake)
    (fake.folder / "analysis" / "__main__.py").write_text("raise SystemExit(2)")
    assert fake.run("report", "--from", "results/theirs")[0] == 2


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("--from",), "--from wants the folder"),
        (("--from", "results/none"), "there is no folder 'results/none'"),
        (("--from", "docker"), "'docker' is not the folder of a run"),
        (("--from", "docker", "--profile", "full"), "--from wants the folder"),
        (("--profile", "full", "--from", "docker"), "--from DIR stands alone"),
    ],
)
def test_from_refuses_what_is_no_run(
    fake: Fake, arguments: tuple[str, ...], says: str
) -> None:
    code, output, errors = fake.run("report", *arguments)
    assert (code, output) == (2, [])
    assert says in errors
    assert fake.called("apt-get", "cmake") == []
