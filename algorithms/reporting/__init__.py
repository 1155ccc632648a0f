"""Reports: self-contained HTML pages, rendered by jinja2, with figures drawn by matplotlib.

Only `numbers` may be imported at any time. The other modules need jinja2 or matplotlib, so import them,
and what imports them, where a report is written.

Public names: `numbers.number`, `numbers.round_step`, `numbers.MISSING`; `page.write_page`;
`figures.canvas`, `figures.svg`; `charts.bar_chart`, `charts.histogram`, `charts.curve_chart`; `maps.Map`;
`pictures.embedded`, `pictures.grey`, `pictures.shrunk`.
"""
