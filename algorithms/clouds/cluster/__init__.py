"""Clouds sorted and worked on by the workers of a Dask cluster, with the same bytes as on one computer.

Dask is imported only when a cluster is asked for.

Public names: `sorting.sorter_at`, `sorting.sort_on_cluster`, `connection.Cluster`, `connection.connected`,
`remote_tiles.RemoteTiles`.
"""
