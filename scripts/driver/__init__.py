"""Starts the simulated robot with a navigation stack, drives it to a goal and
measures how it did."""
