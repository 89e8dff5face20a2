"""Runs: the program's answers, whole, quick, and left tidy."""

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

import pytest

import trilith

# Whoever runs the tests in the background may ignore Ctrl-C, which they and the program would inherit.
signal.signal(signal.SIGINT, signal.default_int_handler)

SECONDS = re.compile(r'"seconds":[-0-9.e]+')


def wall(**keys):
    return trilith.Wall(["111", "h11h"] * 2, (0.4, 0.2), 0.65, **keys)


def command_line(*arguments):
    done = subprocess.run([trilith.program(), *arguments], capture_output=True, text=True)
    return done.stdout


def test_every_built_in_case_answers_as_on_the_command_line():
    """Byte for byte but for seconds. TRILITH_ALL_METHODS=1 has those too that take long."""
    methods = ["macro-block", "associative", "sequential"]
    cases = trilith.library()
    if os.environ.get("TRILITH_ALL_METHODS"):
        methods += ["interval", "pushover"]
    assert len(cases) >= 79
    results = trilith.run(cases, methods)
    # Their files: a folder of the same name would win.
    names = [case._argument for case in cases]
    expected = command_line("run", *names, "--method", ",".join(methods), "--format", "json", "--states")
    assert SECONDS.sub("", results.text) == SECONDS.sub("", expected)
    assert [row.data for row in results] == json.loads(results.text)


def test_a_result_has_numbers_forces_and_words():
    results = trilith.run(wall(), ["interval", "pushover"], push="both")
    search, observed = results
    assert (search.method, search.status) == ("interval", "verified")
    assert observed.status == "bracketed" and observed.stated_error > 0
    assert search.lower <= search.upper and results["interval"] is search
    scene = search.scene
    assert search.forces.shape == (len(scene.classes), 3)
    assert search.velocities.shape == (len(scene.names), 3)
    # The forces hold the blocks at λ.
    residual = scene.equilibrium() @ search.forces.ravel() + scene.dead.ravel()
    residual += search.sides[0].lower * scene.live.ravel()
    assert abs(residual).max() < 1e-8 * abs(scene.dead).sum()
    assert str(results.answer).startswith("λ = ") and results.answer.lower == search.lower
    assert results.answer["tilt_degrees"] > 0
    assert "interval" in results._repr_html_() and "λ" in repr(results)
    for drawing in (results.draw(), search.draw(forces=True), wall().draw()):
        assert drawing._repr_svg_().startswith("<svg")


def test_pandas_gets_a_row_a_result():
    pytest.importorskip("pandas")
    table = trilith.run([wall(), wall()], ["associative"], head_joints="both").to_pandas()
    assert list(table["case"]) == ["wall", "wall@open", "wall-2", "wall-2@open"]
    assert (table["lower"] > 0).all()


def test_many_cases_run_at_once_and_tell_how_far_they_are(capsys):
    walls = [trilith.Wall(["11", "h1h"] * 2, (0.4, 0.2), 0.3 + 0.005 * k) for k in range(40)]
    results = trilith.run(walls, ["interval"], progress=True)
    assert [row.of for row in results] == walls and not results.partial
    assert results[walls[3]][0].lower == pytest.approx(0.315, abs=1e-6)
    assert "█" in capsys.readouterr().err


def test_a_bound_is_shown_as_it_grows(capsys):
    stretched = trilith.Wall(["1111", "h111h", "1111"], (4.0, 1.75), 1.2)
    result = trilith.run(stretched, ["bound"], progress=True, bound_gap=0.02)[0]
    said = capsys.readouterr().err
    shown = re.findall(r"pushed to the right: λ ≥ ([0-9.]+) proved, lowest state ([0-9.]+)", said)
    assert shown, said
    assert 0 < float(shown[0][0]) <= result.lower + 1e-6
    assert all(float(state) >= result.lower for _, state in shown)


