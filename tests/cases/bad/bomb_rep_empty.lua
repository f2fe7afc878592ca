-- expect: bad/bomb_rep_empty\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
string.rep("", 1e17)
