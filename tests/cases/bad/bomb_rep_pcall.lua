-- expect: bad/bomb_rep_pcall\.lua:3: the script needs more than 16 MB of memory \(--memory-limit MB allows more\)$
-- args: --memory-limit 16
while true do pcall(string.rep, "x", 1e9) end
