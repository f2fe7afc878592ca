-- expect: bad/box_popen\.lua:2: io.popen is not for case scripts \(hobe run --trust allows it\)$
io.popen("id")
