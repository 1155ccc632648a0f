"""The density image of a cloud, and the heights that come with it (paper, section 2.1)."""
