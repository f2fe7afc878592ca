-- expect: bad/bomb_move\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
table.move({}, 1, 1e15, 2)
