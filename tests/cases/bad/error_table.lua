-- expect: bad/error_table\.lua: the script raised an error that is a table, not a text$
error({})
