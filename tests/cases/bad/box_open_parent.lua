-- expect: bad/box_open_parent\.lua:2: .*inside the output folder.*got "../../etc/passwd"$
io.open("../../etc/passwd")
