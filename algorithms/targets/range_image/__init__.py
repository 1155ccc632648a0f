"""What a scanner saw from its station, as an image of ranges and intensities.

Public names: `range_image.RangeImage`, `range_image.image_of`; `station.Station`, `station.read_stations`;
`angular_step.angular_step`.
"""
