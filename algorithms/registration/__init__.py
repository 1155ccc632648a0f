"""From unlabelled targets of scans to the transformation of each scan into the control frame."""
