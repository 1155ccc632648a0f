"""Reports: self-contained HTML pages with figures."""
