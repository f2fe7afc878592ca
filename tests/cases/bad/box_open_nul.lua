-- expect: bad/box_open_nul\.lua:2: io.open: the file name must be one line of UTF-8 text
io.open("notes\0.txt", "w")
