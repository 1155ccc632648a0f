"""From the density image to regions of wall (paper, section 2.2)."""
