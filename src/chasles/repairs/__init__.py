"""What is right in place of an equation that fails: edits, their modular test, their ranking, their proof."""
