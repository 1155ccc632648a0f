"""What columns are called in English, German, French, Italian and Spanish."""

import re
import unicodedata
from collections.abc import Mapping

from .units import without_unit

Roles = Mapping[str, tuple[str, ...]]
"""The names of each role in the spelling of `simplified`, the most specific first."""

CLOUD: Roles = {
    "x": (
        *("x", "easting", "eastings", "east", "e", "points:0", "xcoordinate", "xcoord", "coordx"),
        *("rechtswert", "ostwert", "ost", "xkoordinate", "est", "coordonneex", "abscisse", "xest"),
        *("coordinatax", "este", "coordenadax", "xeast", "eastingx", "xeasting", "ecoord", "cartesianx"),
        *("xkoord", "rw"),
    ),
    "y": (
        *("y", "northing", "northings", "north", "n", "points:1", "ycoordinate", "ycoord", "coordy"),
        *("hochwert", "nordwert", "nord", "ykoordinate", "coordonneey", "ordonnee", "ynord"),
        *("coordinatay", "norte", "coordenaday", "ynorth", "northingy", "ynorthing", "ncoord", "cartesiany"),
        *("ykoord", "hw"),
    ),
    "z": (
        *("z", "elevation", "elev", "height", "altitude", "alt", "h", "points:2", "zcoordinate", "zcoord"),
        *("coordz", "hohe", "hoehe", "zkoordinate", "hauteur", "coordonneez", "quota", "altezza", "niveau"),
        *("altitudine", "coordinataz", "cota", "altura", "altitud", "elevacion", "coordenadaz", "zheight"),
        *(
            "heightz",
            "zaltitude",
            "zhohe",
            "zhoehe",
            "orthoheight",
            "elevationz",
            "zelevation",
            "reducedlevel",
            "rl",
        ),
        *("cartesianz", "zkoord"),
    ),
    "intensity": (
        *("intensity", "i", "reflectance", "reflectivity", "amplitude", "scalarintensity", "intensitat"),
        *("intensitaet", "intensite", "intensita", "intensidad", "scalarreflectance", "reflectanz"),
        *("reflection", "reflexion", "riflettanza", "reflectancia"),
    ),
    "red": ("r", "red", "rf", "rgb:0", "rot", "rouge", "rosso", "rojo", "colorred", "diffusered"),
    "green": ("g", "green", "gf", "rgb:1", "grun", "gruen", "vert", "verde", "colorgreen", "diffusegreen"),
    "blue": ("b", "blue", "bf", "rgb:2", "blau", "bleu", "blu", "azul", "colorblue", "diffuseblue"),
    "nx": ("nx", "normalx", "normalsx", "normals:0", "nor:normalx", "scalarnx", "xnormal"),
    "ny": ("ny", "normaly", "normalsy", "normals:1", "nor:normaly", "scalarny", "ynormal"),
    "nz": ("nz", "normalz", "normalsz", "normals:2", "nor:normalz", "scalarnz", "znormal"),
}
"""Of a cloud."""

POINTS: Roles = {
    **CLOUD,
    "name": (
        *("name", "pointname", "ptname", "label", "labelname", "pointlabel", "point", "pt", "punkt", "pkt"),
        *(
            "target",
            "targetid",
            "targetname",
            "targetno",
            "targetnumber",
            "targetlabel",
            "marker",
            "markerid",
        ),
        *("pointid", "ptid", "pointno", "pointnumber", "ptno", "ptnr", "punktnummer", "punktnr", "pktnr"),
        *("punktname", "punktid", "pktname", "pktnummer", "bezeichnung", "punktbezeichnung", "zielmarke"),
        *("nom", "nompoint", "nomdupoint", "numeropoint", "numerodupoint", "nopoint", "matricule", "repere"),
        *("nome", "nomepunto", "punto", "numeropunto", "idpunto", "codicepunto", "identificativo"),
        *("nombre", "nombrepunto", "numerodepunto", "nombredepunto", "identificador", "identifiant"),
        *("id", "nr", "no", "n°", "number", "nummer", "numero", "num", "localindex", "globalindex"),
    ),
    "sx": ("sx", "stdx", "sigmax", "sdx", "mx"),
    "sy": ("sy", "stdy", "sigmay", "sdy", "my"),
    "sz": ("sz", "stdz", "sigmaz", "sdz", "mz"),
    "rxy": ("rxy", "corrxy", "rhoxy"),
    "rxz": ("rxz", "corrxz", "rhoxz"),
    "ryz": ("ryz", "corryz", "rhoyz"),
}
"""Of a list of points, with the standard deviations and correlations of their coordinates."""

LENGTHS: Roles = {
    "id": (
        *("id", "detail", "detailid", "nr", "no", "n°", "number", "nummer", "numero", "num", "nom", "name"),
        *("bezeichnung", "identifiant", "identificador", "identificativo", "nombre", "nome"),
    ),
    "facade": ("facade", "fassade", "facciata", "fachada"),
    "width": ("width", "breite", "largeur", "larghezza", "ancho", "anchura"),
    "height": ("height", "hohe", "hoehe", "hauteur", "altezza", "alto", "altura"),
    "sill": (
        *("sill", "sillheight", "brustung", "bruestung", "brustungshohe", "bruestungshoehe", "allege"),
        *("davanzale", "antepecho", "alfeizar", "parapetto"),
    ),
    "dimension": ("dimension", "mass", "masse", "dimensione", "abmessung", "messgrosse", "mesure", "medida"),
    "length": ("length", "lange", "laenge", "longueur", "lunghezza", "longitud", "largo", "wert", "value"),
    "width_std": ("widthstd", "stdwidth"),
    "height_std": ("heightstd", "stdheight"),
}
"""Of a schedule of details, or of lengths measured by hand."""

DEGREES = {
    "lat",
    "latitude",
    "lon",
    "long",
    "longitude",
    "lng",
    "breitengrad",
    "langengrad",
    "laengengrad",
    "latitud",
}


def simplified(name: str) -> str:
    """Return a column's name in small letters, free of accents, units, blanks and marks.

    >>> simplified("Höhe [m]"), simplified("Pkt.-Nr."), simplified("scalar_Nx")
    ('hohe', 'pktnr', 'scalarnx')
    """
    letters = unicodedata.normalize("NFKD", without_unit(name).replace("ß", "ss"))
    return re.sub(
        r"[\s_.\-/'\"*]", "", "".join(letter for letter in letters if not unicodedata.combining(letter))
    )


def recognised(fields: list[str], roles: Roles) -> dict[str, int]:
    """Return the column of every role that the fields of a header name."""
    keys = [simplified(field) for field in fields]
    found: dict[str, int] = {}
    for role, aliases in roles.items():
        column = next((keys.index(alias) for alias in aliases if alias in keys), None)
        if column is not None:
            found[role] = column
    return found
