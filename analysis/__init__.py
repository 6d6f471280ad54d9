"""From the JSON files of a run to its tables, its charts and its report.

The way data takes: load → tables → charts, prose → page. Nothing here links
to anything in C++; the files in results/<run>/ are all that it reads.
"""
