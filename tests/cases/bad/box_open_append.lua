-- expect: bad/box_open_append\.lua:2: io.open: a case script opens files with "r" or "w", got "a"$
io.open("notes.txt", "a")
