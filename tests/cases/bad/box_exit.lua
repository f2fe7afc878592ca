-- expect: bad/box_exit\.lua:2: os.exit is not for case scripts \(hobe run --trust allows it\)$
os.exit(0)
