"""The simulation of a registration before the fieldwork."""
