-- expect: bad/bomb_table_pcall\.lua:4: the script needs more than 16 MB of memory \(--memory-limit MB allows more\)$
-- args: --memory-limit 16
local t = {}
pcall(function() while true do t[#t + 1] = { #t } end end)
local swallowed = true
