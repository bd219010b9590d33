# uniform