def test_nothing_is_left_behind(tmp_path, monkeypatch):
    work, temporary = tmp_path / "work", tmp_path / "temporary"
    work.mkdir()
    temporary.mkdir()
    monkeypatch.chdir(work)
    monkeypatch.setenv("TMPDIR", str(temporary))
    monkeypatch.setattr(tempfile, "tempdir", str(temporary))
    trilith.run(wall(), ["associative", lambda scene: 0.5])
    trilith.template()
    wall().draw()
    assert not list(work.iterdir()) and not list(temporary.iterdir())


def test_a_call_costs_little_beside_the_program(tmp_path):
    case = wall()
    file = tmp_path / "wall.toml"
    file.write_text(case.text())
    trilith.run(case, ["associative"])

    def best(call):
        times = []
        for _ in range(15):
            began = time.perf_counter()
            call()
            times.append(time.perf_counter() - began)
        return sorted(times)[3]

    alone = best(lambda: command_line("run", str(file), "--method", "associative", "--format", "json"))
    whole = best(lambda: trilith.run(case, ["associative"]))
    print(f"a call takes {1e3 * whole:.1f} ms, the program alone {1e3 * alone:.1f} ms")
    assert whole - alone < 0.020


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_ctrl_c_keeps_what_is_finished():
    walls = [trilith.Wall(["111", "h11h"] * 4, (0.4, 0.2), 0.3 + 0.01 * k) for k in range(60)]

    def interrupt():
        time.sleep(5.0)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    results = trilith.run(walls, ["interval"])
    assert results.partial.startswith("PARTIAL: interrupted"), results.partial
    assert 1 <= len(results) < 60 and "PARTIAL" in repr(results)


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_ctrl_c_before_anything_is_finished_is_pythons_own():
    def interrupt():
        time.sleep(1.0)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        trilith.run(trilith.load("paper-3"), ["pushover"], accuracy="fine", head_joints="open")


@pytest.mark.skipif(os.name == "nt", reason="programs that are scripts")
def test_ctrl_c_is_not_swallowed_where_the_program_ends_as_ever(tmp_path, monkeypatch):
    path = tmp_path / "trilith"
    version = f'[ "$1" = --version ] && echo "trilith {trilith.__version__}" && exit 0'
    path.write_text(f"#!/bin/sh\n{version}\ntrap '' INT\ntouch {tmp_path}/began\nsleep 2\n")
    path.chmod(0o755)
    monkeypatch.setenv("TRILITH_PROGRAM", str(path))

    def interrupt():
        while not (tmp_path / "began").exists():
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        trilith.load("paper-3")


@pytest.mark.skipif(os.name == "nt", reason="programs that are scripts")
def test_a_program_that_is_not_what_it_should_be_is_told_of(tmp_path, monkeypatch):
    def script(text):
        path = tmp_path / f"trilith-{len(list(tmp_path.iterdir()))}"
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)
        monkeypatch.setenv("TRILITH_PROGRAM", str(path))

    version = f'[ "$1" = --version ] && echo "trilith {trilith.__version__}" && exit 0'
    for text, expected in [
        ('echo "trilith 0.0.9"', "version 0.0.9, and this module of"),
        ('echo "something else"', "not the program trilith"),
        (f"{version}\nkill -9 $$", "signal 9, mostly for want of memory"),
        (f"{version}\nkill -15 $$", "ended before it answered"),
        (f"{version}\necho oh >&2; exit 101", "exit status 101"),
    ]:
        script(text)
        with pytest.raises(trilith.ProgramError, match=expected):
            trilith.run(wall())
    monkeypatch.setenv("TRILITH_PROGRAM", str(tmp_path / "none"))
    with pytest.raises(trilith.ProgramError, match="cannot be run"):
        trilith.run(wall())


def test_a_missing_program_is_told_of(tmp_path, monkeypatch):
    import trilith._program as own

    monkeypatch.delenv("TRILITH_PROGRAM", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(own.sysconfig, "get_path", lambda *_: str(tmp_path))
    with pytest.raises(trilith.ProgramError, match="is missing: .* TRILITH_PROGRAM"):
        trilith.run(wall())


def test_versions_of_module_and_program_agree():
    assert command_line("--version").split() == ["trilith", trilith.__version__]
    assert sys.version_info >= (3, 9)
