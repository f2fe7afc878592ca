-- expect: bad/box_lines\.lua:2: io.lines is not for case scripts \(hobe run --trust allows it\)$
for line in io.lines("/etc/passwd") do print(line) end
