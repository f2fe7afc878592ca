-- expect: bad/bomb_gmatch\.lua:3: the script spent more than 0.3 s in Lua itself \(--time-limit S allows more\)$
-- args: --time-limit 0.3
for word in ("a"):rep(50):gmatch(("a*"):rep(30) .. "b") do end
