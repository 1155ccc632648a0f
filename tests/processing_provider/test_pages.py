"""Pages of the results viewer."""

from pathlib import Path

import pytest
from ichnograph.processing_provider.pages import page_of_table, page_of_text


def test_a_schedule_is_shown_as_a_table(tmp_path):
    path = tmp_path / "schedule.csv"
    path.write_text('id,kind\n1,"opening, arched"\n2,<recess>\n', encoding="utf-8")

    page = page_of_table(path, "Schedule")
    assert page.count("<tr>") == 3
    assert "<th>id</th><th>kind</th>" in page
    assert "<td>opening, arched</td>" in page and "<td>&lt;recess&gt;</td>" in page
    assert path.as_uri() in page


def test_a_table_without_rows_is_an_empty_table(tmp_path):
    path = tmp_path / "schedule.csv"
    path.write_text("", encoding="utf-8")
    assert "<table>" in page_of_table(path, "Schedule")


def test_other_files_are_shown_as_they_are(tmp_path):
    path = tmp_path / "transforms.json"
    path.write_text('{"name": "a & b"}', encoding="utf-8")
    assert "{&quot;name&quot;: &quot;a &amp; b&quot;}" in page_of_text(path, "Transformations")


@pytest.mark.parametrize("desktop", [True, False])
def test_only_a_desktop_gets_the_page(run, monkeypatch, tmp_path, desktop):
    from ichnograph.processing_provider.parameters import destinations

    monkeypatch.setattr(destinations, "on_desktop", lambda: desktop)
    given = {"SCHEDULE": "id,width,height,sill\n1,1.2,1.5,0.9\n", "REFERENCE": "id,width\n1,1.19\n"}
    for name, content in given.items():
        (tmp_path / f"{name}.csv").write_text(content)
    files = {name: str(tmp_path / f"{name}.csv") for name in given}
    result = run("comparelengths", **files, TABLE=str(tmp_path / "table.csv"))

    assert ("TABLE_PAGE" in result) is desktop
    if desktop:
        assert "<td>1.19" in Path(result["TABLE_PAGE"]).read_text(encoding="utf-8")
