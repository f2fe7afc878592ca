-- expect: bad/box_getenv\.lua:2: os.getenv is not for case scripts \(hobe run --trust allows it\)$
print(os.getenv("HOME"))
