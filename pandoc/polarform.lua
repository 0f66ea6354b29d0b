--[[ A filter for Pandoc and Quarto: the results of queries of polarform in a document.

  pandoc notes.md --lua-filter polarform.lua -o notes.html

Queries are blocks of the class polarform (their options as attributes), formulas with {{ … }} in them, and code of the
class polarform among words: `f(0, 1)`{.polarform}. They run in the order of the document in one session, by the program
polarform (or what the variable POLARFORM of the environment names). ]]

local program = os.getenv("POLARFORM") or "polarform"

-- The pieces of the document that are queries, as Markdown that `polarform weave` reads.
local pieces = {}

-- A line that parts pieces, and that no piece contains.
local function mark(number)
  return "polarform-piece-" .. number .. "-of-this-page"
end

local function add(text)
  pieces[#pieces + 1] = text
end

local function has_query(math)
  return math.text:find("{{", 1, true) ~= nil
end

local function is_query(element)
  return element.classes:includes("polarform")
end

local function fence(text)
  local longest = 2
  for run in text:gmatch("`+") do
    longest = math.max(longest, #run)
  end
  return string.rep("`", longest + 1)
end

local function options(block)
  local words = {}
  for _, class in ipairs(block.classes) do
    if class ~= "polarform" then
      words[#words + 1] = class
    end
  end
  for name, value in pairs(block.attributes) do
    words[#words + 1] = name .. "=" .. value
  end
  table.sort(words)
  return table.concat(words, " ")
end

local collect = {
  traverse = "topdown",
  CodeBlock = function(block)
    if is_query(block) then
      local signs = fence(block.text)
      add(signs .. "polarform " .. options(block) .. "\n" .. block.text .. "\n" .. signs)
    end
  end,
  Math = function(math)
    if has_query(math) then
      -- Blanks beside the signs would make it no formula.
      add("$" .. math.text:match("^%s*(.-)%s*$") .. "$")
    end
  end,
  Code = function(code)
    if is_query(code) then
      add("{{ " .. code.text .. " }}")
    end
  end,
}

-- What `polarform weave` makes of the pieces; an error ends pandoc with the message of the program.
local function woven()
  local page = { "\n" }
  for number, piece in ipairs(pieces) do
    page[#page + 1] = mark(number) .. "\n\n" .. piece .. "\n\n"
  end
  local page_text = table.concat(page)
  local out = pandoc.pipe(program, { "weave", "-", "-o", "-" }, page_text)
  local results, from = {}, 1
  for number = 1, #pieces do
    local _, start = out:find(mark(number), from, true)
    if not start then
      error("polarform: the result of query " .. number .. " was not found")
    end
    local stop = out:find(mark(number + 1), start, true) or #out + 1
    results[number] = out:sub(start + 1, stop - 1)
    from = stop
  end
  return results
end

-- A picture goes into the text of a page of HTML; elsewhere it is a file of the document.
local function picture(svg)
  if FORMAT:match("html") or FORMAT:match("revealjs") or FORMAT:match("epub") then
    return pandoc.RawBlock("html", svg)
  end
  local name = "polarform-" .. pandoc.utils.sha1(svg):sub(1, 12) .. ".svg"
  pandoc.mediabag.insert(name, "image/svg+xml", svg)
  local title = svg:match("<title>(.-)</title>") or ""
  return pandoc.Para({ pandoc.Image({ pandoc.Str(title) }, name) })
end

local function blocks(text)
  local parts, from = pandoc.List(), 1
  while true do
    local start = text:find("<svg", from, true)
    local _, stop = text:find("</svg>", start or #text, true)
    parts:extend(pandoc.read(text:sub(from, (start or #text + 1) - 1), "markdown").blocks)
    if not start then
      return parts
    end
    parts:insert(picture(text:sub(start, stop)))
    from = stop + 1
  end
end

-- The text of the formula that stands in a result.
local function formula(text)
  local found
  pandoc.walk_block(pandoc.Div(pandoc.read(text, "markdown").blocks), {
    Math = function(math)
      found = found or math.text
    end,
  })
  return found
end

function Pandoc(doc)
  doc:walk(collect)
  if #pieces == 0 then
    return nil
  end
  local results, number = woven(), 0
  local function next_result()
    number = number + 1
    return results[number]
  end
  return doc:walk({
    traverse = "topdown",
    CodeBlock = function(block)
      if is_query(block) then
        return blocks(next_result()), false
      end
    end,
    Math = function(math)
      if has_query(math) then
        return pandoc.Math(math.mathtype, formula(next_result()) or math.text)
      end
    end,
    Code = function(code)
      if is_query(code) then
        return pandoc.utils.blocks_to_inlines(pandoc.read(next_result(), "markdown").blocks), false
      end
    end,
  })
end
