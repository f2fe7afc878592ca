-- expect: bad/box_execute\.lua:2: os.execute is not for case scripts \(hobe run --trust allows it\)$
os.execute("touch escaped")
