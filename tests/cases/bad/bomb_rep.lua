-- expect: bad/bomb_rep\.lua:3: the script needs more than 16 MB of memory \(--memory-limit MB allows more\)$
-- args: --memory-limit 16
local s = ("x"):rep(1e9)
