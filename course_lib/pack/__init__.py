"""What ``make`` runs: the environment, the executed notebooks and the site."""

import sys

# nbformat imports jsonschema, which builds a parser of international web addresses if this package is installed. That
# takes a second in every process, and no notebook's format asks for it; without the package jsonschema goes on.
sys.modules.setdefault("rfc3987_syntax", None)
