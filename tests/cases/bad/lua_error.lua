-- expect: bad/lua_error\.lua:3: .*attempt to index a nil value \(local 'scene'\)$
local scene
print(scene.unknowns)
