"""From tables to the page, the PDF and the README: exhibits, columns, words."""
