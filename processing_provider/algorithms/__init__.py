"""The algorithms of the toolbox, one class a module."""
