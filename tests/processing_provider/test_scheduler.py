"""SCHEDULER: the clouds are worked on by a cluster, or refused in a sentence."""

import pytest


def test_a_cluster_writes_the_same_file(run, room, cluster, tmp_path):
    here, there = tmp_path / "here.laz", tmp_path / "there.laz"
    run("thincloud", INPUT=[room], SPACING=0.2, OUTPUT=str(here))
    found = run("thincloud", INPUT=[room], SPACING=0.2, SCHEDULER=cluster.address, OUTPUT=str(there))
    assert 0 < found["POINTS_OUT"] < found["POINTS_IN"]
    assert there.read_bytes() == here.read_bytes()


@pytest.mark.parametrize(
    ("algorithm", "output", "name"),
    [
        ("thincloud", "OUTPUT", "out.laz"),
        ("densityimage", "DENSITY", "out.tif"),
        ("siteplan", "WALLS", "out.shp"),
    ],
)
def test_what_is_no_address_is_refused(run, room, cluster, tmp_path, algorithm, output, name):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException, match=r"SCHEDULER.* nonsense is not an address; write it"):
        run(algorithm, INPUT=[room], SCHEDULER="nonsense", **{output: str(tmp_path / name)})
    assert not list(tmp_path.iterdir())
