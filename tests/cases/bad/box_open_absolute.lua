-- expect: bad/box_open_absolute\.lua:2: .*inside the output folder.*got "/etc/passwd"$
io.open("/etc/passwd")
