"""Columns are recognised by their names in five languages."""

import pytest
from ichnograph.algorithms.tables.column_names import LENGTHS, POINTS, recognised, simplified


@pytest.mark.parametrize(
    ("name", "plain"),
    [("Höhe [m]", "hohe"), ("Pkt.-Nr.", "pktnr"), ("Point No.", "pointno"), ("Élévation", "elevation")],
)
def test_accents_units_blanks_and_marks_do_not_matter(name, plain):
    assert simplified(name) == plain


@pytest.mark.parametrize(
    "header",
    [
        "Point ID;Easting;Northing;Elevation",
        "Punkt-Nr.;Rechtswert;Hochwert;Höhe",
        "Punktnummer;Ost;Nord;Hoehe",
        "N° ;Est;Nord;Altitude",
        "Matricule;Coordonnée X;Coordonnée Y;Hauteur",
        "Nome punto;Est;Nord;Quota",
        "Número;Este;Norte;Elevación",
        "Nombre;X;Y;Cota",
    ],
)
def test_names_and_coordinates_of_points(header):
    assert recognised(header.split(";"), POINTS) == {"name": 0, "x": 1, "y": 2, "z": 3}


@pytest.mark.parametrize(
    "header",
    ["id,width,height,sill", "Nr,Breite,Höhe,Brüstung", "N°,Largeur,Hauteur,Allège",
     "Nome,Larghezza,Altezza,Davanzale", "Nombre,Ancho,Alto,Antepecho"],
)  # fmt: skip
def test_lengths_of_details(header):
    assert recognised(header.split(","), LENGTHS) == {"id": 0, "width": 1, "height": 2, "sill": 3}
