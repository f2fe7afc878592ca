-- expect: bad/taper_kind_changes\.lua:3: the section changes its kind along the beam: "rectangle .*" at 0, "circle .*" at 1; it must stay the same but for its sizes$
local hobe = require "hobe"
hobe.taper(function(at)
  return at < 0.5 and hobe.square{ side = 0.1 } or hobe.circle{ radius = 0.05 }
end)
