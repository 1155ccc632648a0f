"""Point clouds as files: formats, chunks, tiles, thinning."""
