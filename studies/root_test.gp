load scripts.'/style.gp'
