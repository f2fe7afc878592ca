-- expect: bad/error_two_lines\.lua:2: one two$
error("one\ntwo")
