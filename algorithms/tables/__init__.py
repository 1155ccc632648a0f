"""Tables as text, as programs, spreadsheets and people of several languages write them.

One reader for clouds, lists of points, schedules and lengths: encoding, separator, decimal sign, names of
columns, units.

Public names: `encoding.encoding_of`, `encoding.read_lines`, `dialect.Dialect`, `dialect.delimiter_and_width`,
`dialect.decimal_signs`, `header.read_preamble`, `header.Header`, `column_names.POINTS`,
`column_names.LENGTHS`, `column_names.simplified`, `units.factor_of`, `degrees.degree_warning`,
`remarks.unapplied_remarks`, `remarks.system_remark`, `named_table.read_named_table`, `spreadsheet.safe_cell`.
"""
