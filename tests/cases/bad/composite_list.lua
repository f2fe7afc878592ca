-- expect: bad/composite_list\.lua:4: composite: unknown key "parts"; it holds parts \{section =, at =, material =\}$
local hobe = require "hobe"
local part = {section = hobe.square{side = 0.1}, material = {E = 210e9, nu = 0.3}}
local section = hobe.composite{ parts = {part} }
