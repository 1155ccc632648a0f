"""Lines from all over a file show what its beginning lacks."""

from ichnograph.algorithms.clouds.formats.line_samples import sample_lines
from ichnograph.algorithms.clouds.settings import TextSettings

SETTINGS = TextSettings(sample_bytes=100, runs=4)


def test_a_small_file_is_sampled_as_a_whole(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("head\n" + "1 2 3\n" * 10)
    (lines,) = sample_lines(path, "utf-8", 5, SETTINGS)
    assert [line for line in lines if line.strip()] == ["1 2 3\n"] * 10


def test_a_large_file_is_sampled_in_runs_of_whole_lines(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("".join(f"{number:05}\n" for number in range(1000)))
    runs = list(sample_lines(path, "utf-8", settings=SETTINGS))
    assert len(runs) == 4
    assert all(len(line) == 6 for lines in runs for line in lines)
    assert int(runs[0][0]) < 20
    assert int(runs[-1][-1]) > 980
