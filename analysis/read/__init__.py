"""The files of a run, checked, as typed objects and data frames."""
