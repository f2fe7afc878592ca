-- expect: bad/syntax\.lua:4: '\}' expected \(to close '\{' at line 2\) near 'y'$
local t = {
  x = 1
  y = 2
}
