local hobe = require "hobe"
local L, P = 120, hobe.param("P", 1)
local n = hobe.param("n", 10)
local element = hobe.param("element", "MGD30")
local function leg(name, from, to)
  return hobe.beam{
    name = name, element = element, elements = n,
    section = hobe.rectangle{ width = 3, height = 2 }, material = { E = 720, nu = hobe.param("nu", 0.3) },
    from = from, to = to,
  }
end
local scene = hobe.scene{
  leg("column", {0, 0, 0}, {0, 0, L}), leg("beam", {0, 0, L}, {L, 0, L}),
  hobe.join{ "column", "beam", at = {1, 0} },
  hobe.support{ "column", at = 0, kind = "revolute", axis = {0, 1, 0}, name = "foot" },
  hobe.support{ "beam", at = 1, kind = "revolute", axis = {0, 1, 0}, name = "wall" },
  hobe.force{ "beam", at = 1/5, value = {0, 0, -P} },
}
local t=os.clock()
local path = hobe.path(scene, { arc = hobe.param("arc", 0.5), steps=400, to=hobe.param("to",2.2) })
print(#path, path.iterations)
for i,p in ipairs(path) do local u=p:displacement("beam",1/5); if i%5==0 or i==#path then print(i,p.load,u[1],u[3],u[2],p.negative) end end
for k,l in ipairs(path.limit_points) do print(k,l.load,l.after) end
for k,l in ipairs(path.bifurcations or {}) do print("bif",k,l.text) end
for _,e in ipairs{"foot","wall"} do local q=path[#path]:reaction(e); print(table.concat(q.force," "), table.concat(q.moment," ")) end
