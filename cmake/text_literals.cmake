# SPDX-License-Identifier: Apache-2.0
# text_literals(<file> <result>): the content of a file as C++ string literals, one after the other with a comma behind
# each. Literals have a least length that every compiler takes, so that long files are written in pieces.
set(text_literal_length 30000)

function(text_literals file result)
  set(text "")
  file(READ ${file} content)
  string(LENGTH "${content}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${content}" ${at} ${text_literal_length} piece)
    string(APPEND text "    R\"millwright(${piece})millwright\",\n")
    math(EXPR at "${at} + ${text_literal_length}")
  endwhile()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()
