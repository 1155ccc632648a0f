"""Lists of lengths, in the layouts that schedules and people write."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.evaluation.length_lists import read_reference, read_schedule


@pytest.fixture
def write(tmp_path):
    def write(content):
        (tmp_path / "list.csv").write_text(content, encoding="utf-8")
        return tmp_path / "list.csv"

    return write


def test_a_schedule_has_lengths_with_standard_deviations_where_they_are_known(write):
    path = write("id,kind,width,height,sill,width_std,height_std\n1,recess,1.2,1.5,,0.002,\n")
    found = read_schedule(path)

    assert found.source == str(path)
    assert [item[:3] for item in found.lengths] == [("1", "width", 1.2), ("1", "height", 1.5)]
    np.testing.assert_array_equal([item.std for item in found.lengths], [0.002, np.nan])


@pytest.mark.parametrize(
    "content",
    [
        "id,dimension,length\n1,width,1.2\n2,Height,2.0\n",
        "ID; Width; Height\n1; 1,2;\n2; ; 2,0\n",
        "\ufeffid,width,height\r\n1,1.2,\r\n\r\n2,,2.0\r\n",
        "id\twidth\theight\n1\t1.2\t\n2\t\t2.0\n",
        "sep=;\nNr;Breite;Höhe\n1;1,2;\n2;;2,0\n;;\n",
        'id,width,height\n1,"1,2",\n2,,"2,0"\n',
        "id,width [mm],height [cm]\n1,1200,\n2,,200\n",
        "Numéro;Mesure;Longueur\n1;Largeur;1,2\n2;Hauteur;2,0\n",
        "Número;Ancho;Alto;Nota\n1;1,2;;\n2;;2,0;x\n",
        "id;larghezza;altezza\n;[m];[m]\n1;1,2;\n2;;2,0\n",
    ],
    ids=[
        *("long", "semicolons and decimal commas", "spreadsheet", "tabs", "German", "quoted", "millimetres"),
        *("French", "Spanish", "Italian, with a line of units"),
    ],
)
def test_a_reference_may_be_written_in_several_ways(write, content):
    found = read_reference(write(content)).lengths

    assert [item[:3] for item in found] == [("1", "width", 1.2), ("2", "height", 2.0)]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252"])
def test_the_encoding_changes_nothing(tmp_path, encoding):
    path = tmp_path / "tape.csv"
    path.write_bytes("Nr;Breite;Höhe;Bemerkung\n1;0,9;1,6;Küche\n".encode(encoding))

    assert [item[:3] for item in read_reference(path).lengths] == [("1", "width", 0.9), ("1", "height", 1.6)]


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("colour,width\n1,1.2\n", "has no column id; add or rename it"),
        ("id,breadth\n1,1.2\n", "has no lengths; name its columns id, width, height and sill, or"),
        ("id,width\n1,wide\n", "Line 2 of .*: the width wide is not a length in metres"),
        ("id,width\n1,inf\n", "Line 2 of .*: the width inf is not a length in metres"),
        ("id,dimension,length\n1,depth,1.2\n", "Line 2 of .*: the dimension must be .*, not depth"),
        ("", "has no column id"),
        ("id,width,height\n1,0,900,1,600\n", "Line 2 of .* has 5 fields where the header names 3 columns"),
        ("id,width,height\n1,0.9\n", "Line 2 of .* has 2 fields where the header names 3 columns"),
        ("id,width [ft]\n1,3\n", "gives lengths in ft; convert them to metres"),
    ],
)
def test_a_bad_reference_is_refused_by_name(write, content, sentence):
    with pytest.raises(InputError, match=sentence):
        read_reference(write(content))


def test_the_details_of_several_facades_may_have_the_same_ids(write):
    schedule = read_schedule(write("facade,id,width,height\n1,7,1.2,1.5\n2,7,1.3,1.6\n")).lengths
    reference = read_reference(write("Façade;id;width\n2;7;1,3\n")).lengths

    assert [item.id for item in schedule] == [*["7 of facade 1"] * 2, *["7 of facade 2"] * 2]
    assert reference == (("7 of facade 2", "width", 1.3, pytest.approx(np.nan, nan_ok=True)),)


def test_a_length_that_a_facade_lists_twice_is_refused(write):
    with pytest.raises(InputError, match=r"Line 3 of .* the width of 7 of facade 2 is listed twice"):
        read_schedule(write("facade,id,width,height\n2,7,1.2,1.5\n2,7,1.3,1.6\n"))


def test_a_standard_deviation_may_be_0_but_not_less(write):
    found = read_schedule(write("id,width,height,width_std\n1,1.2,1.5,0.0\n")).lengths
    assert found[0].std == 0
    with pytest.raises(InputError, match=r"the width_std -0\.1 is not a standard deviation"):
        read_schedule(write("id,width,height,width_std\n1,1.2,1.5,-0.1\n"))


def test_a_schedule_without_heights_is_refused(write):
    with pytest.raises(InputError, match="has no column height"):
        read_schedule(write("id,width\n1,1.2\n"))


def test_a_file_that_is_missing_is_named(tmp_path):
    with pytest.raises(InputError, match=r"none\.csv cannot be read"):
        read_schedule(tmp_path / "none.csv")


@pytest.mark.parametrize("value", ["0", "-0.9"])
def test_a_length_is_positive_but_a_sill_may_lie_below_the_ground(write, value):
    with pytest.raises(InputError, match=f"Line 2 of .*: the width {value} is not a length"):
        read_reference(write(f"id,width\n1,{value}\n"))
    assert read_reference(write(f"id,sill\n1,{value}\n")).lengths[0].length == float(value)


def test_a_schedule_that_lists_a_length_twice_is_refused(write):
    with pytest.raises(InputError, match=r"Line 3 of .*: the width of 1 is listed twice"):
        read_schedule(write("id,width,height\n1,0.9,1.6\n1,0.8,\n"))


def test_a_remark_that_states_the_unit_is_honoured_and_said(write):
    found = read_reference(write("# units: mm\nid,width\n1,900\n"))
    assert found.lengths[0].length == 0.9
    assert "gives lengths in mm" in found.warnings[0]


def test_what_can_be_read_in_two_ways_is_asked_for(write):
    with pytest.raises(InputError, match="has width and Breite for one length; rename"):
        read_reference(write("id;width;Breite\n1;0.9;0.8\n"))
    with pytest.raises(InputError, match="has no id; add"):
        read_reference(write("id;width\n1;0.9\n;0.8\n"))
