-- Does in Neovim what a user does with a room in which something does not hold, by the functions that docs/editors.md names,
-- and writes what there was to see into the file that SEEN names, as JSON. The set-up is init.lua, which is loaded before.
local seen = { version = tostring(vim.version().major) .. '.' .. vim.version().minor }
local room = vim.api.nvim_get_current_buf()

local function finish(trouble)
  seen.trouble = trouble
  vim.fn.writefile({ vim.fn.json_encode(seen) }, os.getenv('SEEN'))
  vim.cmd('qall!')
end

-- Waits until a question has an answer.
local function wait(what, ask)
  local answer
  local there = vim.wait(60000, function()
    answer = ask()
    return answer ~= nil and answer ~= false
  end, 20)
  if not there then error('waited in vain for ' .. what) end
  return answer
end

-- Puts the cursor behind the first occurrence of a text in the room.
local function go(text)
  for number, line in ipairs(vim.api.nvim_buf_get_lines(room, 0, -1, false)) do
    local _, column = line:find(text, 1, true)
    if column then return vim.api.nvim_win_set_cursor(0, { number, column - 1 }) end
  end
  error('there is no ' .. text)
end

local function marked()
  local out = {}
  for _, d in ipairs(vim.diagnostic.get(room)) do
    local line = vim.api.nvim_buf_get_lines(room, d.lnum, d.lnum + 1, false)[1]
    local code = d.code or (d.user_data and d.user_data.lsp and d.user_data.lsp.code)
    table.insert(out, { line = d.lnum + 1, text = line:sub(d.col + 1, d.end_col), code = code, message = d.message })
  end
  return out
end

local function has(code)
  for _, d in ipairs(marked()) do
    if d.code == code then return true end
  end
  return false
end

-- What is shown in a window over the text; it goes with the next movement of the cursor.
local floating
local open = vim.lsp.util.open_floating_preview
vim.lsp.util.open_floating_preview = function(lines, ...)
  floating = table.concat(lines, '\n')
  return open(lines, ...)
end

local function text_of(name)
  local buffer = vim.fn.bufnr(name)
  return buffer > 0 and table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), '\n') or nil
end

local function main()
  wait('a squiggle', function() return has('V0101') end)
  seen.marked = marked()

  go('object bed')
  vim.lsp.buf.hover()
  seen.hover = wait('a hover', function() return floating end)

  go('assert gap')
  vim.ui.select = function(items, options, choose)
    seen.menu = {}
    for index, item in ipairs(items) do
      local title = options.format_item(item)
      table.insert(seen.menu, title)
      if title == 'Repair this constraint' then vim.schedule(function() choose(item, index) end) end
    end
  end
  vim.lsp.buf.code_action()
  wait('the repair', function() return not has('V0101') end)
  seen.repaired = marked()

  go('object bed')
  vim.lsp.buf.rename('couch')
  wait('the new name', function()
    local layout = text_of('room.layout.json')
    return layout and layout:find('"couch"', 1, true) and text_of('room.scene'):find('object couch', 1, true)
  end)
  wait('a verdict on it', function() return not has('E0201') and not has('E0507') end)
  vim.cmd('silent wall')

  -- The cursor rests: the server is told where.
  local highlighted
  vim.lsp.handlers['textDocument/documentHighlight'] = function(_, result) highlighted = result end
  go('object couch')
  vim.cmd('doautocmd CursorHold')
  seen.followed = #wait('what the cursor is on', function() return highlighted end)

  if os.getenv('VIEWER') then
    local said
    vim.lsp.handlers['window/showMessage'] = function(_, result) said = result.message end
    vim.lsp.buf.execute_command({ command = 'scenelang.view' })
    seen.shown = wait('the room beside', function() return said end)
  end
end

vim.schedule(function()
  local good, trouble = pcall(main)
  finish(not good and tostring(trouble) or nil)
end)
