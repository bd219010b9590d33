print 'todo'
