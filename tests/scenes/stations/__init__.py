"""Stations of a scanner among targets and things that look like targets, cast ray by ray.

Public names: `caster.Panel`, `caster.Ball`, `caster.Rod`, `caster.Scanner`, `caster.cast`; `layout.Station`,
`layout.target_station`, `layout.cluttered_station`.
"""
