load scripts.'/extension.gp'
