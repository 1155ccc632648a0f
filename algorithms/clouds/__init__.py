"""Point clouds as files: formats, chunks, tiles, thinning, writing.

Public names: `cloud.open_cloud`, `cloud.open_sources`, `cloud.clouds_in`, `cloud.Cloud`, `source.Source`,
`source.Chunk`, `settings.CloudSettings`; the rooms `formats`, `tiles`, `thinning` and `writing` list theirs.
"""
