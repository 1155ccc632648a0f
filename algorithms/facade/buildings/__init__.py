"""The facades of whole buildings and streets: found in a cloud, listed, and chosen.

Public names: `facades.find_facades`, `facades.Facade`, `choice.choose`, `choice.along`,
`choice.around`, `settings.BuildingSettings`.
"""
