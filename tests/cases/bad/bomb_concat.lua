-- expect: bad/bomb_concat\.lua:4: the script needs more than 16 MB of memory \(--memory-limit MB allows more\)$
-- args: --memory-limit 16
local s = "x"
while true do s = s .. s end
