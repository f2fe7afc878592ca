-- expect: bad/box_loadlib\.lua:2: package.loadlib is not for case scripts \(hobe run --trust allows it\)$
package.loadlib("libc.so.6", "system")
